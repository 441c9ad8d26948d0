"""The period of a timer from a parameter, with a callback that looks at what will be set and changes the timer."""

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from scenario import P, begin, end_after, mark, say


class Paced(Node):
    def __init__(self):
        super().__init__("parameters_period")
        self.declare_parameter("periods", 1.0)
        self.add_on_set_parameters_callback(self.check)
        begin()
        self.timer = self.create_timer(self.get_parameter("periods").value * P, self.timer_callback)
        self.calls = 0

    def check(self, parameters):
        for parameter in parameters:
            if parameter.name == "periods":
                if parameter.value <= 0:
                    return SetParametersResult(successful=False, reason="periods must be above 0")
                self.timer.timer_period_ns = int(parameter.value * P * 1e9)
        return SetParametersResult(successful=True)

    def timer_callback(self):
        mark("tick")
        self.calls += 1
        if self.calls in (2, 3):
            value = {2: -1.0, 3: 2.0}[self.calls]
            (result,) = self.set_parameters([Parameter("periods", value=value)])
            say(result.successful, result.reason, self.get_parameter("periods").value)


rclpy.init()
node = Paced()
end_after(8.4)
rclpy.spin(node)
