"""rostopic hz, compared with the real one."""

from __future__ import annotations

import random
import subprocess
from collections.abc import Callable

from rosspin import Message, rospy
from rosspin.measures import rostopic_hz, topic_ticks
from tests.helpers.seeds import SEED


def test_rostopic_hz_prints_what_the_real_one_prints(require: Callable[[str], None]) -> None:
    """The same times through the real class, whose clock says them one after the other."""
    require("ros1")
    draw = random.Random(SEED)
    cases = []
    for _ in range(40):
        time, times = draw.uniform(0.1, 5), []
        for _ in range(draw.randint(0, 12)):
            times.append(time)
            time += draw.choice((0.5, 0.02, draw.uniform(0, 2)))
        cases.append((times, draw.choice((-1, 2, 3, 5, 100))))
    code = f"""
import rospy, rostopic
for times, window in {cases!r}:
    hz = rostopic.ROSTopicHz(window)
    for time in times:
        rospy.get_rostime = lambda: rospy.Time.from_sec(time)
        hz.callback_hz(None)
    hz.print_hz()
"""
    real = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=True).stdout
    ours = []
    for times, window in cases:
        messages = [Message("/a", "/n", rospy.Time.from_sec(time).to_sec(), None) for time in times]
        ours.append(rostopic_hz(topic_ticks(messages, "/a"), *([window] if window > 0 else [])))
    assert real == "".join(text + "\n" for text in ours)
