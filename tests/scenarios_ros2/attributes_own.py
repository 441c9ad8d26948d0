"""What a node may set on its publishers and the like, which have slots for nothing: names that a node would choose."""

from concurrent.futures import ThreadPoolExecutor

import rclpy
from rclpy.action import ActionClient, ActionServer
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

NAMES = (
    "messages peers events nudge kept node end made tell join part take receive policies world state ready ends lock "
    "sent early count last next period source expected due stamp coming hear miss watchers flows changes ns timers "
    "nodes arguments valid left logs pending goals results feedback status expiry started ended name data value"
).split()


def attempt(what, call):
    try:
        print(what, "->", call())
    except Exception as error:
        print(what, "->", type(error).__name__, str(error))


rclpy.init()
node = rclpy.create_node("node")
heard = []
made = {
    "subscription": node.create_subscription(String, "topic", lambda message: heard.append(message.data), 10),
    "publisher": node.create_publisher(String, "topic", 10),
    "service": node.create_service(Trigger, "service", lambda request, response: response),
    "client": node.create_client(Trigger, "service"),
    "timer": node.create_timer(0.1, lambda: heard.append("tick")),
    "guard": node.create_guard_condition(lambda: heard.append("guard")),
    "rate": node.create_rate(10.0),
    "server": ActionServer(node, Fibonacci, "action", lambda goal: (goal.succeed(), Fibonacci.Result())[1]),
    "action client": ActionClient(node, Fibonacci, "action"),
    "clock": node.get_clock(),
    "context": node.context,
    "logger": node.get_logger(),
    "group": node.default_callback_group,
    "node": node,
}
for what, each in made.items():
    refused = []
    for name in NAMES:
        for full in (name, f"_{name}"):
            try:
                if not hasattr(each, full):
                    setattr(each, full, [])
            except AttributeError:
                refused.append(full)
    print(what, refused)
for what in ("node", "publisher", "subscription", "client", "service", "timer", "guard", "clock"):
    attempt(what, lambda: setattr(made[what], "handle", None))
attempt("executor", lambda: setattr(node, "executor", ThreadPoolExecutor(2)))
made["publisher"].publish(String(data="heard"))
made["guard"].trigger()
future = made["client"].call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future)
print(future.result())
goal = made["action client"].send_goal_async(Fibonacci.Goal())
rclpy.spin_until_future_complete(node, goal)
print(goal.result().accepted)
rclpy.spin_once(node)
rclpy.spin_once(node)
print(sorted({*heard} - {"tick"}), node.get_node_names())
node.destroy_node()
