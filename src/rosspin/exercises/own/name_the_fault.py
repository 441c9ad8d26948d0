"""A loop that is slow and a timer that is slow look alike: a belief that this reveals."""

from __future__ import annotations

from ..predictions import chosen

TITLE = "Name the fault"
TEXT = """
**You need**: [the Rate node](rate.md), [what a slow callback costs](slow-callback.md) and [what drifts, and
why](drift.md).

Four nodes were meant to count twice a second. What went wrong in each?

- **A**: A frequency was given where a period belongs.
- **B**: A loop works, and then sleeps for a fixed time.
- **C**: One call of a timer took very long.
- **D**: Every call of a timer takes longer than the timer's period.
- **E**: An exception ended the thread of one timer.
- **F**: An exception ended the node.
- **G**: Two callbacks count in the same variable.

`log_1`:

```text
[INFO] [0.000000]: [SPINNER PY NODE] counter = 1
[INFO] [0.700000]: [SPINNER PY NODE] counter = 2
[INFO] [1.400000]: [SPINNER PY NODE] counter = 3
[INFO] [2.100000]: [SPINNER PY NODE] counter = 4
[INFO] [2.800000]: [SPINNER PY NODE] counter = 5
[INFO] [3.500000]: [SPINNER PY NODE] counter = 6
```

`log_2`:

```text
[INFO] [0.500000]: [SPINNER PY NODE] counter = 1
[INFO] [1.000000]: [HEARTBEAT] counter = 1
[INFO] [1.000000]: [SPINNER PY NODE] counter = 2
[INFO] [1.500000]: [SPINNER PY NODE] counter = 3
Exception in thread Thread-1:
Traceback (most recent call last):
  File "spinner_py_node.py", line 11, in timerCallback
    speed = speeds[counter]
IndexError: list index out of range
[INFO] [2.000000]: [HEARTBEAT] counter = 2
[INFO] [3.000000]: [HEARTBEAT] counter = 3
[INFO] [4.000000]: [HEARTBEAT] counter = 4
```

`log_3`:

```text
[INFO] [0.500000]: [SPINNER PY NODE] counter = 1
[INFO] [1.200000]: [SPINNER PY NODE] counter = 2
[INFO] [1.900000]: [SPINNER PY NODE] counter = 3
[INFO] [2.600000]: [SPINNER PY NODE] counter = 4
[INFO] [3.300000]: [SPINNER PY NODE] counter = 5
[INFO] [4.000000]: [SPINNER PY NODE] counter = 6
```

`log_4`:

```text
[INFO] [0.500000]: [SPINNER PY NODE] counter = 1
[INFO] [1.000000]: [SPINNER PY NODE] counter = 2
[INFO] [3.300000]: [SPINNER PY NODE] counter = 3
[INFO] [3.800000]: [SPINNER PY NODE] counter = 4
[INFO] [4.300000]: [SPINNER PY NODE] counter = 5
[INFO] [4.800000]: [SPINNER PY NODE] counter = 6
```
"""
REVEALS = "A loop that is slow and a timer that is slow look alike. A traceback means that the node has ended."

NODE = """
log_1 = ...
log_2 = ...
log_3 = ...
log_4 = ...
"""

HINTS = [
    "When is the first tick? A loop ticks immediately, a timer after one period.",
    "Are the distances between ticks all wrong, or just one?",
    "What still runs at the end? Each timer of rospy has a thread, and an exception ends only that.",
]
HINT = "Look at the first tick, at the distances between the ticks, and at what still runs at the end."

check = chosen(
    {
        "A": "Then the ticks would come at a steady 2 s, or 0.5 Hz: 1 divided by what was asked for, and never late.",
        "B": "A loop makes its first pass immediately; then each pass takes the work and the sleep together.",
        "C": "After one slow call the ticks are a period apart again.",
        "D": "A timer makes its first call after one period; from then on each call begins when the last one ends.",
        "E": "Then a traceback would name a thread, one counter would end there, and all else would continue.",
        "F": "Then a traceback would be the last thing on the console: nothing of the node still runs.",
        "G": "Then each number would be printed once, by one tag or by the other.",
    },
    log_1="B",
    log_2="E",
    log_3="D",
    log_4="C",
)

SOLUTION = """
# The first tick comes immediately: a loop. Each pass takes 0.7 s.
log_1 = "B"
# The heartbeat continues, so the node has not ended.
log_2 = "E"
# The first tick comes after a period: a timer. Its calls follow each other.
log_3 = "D"
# One gap; after it the ticks are a period apart again.
log_4 = "C"
"""

RIGHT = [
    {'"B"': '"b"', '"E"': "'e'"},
    {'"B"': '" B "'},
    {'"E"': '"E: an exception"', '"C"': '"**C**"'},
    {'"D"': '"(D)"'},
    {'"C"': '"C."'},
    {'log_1 = "B"': "", 'log_2 = "E"': 'log_1, log_2 = "BE"'},
]
WRONG = [
    ({'"B"': '"B, D"'}, "the answer is one of the letters A to G", 'Write it as `"A"`'),
    ({'"B"': '"A"'}, "`log_1`: it is not A", "1 divided by what was asked for"),
    ({'"B"': '"D"'}, "`log_1`: it is not D", "its first call after one period"),
    ({'"D"': '"B"'}, "`log_3`: it is not B", "makes its first pass immediately"),
    ({'"E"': '"F"'}, "`log_2`: it is not F", "nothing of the node still runs"),
    ({'"D"': '"C"'}, "`log_3`: it is not C", "a period apart again"),
    ({'"C"': '"E"'}, "`log_4`: it is not E", "a traceback would name a thread"),
    ({'"C"': '"G"'}, "`log_4`: it is not G", "each number would be printed once"),
    ({'"C"': '"C frequency"'}, "one of the letters A to G, not", 'Write it as `"A"`'),
    ({'"C"': '"H"'}, "one of the letters A to G, not `'H'`", 'Write it as `"A"`'),
    ({'log_4 = "C"': "class Mine(str):\n    pass\nlog_4 = Mine('C')"}, "not `Mine`", 'Write it as `"A"`'),
    ({'"C"': "3"}, "one of the letters A to G, not `3`", 'Write it as `"A"`'),
    ({'"C"': "C"}, "NameError: name 'C' is not defined", "A letter is a text."),
    ({'log_4 = "C"': ""}, "`log_4`: there is no answer yet", "Look at the first tick"),
]

# The node of each log, and how long it ran (s).
LOGS = {
    "log_1": (
        4,
        """import rospy

rospy.init_node("spinner_py_node")
counter = 0
while not rospy.is_shutdown():
    counter += 1
    rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
    rospy.sleep(0.2)
    rospy.sleep(0.5)
""",
    ),
    "log_2": (
        4,
        """import rospy

counter = beats = 0
speeds = [0.1, 0.2, 0.3]


def timerCallback(event):
    global counter
    counter += 1
    rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
    speed = speeds[counter]


def heartbeat(event):
    global beats
    beats += 1
    rospy.loginfo("[HEARTBEAT] counter = " + str(beats))


rospy.init_node("spinner_py_node")
rospy.Timer(rospy.Duration(0.5), timerCallback)
rospy.Timer(rospy.Duration(1.0), heartbeat)
rospy.spin()
""",
    ),
    "log_3": (
        4,
        """import rospy

counter = 0


def timerCallback(event):
    global counter
    counter += 1
    rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
    rospy.sleep(0.7)


rospy.init_node("spinner_py_node")
rospy.Timer(rospy.Duration(0.5), timerCallback)
rospy.spin()
""",
    ),
    "log_4": (
        5,
        """import rospy

counter = 0


def timerCallback(event):
    global counter
    counter += 1
    rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
    rospy.sleep(2.3 if counter == 2 else 0)


rospy.init_node("spinner_py_node")
rospy.Timer(rospy.Duration(0.5), timerCallback)
rospy.spin()
""",
    ),
}
