"""What a managed node still does once it is destroyed, and once its context has ended."""

import rclpy
from rclpy.lifecycle import LifecycleNode
from scenario import attempt, say

rclpy.init()
first, second = LifecycleNode("first"), LifecycleNode("second")
first.trigger_configure()
first.destroy_node()
names = {"first": first, "second": second}
attempt("first.trigger_activate()", names)
attempt("first.get_name()", names)
attempt("[service.service_name for service in first.services]", names)
say(first._state_machine.current_state, first._state_machine.initialized)
rclpy.shutdown()
attempt("second.trigger_configure()", names)
say(second._state_machine.current_state)
attempt("second.trigger_shutdown()", names)
attempt("LifecycleNode('third')", {"LifecycleNode": LifecycleNode})
