"""A node's own names, which rclpy's Node and Executor do not have."""

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from scenario import begin
from std_msgs.msg import String


class Own(Node):
    _destroyed = "own"

    def __init__(self):
        self._check = self._set = self._refused = self._other_type = "own"
        self._before_set = self._on_set = self._after_set = None
        super().__init__("names_own")
        self._arguments = self._name = self._namespace = self._full_name = None
        self._executor = self._clock_subscription = "own"
        self._count = 0
        self.nudge = "own"
        self.declare_parameter("speed", 1.0)
        self.add_on_set_parameters_callback(self._on_use_sim_time)
        self.publisher = self.create_publisher(String, "own", 1)
        self.create_subscription(String, "own", self._tell_time, 1)
        self.timer = self.create_timer(0.2, self._declare)

    def _on_use_sim_time(self, parameters):
        from rcl_interfaces.msg import SetParametersResult

        print([parameter.name for parameter in parameters])
        return SetParametersResult(successful=True)

    def _declare(self):
        self._count += 1
        self.set_parameters([Parameter("speed", value=float(self._count))])
        self.publisher.publish(self._prepare())

    def _prepare(self):
        return String(data=f"{self.get_fully_qualified_name()} {self._count} {self.resolve_topic_name('~/own')}")

    def _tell_time(self, message):
        print(message.data, self.count_publishers("own"), self.get_parameter("speed").value)
        if self._count == 3:
            self._destroy(self.timer)

    def _destroy(self, timer):
        print(self.destroy_timer(timer), self._destroyed, self._executor, self.nudge, self._check)
        rclpy.shutdown()

    def _use_sim_time(self): ...
    def _listen_to_clock(self): ...
    def _resolve(self): ...


class OwnExecutor(SingleThreadedExecutor):
    _calls = _called_at = _round = _round_args = _gate = _waits = _waited_until = _triggered = None

    def _call(self): ...
    def _gather(self): ...
    def _new_round(self): ...
    def _spin_once(self): ...
    def _task(self): ...
    def _wait(self): ...
    def nudge(self): ...


rclpy.init()
executor = OwnExecutor()
executor.add_node(Own())
begin()
try:
    executor.spin()
except ExternalShutdownException:
    print("the end")
