"""Two nodes of one process, talker and listener, in one executor."""

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from scenario import P, begin, end_after, mark
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.count = 0
        self.timer = self.create_timer(P, self.talk)

    def talk(self):
        mark("talk")
        message = String()
        message.data = f"Hello: {self.count}"
        self.publisher.publish(message)
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.count += 1


class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.subscription = self.create_subscription(String, "chatter", self.listen, 10)

    def listen(self, message):
        mark("listen")
        self.get_logger().info(f'I heard: "{message.data}"')


rclpy.init()
listener = Listener()
begin()
talker = Talker()
executor = SingleThreadedExecutor()
executor.add_node(talker)
executor.add_node(listener)
end_after(4.5)
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
