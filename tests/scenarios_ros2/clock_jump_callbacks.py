"""Callbacks for jumps of ROS time: what calls them, in which order, and what one that raises keeps from being done."""

from rclpy.clock import Clock, ClockChange, JumpHandle, JumpThreshold, ROSClock, TimeJump
from rclpy.duration import Duration
from rclpy.time import Time
from scenario import attempt, say

clock = ROSClock()


def threshold(forward=None, backward=None, **more):
    lengths = [None if length is None else Duration(seconds=length) for length in (forward, backward)]
    return JumpThreshold(min_forward=lengths[0], min_backward=lengths[1], **more)


def watch(name, limit):
    """Print what the clock tells before and after; on the system's clock, how long after tells nothing."""

    def before():
        say("   before", name, clock.now().nanoseconds if clock.ros_time_is_active else "the system's")

    def after(jump):
        change = jump.clock_change
        told = clock.now().nanoseconds if clock.ros_time_is_active else "the system's"
        say("   after ", name, change, repr(change), f"{change}", int(change), jump.delta, told)
        say("         ", change == ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED == change)

    return clock.create_jump_callback(limit, pre_callback=before, post_callback=after)


def tell(seconds):
    say("tell", seconds)
    clock.set_ros_time_override(Time(seconds=seconds, clock_type=clock.clock_type))


def switch(on):
    say("switch", on)
    clock._set_ros_time_is_active(on)


names = {**globals(), "none": lambda: None, "kinds": (JumpHandle, TimeJump)}
for text in (
    "JumpThreshold()",
    "threshold(on_clock_change=False)",
    "threshold(forward=0)",
    "threshold(backward=0)",
    "threshold(backward=1)",
    "JumpThreshold(min_forward=3, min_backward=None)",
    "threshold(1).min_forward, threshold(1).min_backward, threshold(1).on_clock_change",
    "clock.create_jump_callback(threshold())",
    "clock.create_jump_callback(threshold(), pre_callback=3)",
    "clock.create_jump_callback(threshold(), post_callback=3)",
    "clock.create_jump_callback(3, pre_callback=none)",
    "clock.create_jump_callback(threshold(), none)",
    "JumpHandle(clock=clock, threshold=threshold(), pre_callback=None, post_callback=3)",
    "TimeJump(2, Duration())",
    "TimeJump(ClockChange.ROS_TIME_ACTIVATED, Duration(seconds=1)).delta",
    "list(ClockChange)",
):
    attempt(text, names)

changes = watch("change", threshold())
forward = watch("forward", threshold(1, on_clock_change=False))
backward = watch("backward", threshold(backward=-1))
tell(1)
switch(True)
switch(True)
for seconds in (1.5, 2.5, 4, 3.5, 2.5, 2.5, 0.25):
    tell(seconds)
switch(False)
switch(False)
tell(100)
changes.unregister()
changes.unregister()
switch(True)
with watch("in a with", threshold(1)) as handle:
    tell(200)
    say(type(handle).__name__)
forward.unregister()
backward.unregister()
tell(300)


def refuse(*args):
    raise ValueError(f"refused {len(args)}")


for callback in ("pre_callback", "post_callback"):
    first = watch("first", threshold(1))
    second = clock.create_jump_callback(threshold(1), **{callback: refuse})
    third = watch("third", threshold(1))
    attempt("tell(500)", names)
    say(clock.now())
    tell(0)
    for handle in (first, second, third):
        handle.unregister()
for handle in (Clock().create_jump_callback(threshold(), pre_callback=refuse),):
    say(type(handle).__name__, handle.unregister())
