"""Answers to the exercises on ROS 2, right and wrong, as those on ROS 1 are given in ``answers_ros1``."""

from __future__ import annotations

Answer = str | dict[str, str]

# --- predictions ------------------------------------------------------------------------------------------------------

SHORT, LONG = "after_1_0_seconds = [2.2, 2.4, 2.8]", "after_1_8_seconds = [3.0, 3.2, 3.6]"
ORDER, REPORT = "order = [1, 2, 1, 2]", "report = [9]"
ALWAYS, UNSPUN = "always_slow = [0.4, 1.0, 1.6]", "without_spin = []"


def times(found: str, *wrong: object) -> dict[str, str]:
    """A prediction replaced by another."""
    return {found: f"{found.partition(' = ')[0]} = {list(wrong)}"}


# --- nodes ------------------------------------------------------------------------------------------------------------


# Without a class of its own: a node, and functions around it.


# The loop in the main part, and a thread that spins; signals are caught wherever they come out.


# --- start ------------------------------------------------------------------------------------------------------------


FIRST, PASSES = "timer = [0.4, 0.8, 1.2]", "loop = [0.0, 0.4, 0.8]"
ONE_CALL = "spin_once = [0.4]"

# --- publish ----------------------------------------------------------------------------------------------------------

BOTH, KEEPS_ONE = "both_plain = [4, 5, 6]", "both_keep = [3, 4, 5]"
ONE_SIDE, OTHER_SIDE = "only_publisher = [4, 5, 6]", "only_subscription = []"

# --- right ------------------------------------------------------------------------------------------------------------

RIGHT: dict[str, list[Answer]] = {
    "first-call": [
        {FIRST: "timer = (0.4, 0.8, 1.2)"},
        {FIRST: "timer = [0.4 * n for n in range(1, 4)]"},
        {PASSES: "loop = [0, .4, .8]"},
        {PASSES: "loop = list((0.0, 0.4, 0.8))"},
        {PASSES: "loop = [0.0, 0.4, 0.8]\nprint(loop)"},
    ],
    "who-calls": [
        {UNSPUN: "without_spin = ()"},
        {UNSPUN: "without_spin = list()\nprint(without_spin)"},
        {ONE_CALL: "spin_once = (0.4,)"},
        {ONE_CALL: "spin_once = [2 / 5]"},
        {ONE_CALL: "spin_once = [.4]", UNSPUN: "without_spin = []  # nobody spins"},
    ],
    "late-listener": [
        {BOTH: "both_plain = (4, 5, 6)"},
        {KEEPS_ONE: "both_keep = list(range(3, 6))"},
        {ONE_SIDE: "only_publisher = [4.0, 5.0, 6.0]"},
        {OTHER_SIDE: "only_subscription = ()"},
        {OTHER_SIDE: "only_subscription = list()\nprint(only_subscription)"},
    ],
    "slow-timer": [
        {SHORT: "after_1_0_seconds = (2.2, 2.4, 2.8)"},
        {LONG: "after_1_8_seconds = [3, 3.2, 3.6]"},
        {ALWAYS: "always_slow = [0.4 + 0.6 * n for n in range(3)]"},
        {ALWAYS: "always_slow = (0.4, 1, 1.6)"},
        {SHORT: SHORT + "\nprint(after_1_0_seconds)"},
    ],
    "find-the-order": [
        {ORDER: "order = (1, 2, 1, 2)"},
        {ORDER: "order = [1, 2] * 2"},
        {REPORT: "report = (9,)"},
        {REPORT: "report = [10 - 1]"},
        {ORDER: "order = list((1, 2)) + [1, 2]", REPORT: "report = [9.0]"},
    ],
}

# --- wrong ------------------------------------------------------------------------------------------------------------


FOR_ROS_1 = "import rospy\nrospy.init_node('n')\nrospy.spin()\n"

WRONG: dict[str, list[tuple[Answer, str, str]]] = {
    "first-call": [
        (times(FIRST, 0.0, 0.4, 0.8), "The timer: not 0 s, 0.4 s, 0.8 s", "waits for one period before its first"),
        (times(FIRST, 2.5, 5.0, 7.5), "The timer: not 2.5 s", "takes the number for a frequency"),
        (times(FIRST, 0.0, 2.5, 5.0), "The timer: not 0 s, 2.5 s", "takes the number for a frequency"),
        (times(FIRST, 0.4, 0.8, 1.3), "the third of these times is not 1.3 s", "And before the first one?"),
        (times(FIRST, 0.4, 0.8), "3 times are asked for, not 2", "And before the first one?"),
        (times(PASSES, 0.4, 0.8, 1.2), "The loop: not 0.4 s", "makes its first pass immediately"),
        (times(PASSES, 0.0, 0.5, 1.0), "the second of these times is not 0.5 s", "Follow it line by line"),
        ({PASSES: "loop = 0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
        ({PASSES: "loop = ..."}, "The loop: there is no prediction yet", "Give `loop`"),
    ],
    "who-calls": [
        (times(UNSPUN, 0.4, 0.8, 1.2), "Without spin: not 0.4 s", "has no thread of its own"),
        (times(UNSPUN, 0.4, 0.8, 1.2, 1.6, 2.0), "Without spin: not 0.4 s", "called by the thread that spins"),
        (times(UNSPUN, 0.0), "Without spin: not 0 s", "called by the thread that spins"),
        (times(UNSPUN, 0.1, 0.2), "Without spin: not 0.1 s", "has no thread of its own"),
        (times(ONE_CALL), "With one `spin_once`: not nothing at all", "waits until something is due"),
        (times(ONE_CALL, 0.0), "With one `spin_once`: not 0 s", "Nothing is due at the start"),
        (times(ONE_CALL, 0.4, 0.8, 1.2, 1.6, 2.0), "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
        (times(ONE_CALL, 0.4, 0.8, 1.2), "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
        (times(ONE_CALL, 0.5), "With one `spin_once`: not 0.5 s", "Then it calls it"),
        ({UNSPUN: "without_spin = None"}, "Without spin: there is no prediction yet", "Give `without_spin`"),
        ({ONE_CALL: "spin_once = 0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
    ],
    "late-listener": [
        (times(BOTH, 1, 2, 3), "With `10` on both sides: not 1, 2, 3", "the message is not kept"),
        (times(BOTH, 3, 4, 5), "With `10` on both sides: not 3, 4, 5", "the message is not kept"),
        (times(BOTH, 4, 5, 7), "the third of these counters is not 7", "the message is not kept"),
        (times(KEEPS_ONE, 4, 5, 6), "not 4, 5, 6", "keeps its last messages"),
        (times(KEEPS_ONE, 1, 2, 3), "not 1, 2, 3", "Its depth is 1"),
        (times(KEEPS_ONE, 1, 4, 5), "not 1, 4, 5", "not the first"),
        (times(ONE_SIDE, 3, 4, 5), "not 3, 4, 5", "only if it asks for that"),
        (times(ONE_SIDE), "not nothing at all", "that is enough to connect"),
        (times(OTHER_SIDE, 4, 5, 6), "not 4, 5, 6", "offers less than it asks for"),
        (times(OTHER_SIDE, 3, 4, 5), "not 3, 4, 5", "offers less than it asks for"),
        (times(OTHER_SIDE, 9), "not 9", "offers less than it asks for"),
        ({OTHER_SIDE: ""}, "there is no prediction yet", "Give `only_subscription`"),
    ],
    "slow-timer": [
        (times(SHORT, 2.2, 2.2, 2.4), "Blocked for 1.0 s: not 2.2 s, 2.2 s", "one of them comes immediately, and"),
        (times(SHORT, 2.2, 2.6, 3.0), "Blocked for 1.0 s: not 2.2 s, 2.6 s", "it goes back to its grid"),
        (times(SHORT, 1.6, 2.0, 2.4), "not 1.6 s", "the executor calls nothing"),
        (times(SHORT, 2.4, 2.8, 3.2), "not 2.4 s", "it comes immediately"),
        (times(LONG, 3.0, 3.4, 3.8), "Blocked for 1.8 s: not 3 s, 3.4 s", "it goes back to its grid"),
        (times(LONG, 3.0, 3.0, 3.0), "not 3 s, 3 s, 3 s", "There is no queue of calls"),
        (times(LONG, 3.2, 3.6, 4.0), "not 3.2 s", "One overdue tick still comes"),
        (times(ALWAYS, 0.4, 1.2, 2.0), "Each callback takes 0.6 s: not 0.4 s, 1.2 s", "does not wait any longer"),
        (times(ALWAYS, 0.4, 1.4, 2.4), "not 0.4 s, 1.4 s", "does not count from the end"),
        (times(ALWAYS, 0.4, 1.1, 1.8), "the second of these times is not 1.1 s", "Which tick is overdue then?"),
        ({ALWAYS: "always_slow = None"}, "Each callback takes 0.6 s: there is no prediction yet", "Give `always_slow`"),
        ({SHORT: "after_1_0_seconds = 2.2"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "find-the-order": [
        (times(ORDER, 1, 1, 2, 2), "the order: not 1, 1, 2, 2", "This is the usual order"),
        (times(ORDER, 1, 2, 2, 1), "the order: not 1, 2, 2, 1", "thread 1 writes last"),
        (times(ORDER, 2, 1, 1, 2), "the order: not 2, 1, 1, 2", "Here thread 2 begins"),
        (times(ORDER, 2, 1, 2, 1), "the order: not 2, 1, 2, 1", "thread 1 writes last, over what thread 2"),
        (times(ORDER, 1, 2, 1, 2, 2), "4 numbers are asked for, not 5", "It has four lines"),
        (times(ORDER, 1, 2, 1, 1), "the fourth of these numbers is not 1", "each thread runs its first line before"),
        (times(ORDER, 2, 2, 1, 1), "the order: not 2, 2, 1, 1", "nothing is lost"),
        (times(ORDER, 1, 2), "the order: not 1, 2", "so each stands in the list twice"),
        (
            times(ORDER, 1, 1, 1, 2),
            "the order: the second of these numbers is not 1",
            "each thread runs its first line before",
        ),
        (times(REPORT, 10), "the report: not 10", "in the usual order"),
        (times(REPORT, 8), "the report: not 8", "only one of their two parts is lost"),
        (times(REPORT, 5), "the report: not 5", "not at each call"),
        (times(REPORT, 0), "the report: not 0", "stay counted"),
        (times(REPORT, 11), "the report: not 11", "written over"),
    ],
}
