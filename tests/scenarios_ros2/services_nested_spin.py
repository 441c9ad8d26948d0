"""spin_until_future_complete in a callback, in a ReentrantCallbackGroup; another executor takes the node away."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, end_after, mark, say
from std_srvs.srv import Trigger


def ask():
    mark("asks")
    future = client.call_async(Trigger.Request())
    if len(calls) < 2:
        rclpy.spin_until_future_complete(node, future, timeout_sec=P)
    else:
        rclpy.spin_until_future_complete(node, future, SingleThreadedExecutor(), timeout_sec=P)
    calls.append(future.done())
    say(calls)


rclpy.init()
node = rclpy.create_node("services_nested_spin")
group = ReentrantCallbackGroup()
calls = []
node.create_service(Trigger, "work", lambda request, response: response, callback_group=group)
client = node.create_client(Trigger, "work", callback_group=group)
begin()
node.create_timer(P, ask)
end_after(4.7)
rclpy.spin(node)
