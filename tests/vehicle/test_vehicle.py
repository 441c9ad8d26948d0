"""The vehicle: how it moves, what its nodes publish and take, and what a run shows of it."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import pytest

from rosspin import plots, simulate, start
from rosspin.plots.pictures import alternative
from rosspin.vehicle import ros1, ros2
from rosspin.vehicle.drawn import drawn
from rosspin.vehicle.drives import NODE, Drive
from rosspin.vehicle.physics import AHEAD, EDGE, FASTEST, START, Vehicle, line, nearest, point

VEHICLES = [pytest.param(ros2.vehicle, id="ROS 2"), pytest.param(ros1.vehicle, id="ROS 1")]


def follower2(period: float) -> None:
    """Steer by what the sensor has said last."""
    import rclpy  # type: ignore[import-not-found]
    from geometry_msgs.msg import Twist, Vector3
    from std_msgs.msg import Float32

    rclpy.init()
    node = rclpy.create_node("follower")
    publisher = node.create_publisher(Twist, "cmd_vel", 10)
    seen = [0.0]

    def tick() -> None:
        publisher.publish(Twist(linear=Vector3(x=2.0), angular=Vector3(z=8.0 * seen[-1])))

    node.create_subscription(Float32, "line", lambda message: seen.append(message.data), 10)
    node.create_timer(period, tick)
    rclpy.spin(node)


def follower1(period: float) -> None:
    """The same in ROS 1."""
    import rospy  # type: ignore[import-not-found]
    from geometry_msgs.msg import Twist, Vector3
    from std_msgs.msg import Float32

    rospy.init_node("follower")
    publisher = rospy.Publisher("cmd_vel", Twist, queue_size=10)
    seen = [0.0]

    def tick(event: object) -> None:
        publisher.publish(Twist(Vector3(2.0, 0, 0), Vector3(0, 0, 8.0 * seen[-1])))

    rospy.Subscriber("line", Float32, lambda message: seen.append(message.data))
    rospy.Timer(rospy.Duration(period), tick)
    rospy.spin()


def driven(period: float, ros: int = 2, **vehicle: tuple[float, float]) -> Drive:
    follower, node = ((follower1, ros1.vehicle), (follower2, ros2.vehicle))[ros - 1]
    run = simulate([partial(follower, period), partial(node, **vehicle)], 8.0)
    return Drive.of(run.messages)


# --- how it moves -----------------------------------------------------------------------------------------------------


def test_it_drives_along_the_arc_that_it_was_told() -> None:
    vehicle = Vehicle()
    vehicle.tell(1.0, 0.5)
    vehicle.move(1.0)
    vehicle.move(4.0)
    heading = START.heading
    assert vehicle.place.heading == pytest.approx(heading + 2.0)
    assert vehicle.place.x == pytest.approx(2.0 * (math.sin(heading + 2.0) - math.sin(heading)))
    assert vehicle.place.y == pytest.approx(2.0 * (math.cos(heading) - math.cos(heading + 2.0)))


def test_it_stands_still_until_it_is_told_something() -> None:
    vehicle = Vehicle()
    vehicle.move(10.0)
    assert vehicle.place == START and vehicle.deviation == 0.0


@pytest.mark.parametrize(("told", "driven"), [(9.0, FASTEST), (-9.0, -FASTEST), (math.nan, 0.0), (math.inf, 0.0)])
def test_what_it_cannot_do_it_does_not_do(told: float, driven: float) -> None:
    vehicle = Vehicle()
    vehicle.tell(told, told)
    assert vehicle.speed == driven and abs(vehicle.turn) <= 9.0 and math.isfinite(vehicle.turn)


def test_its_sensor_sees_how_far_to_the_left_the_line_is() -> None:
    """On the line and heading along it, the sensor is already outside of the first bend, which is to the right."""
    vehicle = Vehicle()
    assert -0.1 < vehicle.offset < 0.0
    vehicle.place = vehicle.place._replace(heading=START.heading - 0.3)
    assert vehicle.offset == pytest.approx(AHEAD * math.sin(0.3), abs=0.05)
    vehicle.place = vehicle.place._replace(heading=START.heading + 0.3)
    assert vehicle.offset == pytest.approx(-AHEAD * math.sin(0.3), abs=0.07)


def test_the_line_is_a_sine_whose_points_are_a_centimetre_apart() -> None:
    points = line(30.0)
    assert all(abs(y - 1.2 * math.sin(math.tau * x / 7)) < 1e-9 for x, y in points)
    assert all(math.dist(a, b) == pytest.approx(0.01, rel=0.01) for a, b in zip(points, points[1:], strict=False))


def test_nothing_is_nearer_than_its_nearest_point() -> None:
    assert nearest(-5.0, -5.0, 3) == 0
    number = nearest(3.0, 2.0, 0)
    assert all(math.dist((3.0, 2.0), point(number)) <= math.dist((3.0, 2.0), each) for each in line(7.0))


# --- its nodes --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("vehicle", VEHICLES)
def test_its_steering_stays_what_was_sent_last(vehicle: Callable[[], None]) -> None:
    with start(vehicle) as node:
        node.publish("/cmd_vel", linear={"x": 1.0}, angular={"z": 0.5})
        node.advance(4.0)
        assert node.messages("/pose")[-1].message.theta == pytest.approx(START.heading + 2.0, abs=1e-6)
        node.publish("/cmd_vel")
        node.advance(0.05)
        place = node.messages("/pose")[-1].message
        node.advance(2.0)
        last = node.messages("/pose")[-1].message
        assert (place.x, place.y) == (last.x, last.y)


@pytest.mark.parametrize("vehicle", VEHICLES)
def test_it_senses_20_times_a_second_and_takes_4_pictures(vehicle: Callable[[], None]) -> None:
    with start(vehicle) as node:
        node.advance(2.0)
        for topic, period in (("/line", 0.05), ("/pose", 0.05), ("/picture", 0.25)):
            times = [message.time for message in node.messages(topic)]
            assert times == pytest.approx([period * n for n in range(1, round(2 / period) + 1)])
        assert [message.message.data for message in node.messages("/picture")] == list(range(1, 9))


@pytest.mark.parametrize("vehicle", VEHICLES)
def test_a_silent_sensor_says_nothing(vehicle: Callable[..., None]) -> None:
    with start(partial(vehicle, silent=(1.0, 2.0))) as node:
        node.advance(3.0)
        times = [round(message.time, 3) for message in node.messages("/line")]
        assert 0.95 in times and 2.0 in times and not [time for time in times if 1.0 <= time < 2.0]
        assert len(node.messages("/pose")) == 60


@pytest.mark.parametrize("ros", [1, 2])
def test_steered_often_enough_it_keeps_to_its_line(ros: int) -> None:
    for period in (0.05, 0.1, 0.25):
        assert driven(period, ros).worst.off < EDGE
    for period in (0.4, 0.5, 1.0):
        assert driven(period, ros).worst.off > 2 * EDGE


def test_both_roses_drive_the_same_way() -> None:
    one, other = (driven(0.1, ros) for ros in (1, 2))
    assert one.worst.off == pytest.approx(other.worst.off, abs=0.01)
    assert one.way - other.way == pytest.approx(0.2, abs=0.01)  # in ROS 2 nodes have to find each other first


def test_the_joystick_stops_it_and_the_other_node_goes_on() -> None:
    run = simulate([partial(follower2, 0.05), ros2.vehicle, ros2.joystick], 7.0)
    sent = [command for command in Drive.of(run.messages).commands if command.node == "/joystick"]
    assert [command.time for command in sent] == pytest.approx([3.25 + n / 4 for n in range(8)])
    assert not any(command.speed or command.turn for command in sent)


# --- what a run shows -------------------------------------------------------------------------------------------------


def test_a_drive_says_how_far_off_whose_commands_and_how_many() -> None:
    words = driven(0.5).words
    assert words.startswith("The vehicle drives 15.0 m in 8 s and leaves its line by 1.4 m, at 4.8 s.")
    assert words.endswith("Commands: 16 from /follower.")
    assert "keeps to its line: at most 11 cm off" in driven(0.05).words


def test_a_vehicle_that_nobody_steers_stands_still() -> None:
    drive = Drive.of(simulate(ros2.vehicle, 1.0).messages)
    assert drive.way == 0.0 and drive.words.endswith("Commands: none.")


def test_only_the_vehicle_says_where_it_is() -> None:
    def liar() -> None:
        import rclpy
        from geometry_msgs.msg import Pose2D

        rclpy.init()
        node = rclpy.create_node("liar")
        publisher = node.create_publisher(Pose2D, "pose", 10)
        node.create_timer(0.1, lambda: publisher.publish(Pose2D(x=9.0)))
        rclpy.spin(node)

    drive = Drive.of(simulate([liar, ros2.vehicle], 1.0).messages)
    assert NODE == "/vehicle" and {spot.x for spot in drive.spots} == {0.0}


def test_the_picture_is_described_from_the_run() -> None:
    run = simulate([partial(follower2, 0.5), ros2.vehicle], 8.0)
    figure = plots.drive(run)
    said = alternative(figure)
    assert said.startswith(Drive.of(run.messages).words) and "Shown is" not in said
    assert "Deviation from the line: at most 1.42 m, at 4.75 s." in said
    assert "/follower tick: 16 ticks" in said and "/follower /cmd_vel: 16 ticks" in said and "sense" not in said
    ways = [list(each.get_xdata()) for each in figure.axes[0].lines]  # type: ignore[arg-type]
    assert [spot.x for spot in Drive.of(run.messages).spots] in ways


@pytest.mark.parametrize("seconds", [2.0, 8.0])
def test_the_end_of_the_road_is_in_the_picture(seconds: float) -> None:
    """In a page and in matplotlib: the road is half a metre wide, and its end is round."""
    run = simulate([partial(follower2, 0.1), ros2.vehicle], seconds)
    _, box, road, *_ = drawn(Drive.of(run.messages), [], seconds)
    left, _, width, _ = map(float, box.split())
    ax = plots.drive(run).axes[0]
    assert 0.25 < left + width - float(road.rpartition("L")[2].split()[0]) < 0.5
    assert 0.25 < ax.get_xlim()[1] - ax.lines[0].get_path().get_extents().x1 < 0.5


def test_without_a_vehicle_there_is_no_picture() -> None:
    with pytest.raises(ValueError, match="no vehicle says where it is"):
        plots.drive(simulate(partial(follower2, 0.5), 1.0))
