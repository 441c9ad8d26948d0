"""rostopic hz says what the rate is now: a belief that this reveals."""

from __future__ import annotations

from ..predictions import chosen

TITLE = "Read rostopic hz"
TEXT = """
**You need**: [the second tutorial](../docs/publish.rst), [the notebook on publishing](publish.md), and [Find out why a
loop is irregular](../docs/how-to/irregular-loop.rst).

Four topics were meant to have 10 Hz. This is what `rostopic hz` said of each, 10 s and 60 s after its start. What
explains it?

- **A**: All is well.
- **B**: Two nodes publish on the topic, each at 10 Hz.
- **C**: The node kept its rate at first, and later slowed down.
- **D**: The messages come in bursts: five together, and then nothing for half a second.
- **E**: The node works, and then sleeps for a whole period.

```text
report_1
after 10 s: average rate: 10.000
    min: 0.100s max: 0.100s std dev: 0.00000s window: 101
after 60 s: average rate: 4.667
    min: 0.100s max: 0.500s std dev: 0.18070s window: 281

report_2
after 10 s: average rate: 10.400
    min: 0.000s max: 0.500s std dev: 0.19706s window: 105
after 60 s: average rate: 10.067
    min: 0.000s max: 0.500s std dev: 0.19950s window: 605

report_3
after 10 s: average rate: 9.479
    min: 0.105s max: 0.106s std dev: 0.00050s window: 95
after 60 s: average rate: 9.479
    min: 0.105s max: 0.106s std dev: 0.00050s window: 569

report_4
after 10 s: average rate: 20.000
    min: 0.030s max: 0.070s std dev: 0.02000s window: 201
after 60 s: average rate: 20.000
    min: 0.030s max: 0.070s std dev: 0.02000s window: 1201
```
"""
REVEALS = "rostopic hz says what the rate is now. If the average is right, the loop is regular."

NODE = """
report_1 = ...
report_2 = ...
report_3 = ...
report_4 = ...
"""

HINTS = [
    "Which averages are 10 Hz? Does one change between the two reports?",
    "When are `min` and `max`, the shortest and the longest time between messages, far apart?",
    "The average is over all messages since the start. What becomes of it if the rate changes?",
]
HINT = "Compare the average with what was asked for, `min` with `max`, and the first report with the second."

check = chosen(
    {
        "A": "Then the average would be as asked for, and `min` and `max` equal to the period.",
        "B": "Then there would be twice as many messages as asked for.",
        "C": "Then the average would have been right at first, and `max` would be the period that it has now.",
        "D": "Then the average would be right, `min` 0 and `max` many periods.",
        "E": "Then the average would be too low from the start, and `min` and `max` nearly equal.",
    },
    report_1="C",
    report_2="D",
    report_3="E",
    report_4="B",
)

SOLUTION = """
# The average has fallen, and the longest period is 0.5 s.
report_1 = "C"
# The average is right, but messages come at the same time, and then not at all.
report_2 = "D"
# A little too slow from the start, and very regular.
report_3 = "E"
# Twice the rate: 0.03 s and 0.07 s are 0.1 s together.
report_4 = "B"
"""

RIGHT = [
    {'"C"': '"c"', '"D"': "'d'"},
    {'"E"': '" E "'},
    {'"B"': '"(B)"'},
    {'"C"': '"C."'},
    {'report_1 = "C"': "", 'report_2 = "D"': 'report_1, report_2 = "CD"'},
]
WRONG = [
    ({'"C"': '"A"'}, "`report_1`: it is not A", "`min` and `max` equal to the period"),
    ({'"C"': '"E"'}, "`report_1`: it is not E", "too low from the start"),
    ({'"D"': '"A"'}, "`report_2`: it is not A", "equal to the period"),
    ({'"D"': '"C"'}, "`report_2`: it is not C", "right at first"),
    ({'"E"': '"C"'}, "`report_3`: it is not C", "right at first"),
    ({'"B"': '"D"'}, "`report_4`: it is not D", "`min` 0"),
    ({'"E"': '"B"'}, "`report_3`: it is not B", "twice as many messages"),
    ({'"B"': '"F"'}, "one of the letters A to E, not `'F'`", 'Write it as `"A"`'),
    ({'"B"': "4"}, "one of the letters A to E, not `4`", 'Write it as `"A"`'),
    ({'report_4 = "B"': ""}, "`report_4`: there is no answer yet", "Compare the average"),
]

# The pauses (s) after the messages of each topic, and when a second node begins to publish in the same way (s).
PAUSES = {
    "report_1": ([0.1] * 200 + [0.5] * 200, None),
    "report_2": (([0.0] * 4 + [0.5]) * 150, None),
    "report_3": ([0.105, 0.106] * 400, None),
    "report_4": ([0.1] * 700, 0.03),
}
