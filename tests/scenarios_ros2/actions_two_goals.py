"""Two goals at the same time: on two threads in a Reentrant group they overlap, by default they do not."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import arg, begin, block, end_after, mark
from test_msgs.action import Fibonacci


def execute(goal_handle):
    mark(f"begins_{goal_handle.request.order}")
    block(1)
    mark(f"ends_{goal_handle.request.order}")
    goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_two_goals")
group = ReentrantCallbackGroup() if arg("reentrant") else MutuallyExclusiveCallbackGroup()
server = ActionServer(node, Fibonacci, "fibonacci", execute, callback_group=group)
client = ActionClient(node, Fibonacci, "fibonacci", callback_group=ReentrantCallbackGroup())
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
client.send_goal_async(Fibonacci.Goal(order=1))
client.send_goal_async(Fibonacci.Goal(order=2))
end_after(3.5)
executor.spin()
