"""Tells who wants to know that ROS time has jumped: forward, back, or to another source."""

import rclpy
from rclpy.clock import Clock, ClockChange, ClockType, JumpThreshold, ROSClock, TimeJump
from rclpy.duration import Duration
from rclpy.time import Time


def at(ns):
    clock.set_ros_time_override(Time(nanoseconds=ns, clock_type=ClockType.ROS_TIME))


def told():
    return clock.now().nanoseconds if clock.ros_time_is_active else "system"


def watch(name, **threshold):
    return clock.create_jump_callback(
        JumpThreshold(**threshold),
        pre_callback=lambda: print(name, "before", told()),
        post_callback=lambda jump: print(name, "after", jump.clock_change, jump.delta.nanoseconds, told()),
    )


def attempt(make):
    try:
        print(type(make()).__name__)
    except Exception as error:
        print(f"{type(error).__name__}: {error}")


def fail():
    raise RuntimeError("in a callback")


rclpy.init()
clock = ROSClock()
forward = watch("forward", min_forward=Duration(seconds=1), min_backward=None)
back = watch("back", min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=False)
at(5)
clock._set_ros_time_is_active(True)
clock._set_ros_time_is_active(True)
for time in (10**9, 2 * 10**9, 10**9 + 1, 1, 0, 3 * 10**9):
    at(time)
back.unregister()
back.unregister()
at(1)
clock._set_ros_time_is_active(False)

EITHER = JumpThreshold(min_forward=None, min_backward=None)
with clock.create_jump_callback(EITHER, pre_callback=lambda: print("within the block")):
    clock._set_ros_time_is_active(True)
clock._set_ros_time_is_active(False)
print(ClockChange.ROS_TIME_ACTIVATED == 2, TimeJump(ClockChange.ROS_TIME_ACTIVATED, Duration()).delta)
for make in (
    lambda: JumpThreshold(min_forward=Duration(), min_backward=None),
    lambda: JumpThreshold(min_forward=None, min_backward=Duration(seconds=1)),
    lambda: JumpThreshold(min_forward=None, min_backward=None, on_clock_change=False),
    lambda: clock.create_jump_callback(EITHER),
    lambda: clock.create_jump_callback(EITHER, pre_callback=1),
    lambda: clock.create_jump_callback(EITHER, post_callback=1),
    lambda: TimeJump(1, Duration()),
    lambda: Clock(clock_type=ClockType.STEADY_TIME).create_jump_callback(EITHER, pre_callback=print),
):
    attempt(make)

failing = clock.create_jump_callback(EITHER, pre_callback=fail)
never = clock.create_jump_callback(EITHER, pre_callback=lambda: print("not called"))
attempt(lambda: clock._set_ros_time_is_active(True))
print(clock.ros_time_is_active)
rclpy.shutdown()
