import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.create_timer(0.5, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
