"""The tutorial's client and server, as classes, in two executors of two threads."""

import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from scenario import begin, mark, say
from test_msgs.srv import BasicTypes


class Server(Node):
    def __init__(self):
        super().__init__("server")
        self.service = self.create_service(BasicTypes, "double", self.answer)

    def answer(self, request, response):
        response.int64_value = 2 * request.int64_value
        self.get_logger().info(f"Incoming request: {request.int64_value}")
        return response


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.client = self.create_client(BasicTypes, "double")
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("service not available, waiting again...")
        self.request = BasicTypes.Request()

    def ask(self, number):
        self.request.int64_value = number
        return self.client.call_async(self.request)


rclpy.init()
server = Server()
asker = Asker()
executor = SingleThreadedExecutor()
executor.add_node(server)
thread = threading.Thread(target=executor.spin, daemon=True)
thread.start()
begin()
for number in range(3):
    future = asker.ask(number)
    rclpy.spin_until_future_complete(asker, future)
    say(future.result().int64_value)
mark("answered")
executor.shutdown()
thread.join()
rclpy.shutdown()
