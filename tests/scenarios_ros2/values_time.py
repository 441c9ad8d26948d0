"""Times: made, compared, added, subtracted, and what goes wrong."""

from rclpy.clock import ClockType
from rclpy.duration import Duration, Infinite
from rclpy.time import Time
from scenario import attempt

names = {"Time": Time, "Duration": Duration, "ClockType": ClockType, "Infinite": Infinite}
for text in """
Time()
Time(seconds=1, nanoseconds=500)
Time(seconds=1.5)
Time(seconds=0.1).nanoseconds
Time(nanoseconds=1.9)
Time(seconds=-1)
Time(nanoseconds=-1)
Time(seconds=1e12)
Time(seconds='1')
Time(5)
Time(seconds=12, nanoseconds=345678901).seconds_nanoseconds()
Time(seconds=2, clock_type=ClockType.STEADY_TIME)
Time(clock_type=5)
Time(seconds=2).clock_type
str(Time(seconds=2))
Time(seconds=2) + Duration(seconds=1)
Duration(seconds=1) + Time(seconds=2)
Time(seconds=2) + 1
Time(seconds=2) + Time(seconds=1)
Time(seconds=2) - Time(seconds=1)
Time(seconds=1) - Time(seconds=2)
Time(seconds=2) - Duration(seconds=1)
Time(seconds=1) - Duration(seconds=2)
Time(seconds=2) - 1
Time(seconds=2) - Time(seconds=1, clock_type=ClockType.ROS_TIME)
Time(seconds=2) == Time(nanoseconds=2 * 10**9)
Time(seconds=2) == Time(seconds=2, clock_type=ClockType.ROS_TIME)
Time(seconds=2) == 2
Time(seconds=2) != 2
Time(seconds=2) < Time(seconds=3)
Time(seconds=2) >= Time(seconds=3)
Time(seconds=2) < 3
Time(seconds=2) < Time(seconds=3, clock_type=ClockType.ROS_TIME)
hash(Time(seconds=2)) == hash(Time(seconds=2))
Time(seconds=2, nanoseconds=3).to_msg()
Time.from_msg(Time(seconds=2, nanoseconds=3).to_msg())
Time.from_msg(Time(seconds=2, nanoseconds=3).to_msg(), clock_type=ClockType.SYSTEM_TIME)
Time.from_msg(5)
Time(seconds=2**63 / 1e9)
""".strip().splitlines():
    attempt(text, names)
