"""The services by which the levels of a node's loggers are read and set, if it offers them."""

import rclpy
from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from scenario import say


def ask(kind, name, **fields):
    client = node.create_client(kind, f"logger_services/{name}")
    future = client.call_async(kind.Request(**fields))
    rclpy.spin_until_future_complete(node, future, timeout_sec=2)
    say(name, future.result())


rclpy.init()
node = rclpy.create_node("logger_services", enable_logger_service=True)
say([name for name, _ in node.get_service_names_and_types() if "logger_levels" in name])
ask(GetLoggerLevels, "get_logger_levels", names=["logger_services", "nobody"])
changes = [LoggerLevel(name="logger_services", level=40), LoggerLevel(name="free", level=10)]
ask(SetLoggerLevels, "set_logger_levels", levels=[*changes, LoggerLevel(name="bad", level=7)])
ask(GetLoggerLevels, "get_logger_levels", names=["logger_services", "free", "bad"])
node.get_logger().info("not said")
node.get_logger().error("said")
say(rclpy.logging.get_logger_level("logger_services"), rclpy.logging.get_logger_level("nobody"))
root = rclpy.logging._root_logger
say(repr(root.name), root.get_effective_level(), root.get_child("of_root").name)
rclpy.logging.clear_config()
say(node.get_logger().get_effective_level())
node.get_logger().info("said again")
plain = rclpy.create_node("plain")
say([name for name, _ in plain.get_service_names_and_types_by_node("plain", "/") if "logger_levels" in name])
rclpy.shutdown()
