"""What is behind counters that are wrong, as a hint that follows from what came."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from .judging import plain, say
from .observed import ObservedRun, Printed

__all__ = ["for_counters", "for_naps", "for_none", "for_several", "for_times"]

# Times (s) that differ by less are meant to be the same.
_CLOSE = 1e-3

_PERIOD = "A timer is given a period in seconds: the period is 1 / frequency."
_OWN = "give each timer a counter of its own."


def for_counters(counters: Sequence[Printed], wanted: Sequence[float], verb: str = "print") -> str:
    """Return a hint on counters that came, and should have been 1, 2, ... at the ``wanted`` times (s).

    ``verb`` is what the node does with a counter. The hint is empty if the counters themselves are right.
    """
    texts = [line.text for line in counters[: len(wanted)]]
    if texts == [str(number) for number, _ in enumerate(texts, 1)]:
        return ""
    if any(not text.isdigit() for text in texts):
        return f"The counter is a whole number: {verb} it as it is, with nothing before or after it."
    numbers = [int(text) for text in texts]
    steps = {after - number for number, after in pairwise(numbers)}
    if steps == {0}:
        return f"The counter stays at {numbers[0]}: each call has to add 1 to it, and to {verb} what comes of that."
    if numbers[0] == 0 and steps <= {1} and abs(counters[0].time - wanted[0]) < _CLOSE:
        return f"The first counter is 1: add 1 before you {verb} it, not after."
    if steps <= {1} and numbers[0] > 1:
        start = f"The first counter is 1, and this one begins at {numbers[0]}: something has counted before."
        return f"{start} Is it 0 at the start? If another timer counts in it: {_OWN}"
    if steps <= {0, 1} and 0 in steps:
        return f"A counter comes more than once: does the node {verb} it twice, or do two timers {verb} the same one?"
    if len(steps) == 1 and (step := steps.pop()) > 1:
        return f"The counter goes up by {step} each time: add 1 in each call. If another timer counts in it: {_OWN}"
    if abs(counters[0].time - wanted[0]) < _CLOSE:
        return f"Something else counts in the same variable, or prints the same words: {_OWN}"
    return ""


def for_times(counters: Sequence[Printed], wanted: Sequence[float], hint: str = "") -> str:
    """Return a hint on the right counters at wrong times; ``hint`` if they show no more than another period."""
    pairs = list(pairwise(counters[: len(wanted)]))
    if pairs and all(after.time - line.time < _CLOSE for line, after in pairs[::2]):
        return "They come two at a time: do two timers call the same callback, or does one call count twice?"
    if len(pairs) > 2 and sum(after.time - line.time < _CLOSE for line, after in pairs) > len(pairs) / 2:
        return (
            "Several come at a time: does one call count more than once, or do several timers call the same callback?"
        )
    period = wanted[1] - wanted[0] if pairs and abs(wanted[1] - 2 * wanted[0]) < _CLOSE else 0.0
    if period and all(abs(after.time - line.time - period) < _CLOSE for line, after in pairs):
        start, late = f"They come every {say(period)}, as asked for, but", counters[0].time - period
        if late > _CLOSE:
            return f"{start} {say(late)} late. What keeps the first one?"
        if counters[0].time < _CLOSE:
            return f"{start} from the start. A timer waits for one period before its first call: what makes this one?"
    if len(counters) == 1 < len(wanted) and abs(counters[0].time - wanted[0]) < _CLOSE:
        return hint or "It came once, and never again: what should call back the next time?"
    return hint


def for_naps(run: ObservedRun, counters: Sequence[Printed], wanted: Sequence[float]) -> str:
    """Return a hint on counters that come late because a timer's callback sleeps; empty if none does."""
    if not run.naps or all(line.time < time + _CLOSE for line, time in zip(counters, wanted, strict=False)):
        return ""
    return (
        f"The callback sleeps, at line {run.naps[0]}, and its timer calls it again only when it has returned. What the "
        "same thread calls has to wait, too."
    )


def for_several(run: ObservedRun, counters: Sequence[Printed], are_several: bool) -> str:
    """Return a hint on counters that several timers with different periods print; empty if they do not.

    ``are_several`` says whether the exercise asks for several timers.
    """
    periods = sorted({timer.period for timer in run.printers(counters)[0]})
    if len(periods) < 2:
        return ""
    start = f"Timers with different periods print these counters, {' and '.join(map(say, periods))}."
    if are_several:
        return f"{start} Is each given a callback of its own? Of two methods with one name, the later one is called."
    return f"{start} One timer is enough, or each needs a callback and counter of its own."


def for_none(run: ObservedRun, tag: str, hint: str = "") -> str:
    """Return a hint on counters of a ``tag`` of which none came; ``hint`` if the run does not show why."""
    sign = re.compile(rf"\[\s*{tag}\s*\]|\b{tag}\b|counter", re.IGNORECASE)
    others = {"FAST", "SLOW", "HEARTBEAT", "MOTOR", "CAMERA", "ROBOT", "LISTENER", run.tag} - {tag}
    for line in run.printed:
        text = line.text.strip().rpartition("]: ")[2]
        if line.time <= run.seconds and sign.search(text) and not any(f"[{other}]" in text for other in others):
            return f"The lines should read `[{tag}] counter = 1` and so on. The node printed `{plain(text)}`."
    if any(timer.state == "stopped" and not timer.calls for timer in run.timers):
        return "A timer of the node was stopped before its first call, or never started."
    if not run.timers and run.interrupted and not run.printed:
        return hint or "The node has no timer, and printed nothing. What should call the callback?"
    slow = [timer for timer in run.timers if not timer.calls and timer.period > run.seconds]
    if slow and run.interrupted:
        period, end = say(slow[0].period), say(run.seconds)
        late = (
            f"A timer of the node has a period of {period}, so its first call is not due before the run ends, at {end}."
        )
        return f"{late} {hint or _PERIOD}"
    if not run.printed and any(timer.calls for timer in run.timers):
        return "A timer called its callback, but that printed nothing. Lines that are logged as debug are not shown."
    return hint
