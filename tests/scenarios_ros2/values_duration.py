"""Durations: made, compared, and what goes wrong."""

from rclpy.duration import Duration, Infinite
from scenario import attempt

names = {"Duration": Duration, "Infinite": Infinite}
for text in """
Duration()
Duration(seconds=1, nanoseconds=5)
Duration(seconds=-1.5)
Duration(seconds=0.1).nanoseconds
Duration(nanoseconds=1.9)
Duration(seconds=1e12)
Duration(5)
str(Duration(seconds=2))
Duration(seconds=2) + Duration(seconds=1)
Duration(seconds=2) - Duration(seconds=1)
Duration(seconds=2) * 2
-Duration(seconds=2)
Duration(seconds=2) == Duration(nanoseconds=2 * 10**9)
Duration(seconds=2) == 2
Duration(seconds=2) != 2
Duration(seconds=2) < Duration(seconds=3)
Duration(seconds=2) >= Duration(seconds=3)
Duration(seconds=2) < 3
hash(Duration(seconds=2)) == hash(Duration(seconds=2))
Duration(seconds=2, nanoseconds=3).to_msg()
Duration(seconds=-0.5).to_msg()
Duration.from_msg(Duration(seconds=2, nanoseconds=3).to_msg())
Duration.from_msg(5)
Infinite
str(Infinite)
""".strip().splitlines():
    attempt(text, names)
