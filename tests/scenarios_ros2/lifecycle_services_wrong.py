"""A transition that the state does not have, asked for by its number, ends the spin of the managed node."""

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from rclpy.lifecycle import LifecycleNode
from scenario import say

rclpy.init()
node = LifecycleNode("managed")
client = node.create_client(ChangeState, "~/change_state")
client.wait_for_service()
future = client.call_async(ChangeState.Request(transition=Transition(id=Transition.TRANSITION_ACTIVATE)))
try:
    rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
except Exception as error:
    say(type(error).__name__, error)
say(future.done(), node._state_machine.current_state)
rclpy.shutdown()
