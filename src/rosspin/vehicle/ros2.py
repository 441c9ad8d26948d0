"""The vehicle as a node of ROS 2, and someone else who sends it commands."""

# mypy: disable-error-code="import-not-found"

from __future__ import annotations

from .physics import Vehicle

__all__ = ["joystick", "vehicle"]


def vehicle(silent: tuple[float, float] = (0.0, 0.0)) -> None:
    """Be a vehicle, which ``geometry_msgs/Twist`` on ``/cmd_vel`` steers.

    20 times a second it publishes on ``/line`` (std_msgs/Float32) how many metres to the left of its sensor the line
    is, and on ``/pose`` (geometry_msgs/Pose2D), for tests and pictures, where it is. Four times a second it takes a
    picture: ``/picture`` (std_msgs/UInt32) has the number. From the first time of ``silent`` (s) to the second, nothing
    comes from its sensor.
    """
    import rclpy
    from geometry_msgs.msg import Pose2D, Twist
    from rclpy.executors import ExternalShutdownException
    from std_msgs.msg import Float32, UInt32

    rclpy.init()
    node = rclpy.create_node("vehicle")
    line = node.create_publisher(Float32, "line", 10)
    pose = node.create_publisher(Pose2D, "pose", 10)
    picture = node.create_publisher(UInt32, "picture", 10)
    moving = Vehicle()
    pictures = 0
    start = node.get_clock().now()

    def now() -> float:
        return float((node.get_clock().now() - start).nanoseconds / 1e9)

    def command(message: Twist) -> None:
        moving.move(now())
        moving.tell(message.linear.x, message.angular.z)

    def sense() -> None:
        time = now()
        moving.move(time)
        if not silent[0] <= time < silent[1]:
            line.publish(Float32(data=moving.offset))
        x, y, heading = moving.place
        pose.publish(Pose2D(x=x, y=y, theta=heading))

    def take_picture() -> None:
        nonlocal pictures
        pictures += 1
        picture.publish(UInt32(data=pictures))

    node.create_subscription(Twist, "cmd_vel", command, 10)
    node.create_timer(0.05, sense)
    node.create_timer(0.25, take_picture)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


def joystick(pressed: tuple[float, float] = (3.0, 5.0), name: str = "joystick") -> None:
    """Be a joystick, with which someone stops the vehicle: from one time of ``pressed`` (s) to the other.

    It has a publisher of ``/cmd_vel`` only meanwhile, and sends a speed of 0 four times a second.
    """
    import time

    import rclpy
    from geometry_msgs.msg import Twist

    rclpy.init()
    node = rclpy.create_node(name)
    first, last = pressed
    try:
        time.sleep(first)
        publisher = node.create_publisher(Twist, "cmd_vel", 10)
        for _ in range(round((last - first) / 0.25)):
            time.sleep(0.25)
            publisher.publish(Twist())
        node.destroy_publisher(publisher)
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
