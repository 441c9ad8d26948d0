"""A managed node is a node: parameters, clients and timers of its own, and its services among the names."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import Node
from scenario import say


class Managed(Node):
    def __init__(self):
        super().__init__(
            "lifecycle_parameters", namespace="mrp", parameter_overrides=[rclpy.Parameter("rate", value=3)]
        )
        self.declare_parameter("rate", 1)

    def on_configure(self, state):
        self.get_logger().info(f"rate {self.get_parameter('rate').value}")
        self.timer = self.create_timer(0.01, self.tick)
        return super().on_configure(state)

    def tick(self):
        say("tick in", self._state_machine.current_state[1])
        self.timer.cancel()
        say(self.trigger_activate(), self.trigger_shutdown())
        rclpy.shutdown()


rclpy.init()
node = Managed()
say(node.get_fully_qualified_name(), node.get_logger().name)
node.trigger_configure()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    say("shut down")
