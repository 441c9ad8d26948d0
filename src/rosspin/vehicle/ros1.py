"""The vehicle as a node of ROS 1."""

# mypy: disable-error-code="import-not-found"

from __future__ import annotations

from .physics import Vehicle

__all__ = ["vehicle"]


def vehicle(silent: tuple[float, float] = (0.0, 0.0)) -> None:
    """Be a vehicle, as :func:`rosspin.vehicle.ros2.vehicle` is, with the same topics."""
    from threading import Lock

    import rospy
    from geometry_msgs.msg import Pose2D, Twist
    from std_msgs.msg import Float32, UInt32

    rospy.init_node("vehicle")
    line = rospy.Publisher("line", Float32, queue_size=10)
    pose = rospy.Publisher("pose", Pose2D, queue_size=10)
    picture = rospy.Publisher("picture", UInt32, queue_size=10)
    moving = Vehicle()
    pictures = 0
    start = rospy.get_time()
    lock = Lock()  # each timer and each topic has a thread of its own

    def command(message: Twist) -> None:
        with lock:
            moving.move(rospy.get_time() - start)
            moving.tell(message.linear.x, message.angular.z)

    def sense(event: object) -> None:
        with lock:
            time = rospy.get_time() - start
            moving.move(time)
            offset, (x, y, heading) = moving.offset, moving.place
        if not silent[0] <= time < silent[1]:
            line.publish(offset)
        pose.publish(x, y, heading)

    def take_picture(event: object) -> None:
        nonlocal pictures
        pictures += 1
        picture.publish(pictures)

    rospy.Subscriber("cmd_vel", Twist, command)
    rospy.Timer(rospy.Duration(0.05), sense)
    rospy.Timer(rospy.Duration(0.25), take_picture)
    rospy.spin()
