"""Judge what a node did: the judges of answers that are run.

A question says how long an answer runs, and what to check in each run: ``run(1.0, ticks(0.1))``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import count, pairwise
from typing import Concatenate, ParamSpec

from .feedback import Finding
from .hints import for_counters, for_naps, for_none, for_several, for_times
from .judging import Answer, Judge, above, hint_for_kept, plain, say, say_error, say_kept
from .observed import ObservedRun, Printed

Check = Callable[[ObservedRun, str], Finding | None]
"""Looks at one run of an answer. It is told in words which run; an empty text stands for the only one."""

P = ParamSpec("P")

# Times that differ by less than this (s) are meant to be the same. For a program in C++ that waits by looking at the
# time, which passes in steps of 1 ms.
CLOSE = 1.5e-3

RETURNS = "A callback does one pass and returns: the timer calls it again, each period, by itself."
"""The hint for a callback that loops."""

_TURNS = "when the threads take turns at every line"


def _check(look: Callable[Concatenate[ObservedRun, str, P], Finding | None]) -> Callable[P, Check]:
    """Make a check whose other arguments a question gives."""
    return lambda *args, **kwargs: lambda run, when: look(run, when, *args, **kwargs)


# --- how an answer is run ---------------------------------------------------------------------------------------------


def run(
    seconds: float,
    *checks: Check,
    given: str = "",
    when: str = "",
    allowed: str = "",
    stalls_at: float | None = None,
) -> Judge:
    """Run an answer, which has to end well, and check it. ``when`` begins each sentence (default: what was given)."""

    def judge(answer: Answer) -> Iterator[Finding]:
        run = answer.run(seconds, given, allowed=allowed, stalls_at=stalls_at)
        yield from _findings(run, when or _with(given), checks)

    return judge


def ending(
    seconds: float, *checks: Check, given: str = "", when: str = "", terminated_at: float | None = None
) -> Judge:
    """Run an answer and check it, however it ends. SIGTERM may come before Ctrl-C."""

    def judge(answer: Answer) -> Iterator[Finding]:
        yield from _findings(answer.ending(seconds, given, terminated_at), when or _with(given), checks)

    return judge


def shaken(
    seeds: int,
    seconds: float,
    *checks: Check,
    given: str = "",
    right: str = "",
    stalls_at: float | None = None,
) -> Judge:
    """Run an answer once for each seed, its threads taking turns at any point, and tell the first thing that is wrong.

    If nothing is wrong, a finding says so, in the words ``right``.
    """
    when = _TURNS if stalls_at is None else f"{_TURNS}, and the computer is busy for a while"

    def judge(answer: Answer) -> Iterator[Finding]:
        for seed in range(seeds):
            for finding in _findings(answer.run(seconds, given, seed=seed, stalls_at=stalls_at), when, checks):
                if not finding.right:
                    yield finding
                    return
        if right:
            yield Finding(True, f"{right} {when}.")

    return judge


def every(*judges: Judge) -> Judge:
    """Ask one judge after the other."""
    return lambda answer: (finding for judge in judges for finding in judge(answer))


def until_wrong(*judges: Judge) -> Judge:
    """Ask one judge after the other, up to the first that finds something wrong."""

    def judge(answer: Answer) -> Iterator[Finding]:
        for each in judges:
            findings = list(each(answer))
            yield from findings
            if not all(finding.right for finding in findings):
                return

    return judge


def _findings(run: ObservedRun, when: str, checks: Sequence[Check]) -> Iterator[Finding]:
    return (finding for check in checks if (finding := check(run, when)))


def _with(given: str) -> str:
    return f"With `{given}`" if given else ""


# --- when it ticks ----------------------------------------------------------------------------------------------------


def grid(period: float, seconds: float, start: float | None = None) -> list[float]:
    """Return times ``period`` apart, from ``start`` (default: one period) up to ``seconds``, both included."""
    first = period if start is None else start
    return [first + n * period for n in range(int((seconds - first) / period + 1e-6) + 1)]


def on_time(
    counters: Sequence[Printed],
    wanted: Sequence[float],
    what: str = "",
    hint: str = "",
    one: str = "counter",
    verb: str = "print",
) -> Finding:
    """Whether counters 1, 2, ... came at the wanted times, and no others. ``what`` begins the sentence.

    ``one`` is what each of them is, ``verb`` what the node does with it. ``hint`` is for what the counters do not show.
    """
    start = f"{what}: " if what else ""
    hint = (one == "counter" and for_counters(counters, wanted, verb)) or hint
    if not counters:
        return Finding(False, f"{start}no {one} was printed.", hint)
    for number, (line, time) in enumerate(zip(counters, wanted, strict=False), 1):
        if line.text != str(number):
            text = f"{start}where {one} {number} was due, {one} {plain(line.text)} came."
            return Finding(False, text, hint)
        if abs(line.time - time) > CLOSE:
            text = f"{start}{one} {number} came at {say(line.time)}, not at {say(time)}."
            return Finding(False, text, hint, _around(number - 1, counters, wanted, one))
    if len(counters) > len(wanted):
        extra = counters[len(wanted)]
        text = f"{start}{one} {plain(extra.text)} came at {say(extra.time)}; it should not have come."
        return Finding(False, text, hint, _around(len(wanted), counters, wanted, one))
    if len(counters) < len(wanted):
        text = f"{start}{one} {len(counters) + 1}, due at {say(wanted[len(counters)])}, did not come."
        return Finding(False, text, hint, _around(len(counters), counters, wanted, one))
    if len(wanted) == 1:
        return Finding(True, f"{start}{one} 1 came at {say(wanted[0])}, and no other.")
    text = f"{start}{one}s 1 to {len(wanted)} came from {say(wanted[0])} to {say(wanted[-1])}, each at its time."
    return Finding(True, text)


def _around(place: int, counters: Sequence[Printed], wanted: Sequence[float], one: str) -> tuple[str, ...]:
    """Show when each ``one`` came above when it was due, around the first that differs."""
    part = slice(max(place - 2, 0), place + 3)
    rows = {
        one: [str(number) for number, _ in enumerate(wanted if len(wanted) > len(counters) else counters, 1)][part],
        "came": [say(line.time) for line in counters[part]],
        "due": [say(time) for time in wanted[part]],
    }
    return above(**rows)


Hint = Callable[[Sequence[Printed]], str]
"""Returns a hint, from the counters that came, or an empty text."""


@_check
def ticks(
    run: ObservedRun,
    when: str,
    period: float = 0.0,
    name: str = "",
    tag: str = "",
    hint: str | Hint = "",
    *,
    start: float | None = None,
    until: float | None = None,
    at: Sequence[float] = (),
) -> Finding:
    """Whether counters came at their times (s): first those ``at`` given times, then one each period.

    The periods go from ``start`` (default: after one period) ``until`` a time (default: the end of the run). ``tag`` is
    what is printed before a counter, if not the tag of the spinner nodes; ``name`` says whose the counters are.
    """
    counters, wanted = run.counters(tag), [*at, *(grid(period, until or run.seconds, start) if period else ())]
    what = ", ".join(filter(None, (when, name)))
    said = hint if isinstance(hint, str) else hint(counters)
    if not counters:
        said = for_none(run, tag or run.tag, said)
    elif run.interrupted:
        if wrong := _in_one_call(run, counters):
            return wrong
        said = for_times(
            counters, wanted, for_several(run, counters, bool(tag)) or said or for_naps(run, counters, wanted)
        )
    return on_time(counters, wanted, what, said)


def _in_one_call(run: ObservedRun, counters: Sequence[Printed]) -> Finding | None:
    """Find out whether one call of a timer's callback printed several counters; None if none did."""
    for timer in run.timers:
        own = [line.text for line in counters if line.timer == timer.number]
        if len(own) > len(timer.calls) + 1:  # a call at the end may be missing
            first, last = plain(own[0]), plain(own[-1])
            text = f"one call of a timer's callback printed counters {first} to {last}: a loop is in it."
            if len(timer.calls) > 1:
                text = f"{len(timer.calls)} calls of a timer's callback printed {len(own)} counters: a loop is in it."
            return Finding(False, text, RETURNS)
    return None


def unless_regular(asked: float, hint: str) -> Hint:
    """Return a hint for counters that leave their grid, or that have another period than is ``asked`` for (s)."""

    def hint_for(counters: Sequence[Printed]) -> str:
        period = counters[0].time if counters else asked
        regular = bool(counters) and all(abs(line.time - n * period) < CLOSE for n, line in enumerate(counters, 1))
        if regular and abs(period - asked) > CLOSE:
            return (
                f"They come every {say(period)}: that is the period of their timer now, not the one you were asked for."
            )
        return hint

    return hint_for


def unless_first_at(time: float, hint: str) -> Hint:
    """Return a hint for counters the first of which does not come at a time (s)."""
    return lambda counters: "" if counters and abs(counters[0].time - time) < CLOSE else hint


# --- who ticks --------------------------------------------------------------------------------------------------------


@_check
def from_timers(run: ObservedRun, when: str) -> Finding | None:
    """Whether timers printed the counters, and still run. Nothing is said of those that do."""
    timers, others = run.printers(run.counters())
    if others:
        text = f"counter {plain(others[0].text)} was not printed by the callback of a timer."
        return Finding(False, text, "Keep the timer, and let it call back at the frequency that is asked for.")
    if timers and run.interrupted and not any(timer.state == "running" for timer in timers):
        hint = "One timer is enough, and calls back until the node ends, unless something stops it."
        return Finding(False, f"at {say(run.seconds)} no timer runs any more that printed the counters.", hint)
    return None


@_check
def stops(run: ObservedRun, when: str, calls: int, timer: str = "") -> Finding | None:
    """Whether the timers that printed the counters stopped after so many calls. ``timer`` says what a timer is.

    Else it is one of ROS 1.
    """
    timer = timer or f"a `{'ros::Timer' if run.language == 'cpp' else 'rospy.Timer'}`"
    counters = run.counters()
    if not counters:
        return None
    timers, others = run.printers(counters)
    if others:
        text = f"counter {plain(others[0].text)} was not printed by the callback of {timer}."
        return Finding(False, text, "Use a timer, and stop it.")
    states = {timer.state for timer in timers}
    count = sum(len(timer.calls) for timer in timers)
    if "gone" in states:
        hint = "`sys.exit()` in a callback ends the thread that the callback runs in. Ask the timer to stop instead."
        return Finding(False, "the timer was not stopped: its thread was ended.", hint)
    if "blocked" in states:
        text = "the timer was not stopped: a call of its callback had not returned in the end."
        return Finding(False, text, "A callback that never returns keeps its thread. Stop the timer and return.")
    if count > calls:
        text = f"the callback was called {count} times in {say(run.seconds)}, where {calls} would do."
        silent = "A callback that returns immediately is still called. Stop the timer itself."
        return Finding(False, text, silent if count > len(counters) else "")
    if "running" in states and run.interrupted:
        return Finding(False, "the timer still runs.", "Stop the timer itself.")
    return Finding(True, "the timer has stopped.") if "running" not in states else None


# --- how it ends ------------------------------------------------------------------------------------------------------


@_check
def drives_until(run: ObservedRun, when: str, end: float, again: str, late: str) -> Finding:
    """Whether the motor is driven until the time ``end`` (s), and stands still from then on.

    ``again`` is the hint if it is then driven again, ``late`` the hint if it is not stopped immediately.
    """
    printed = [(line.time, as_number(line.text)) for line in run.values("MOTOR", "speed")]
    commands = [(time, speed) for time, speed in printed if speed is not None]
    driven = [time for time, speed in commands if speed and time < end]
    paused = [time for time, speed in commands if not speed and time < end - CLOSE]
    due = int(end / 0.1)
    if paused or abs(len(driven) - due) > 1:
        state = f"stopped at {say(paused[0])}" if paused else f"told a speed {len(driven)} times, not about {due} times"
        hint = "Until the node ends, the loop has to drive the motor as before."
        return Finding(False, f"{when}: up to then the motor was {state}.", hint)
    stop = next((n for n, (_, speed) in enumerate(commands) if not speed), None)
    if stop is None:
        return Finding(False, f"{when}: nothing stops the motor. It continues at its last speed.")
    time, (last, speed) = commands[stop][0], commands[-1]
    later = [after for after, speed in commands[stop:] if speed]
    if later and (speed or last > end + 0.5):
        text = f"{when}: the motor was stopped at {say(time)}, and driven again at {say(later[0])}."
        return Finding(False, text, again)
    if time > end + 0.5:
        text = f"{when} at {say(end)}: the motor was not stopped before {say(time)}."
        return Finding(False, text, late if end < run.seconds else "Stop it first: what does the node wait for?")
    return Finding(True, f"{when}: the motor was stopped at {say(time)}.")


def ends_well(run: ObservedRun, when: str) -> Finding:
    """Whether a signal has ended a node of ROS 2 with status 0, without a traceback."""
    if run.killed:
        return Finding(False, f"{when}: the node did not end: {say_kept(run, 2)}", hint_for_kept(run))
    if run.errors:
        error = run.errors[-1]
        caught = (
            "In the main part, Ctrl-C raises `KeyboardInterrupt`. SIGTERM ends what spins with "
            "`ExternalShutdownException`. Catch both around `spin`, in whichever thread it is."
        )
        again = "After a signal `rclpy.shutdown()` raises an error; `rclpy.try_shutdown()` does not."
        return Finding(False, f"{when}: the {say_error(error)}", again if error.type == "RCLError" else caught)
    if run.status:
        text = f"{when}: the node ended with status {run.status} instead of 0."
        return Finding(False, text, "Status 0 says that all is well. A main part that just ends gives it.")
    return Finding(True, f"{when}: the node ended with status 0, without a traceback.")


@_check
def ends_at_sigterm(run: ObservedRun, when: str, at: float) -> Finding:
    """Whether SIGTERM has ended a node of ROS 2 well, before Ctrl-C could."""
    if not run.interrupted:
        return ends_well(run, when)
    hint = (
        "SIGTERM raises nothing in the main part and wakes no Rate. The main part should spin: `spin` notices it. The "
        "loop can be in a thread."
    )
    return Finding(False, f"{when} at {say(at)}: the node did not end.", hint)


@_check
def declares(run: ObservedRun, when: str, name: str) -> Finding | None:
    """Whether a node of ROS 2 has declared a parameter. Nothing is said of one that has."""
    if name in run.parameters or not run.interrupted:
        return None
    text = f"{when}: the node has no parameter `{name}`."
    return Finding(
        False, text, "It is declared, and read from there: whoever starts the node may set it in other ways."
    )


# --- what it shares ---------------------------------------------------------------------------------------------------


# --- what it asks -----------------------------------------------------------------------------------------------------


def goes_on(seconds: float, *checks: Check, given: str = "", hint: str) -> Judge:
    """Run an answer that may hang, and check it first; then it has to end at Ctrl-C. ``hint`` is for one that hangs."""

    def judge(answer: Answer) -> Iterator[Finding]:
        run = answer.run(seconds, given, has_to_end=False)
        said = _with(given)
        yield from _findings(run, said, checks)
        if run.killed:
            start = f"{said}: the" if said else "the"
            yield Finding(False, f"{start} node did not end at Ctrl-C: {say_kept(run, 2)}", hint)

    return judge


@_check
def answered(
    run: ObservedRun,
    when: str,
    service: str,
    takes: float = 0.0,
    *,
    at: Sequence[float] = (),
    least: int = 1,
    hint: str,
    overlap: str = "",
) -> Finding:
    """Whether a service answered one request after the other, each in the time that it ``takes`` (s).

    It should be asked ``at`` these times (s), or else at least so many times, whenever that is. ``hint`` is for a
    request that is not asked or not answered, ``overlap`` for one that is answered too soon.
    """
    start = f"{when}: " if when else ""
    calls = [call for call in run.calls if call.service == service and call.asked < run.seconds]
    if not calls:
        return Finding(False, f"{start}`{service}` was never asked.", "The answer should come from the service.")
    wanted, same_often = at or [call.asked for call in calls], "How often it is asked is not to change."
    due = 0.0
    for number, time in enumerate(wanted):
        if number >= len(calls) or calls[number].asked > time + CLOSE:
            return Finding(False, f"{start}`{service}` was not asked at {say(time)}.", hint)
        if calls[number].asked < time - CLOSE:
            text = f"{start}`{service}` was asked at {say(calls[number].asked)}, not at {say(time)}."
            return Finding(False, text, same_often)
        due = max(due, time) + takes
        if due >= run.seconds:
            continue
        given = calls[number].answered
        if given is None:
            return Finding(False, f"{start}the request of {say(time)} to `{service}` was not answered.", hint)
        if abs(given - due) > CLOSE:
            text = f"{start}the request of {say(time)} to `{service}` was answered at {say(given)}, not at {say(due)}."
            return Finding(False, text, overlap if given < due else hint)
    if len(calls) > len(wanted):
        text = f"{start}`{service}` was asked again at {say(calls[len(wanted)].asked)}."
        return Finding(False, text, same_often)
    if len(calls) < least:
        often = "once" if len(calls) == 1 else f"{len(calls)} times"
        times = f"asked {often} in {say(run.seconds)}, not {least} times"
        return Finding(False, f"{start}`{service}` was {times}.", same_often)
    return Finding(True, f"{start}`{service}` was asked {len(calls)} times, and each answer came in its turn.")


# --- what it publishes ------------------------------------------------------------------------------------------------


_EVERY = "Five times a second is once in 1 / 5 s. That is the period, which a timer is given."
_SAME = "Both ends of a topic have to name the same type: otherwise they do not connect."
_LISTENER = "Leave the listener as it is: only the publisher is missing."
_QOS = "reliable, volatile, depth 10"
ONCE = (
    "A publisher that was made just now may not be connected to other processes yet. Make it once, before the timer "
    "is made, and keep it where the callback finds it."
)


def published_and_heard(answer: Answer) -> Iterator[Finding]:
    """Whether a counter is published every 0.2 s, with the right type, by one publisher, and heard immediately."""
    run = answer.run(2.0)
    wanted = grid(0.2, 2.0)
    sent = [message for message in run.sent if message.topic == "/counter"]
    if not sent:
        yield _unpublished(run)
        return
    if wrong := {message.type for message in sent} - {"std_msgs/UInt32", "UInt32"}:
        text = f"the messages on `/counter` are of the type {plain(', '.join(sorted(wrong)))}, not UInt32."
        yield Finding(False, text, _SAME)
        return
    counters = [Printed(message.time, message.data) for message in sent]
    if all(counter.text == "0" for counter in counters):
        unfilled = "A new message holds 0. Its field `data` is where the counter goes."
        yield Finding(False, "on `/counter`: each message holds 0, not a counter.", unfilled)
        return
    if any(timer.state == "blocked" for timer in run.timers):
        yield Finding(False, "a call of the timer's callback had not returned in the end.", RETURNS)
        return
    on_topic = on_time(counters, wanted, "On `/counter`", for_times(counters, wanted, _EVERY), verb="publish")
    yield on_topic
    publishers = [endpoint.made for endpoint in run.endpoints_of("/counter", True)]
    heard = run.values("LISTENER", "counter")
    listeners, hint = run.endpoints_of("/counter", False), ONCE
    if not listeners:
        hint = "Nothing subscribes to `/counter` any more. Leave the listener as it is."
    elif listeners[0].refused:
        hint = "The publisher offers less than the listener asks for: read the warnings. `10` is enough for both."
    elif listeners[0].made > sent[0].time - CLOSE:
        hint = f"The listener subscribes only at {say(listeners[0].made)}. Leave it as it is."
    elif listeners[0].joined and not (heard and heard[0].text.isdigit()):
        hint = "Leave the listener as it is: it prints `[LISTENER] counter = ` and the number in the message."
    by_listener = on_time(heard, wanted, "The listener", hint if on_topic.right else _EVERY)
    if on_topic.right and heard and heard[0].text != "1":  # it is lost on its way
        by_listener = by_listener._replace(hint=hint)
    if on_topic.right and any(line.timer for line in heard):
        yield called_itself("The listener")
    elif not (on_topic.right and by_listener.right):
        yield by_listener
    elif len(publishers) > 1:
        yield Finding(False, f"the node made {len(publishers)} publishers of `/counter`, where one would do.", ONCE)
    elif listeners[0].made > sent[0].time - CLOSE:
        yield Finding(False, f"the listener subscribes only at {say(listeners[0].made)}.", _LISTENER)
    elif listeners[0].qos not in ("", _QOS):
        yield Finding(False, f"the listener now has {listeners[0].qos}, where it had {_QOS}.", _LISTENER)
    elif publishers[0] > sent[0].time - CLOSE:
        text = f"the publisher was made at {say(publishers[0])}, when its first message was already due."
        yield Finding(False, text, ONCE)
    else:
        yield by_listener


def _unpublished(run: ObservedRun) -> Finding:
    """Say why nothing was published on the topic ``/counter``."""
    others = dict.fromkeys(f"`{plain(message.topic)}`" for message in run.sent)
    if others:
        text = f"nothing was published on `/counter`: it was published on {', '.join(others)}."
        return Finding(False, text, "The publisher uses the listener's topic, letter by letter: `counter`.")
    made = [endpoint for endpoint in run.endpoints if endpoint.publishes and not endpoint.topic.startswith("/rosout")]
    made = [endpoint for endpoint in made if endpoint.topic != "/parameter_events"]
    text = "nothing was published on `/counter`: the node published nothing."
    if not made:
        return Finding(False, text)
    slow = [timer for timer in run.timers if not timer.calls and timer.period > run.seconds]
    if slow:
        period = say(slow[0].period)
        text = f"nothing was published on `/counter` in {say(run.seconds)}: the timer's period is {period}."
        return Finding(False, text, _EVERY)
    return Finding(False, text, "There is a publisher, but nothing publishes with it. The timer's callback should.")


def called_itself(what: str) -> Finding:
    """Say that the callback of a subscription was called by the node itself."""
    text = f"{what}: its lines were printed in a call of a timer, not by the callback of a subscription."
    return Finding(False, text, "A topic carries the message: the subscription calls its callback when one has come.")


AS_IT_IS = "The sensor should stay as it is. Change how the controller listens to it."


def sensor_of(run: ObservedRun, qos: str) -> Finding | None:
    """Find out whether ``/position`` has another publisher than the sensor's, with its QoS; None if it has not."""
    sensors = run.endpoints_of("/position", True)
    if len(sensors) > 1:
        return Finding(False, f"the sensor: `/position` has {len(sensors)} publishers, not one.", AS_IT_IS)
    if sensors and sensors[0].qos != qos:
        text = f"the sensor: its publisher now has {sensors[0].qos}, where it had {qos}."
        return Finding(False, text, AS_IT_IS)
    return None


def unmatched(run: ObservedRun) -> Finding | None:
    """Find out why no subscription to ``/position`` is connected, or one of several is not; None if all are."""
    endpoints = run.endpoints_of("/position", False)
    refused = [endpoint for endpoint in endpoints if endpoint.refused]
    if not endpoints:
        others = [
            endpoint.topic
            for endpoint in run.endpoints
            if not endpoint.publishes and endpoint.topic != "/parameter_events"
        ]
        where = f": it subscribes to `{plain(others[0])}`" if others else ""
        hint = "The subscription uses the publisher's topic, letter by letter: `position`."
        return Finding(False, f"the controller: nothing subscribes to `/position`{where}.", hint)
    if refused:
        text = f"the controller: a subscription with {refused[0].qos} does not match the sensor. Read the warnings."
        is_reliable, asks_for_kept = "best_effort" not in refused[0].qos, "volatile" not in refused[0].qos
        return Finding(False, text, _RELIABLE if is_reliable else _KEPT_TOO if asks_for_kept else _ANOTHER)
    if not any(endpoint.joined for endpoint in endpoints):
        return Finding(False, "the controller: its subscription is not connected to the sensor.", _SAME)
    return None


_RELIABLE = "The subscription asks for reliable messages, unless you say otherwise. The sensor offers less."
_ANOTHER = "The warnings name the policy that does not match: the subscription asks for more than the sensor offers."
_KEPT_TOO = (
    "The subscription asks for messages that the publisher has kept (`TRANSIENT_LOCAL`). The sensor keeps none: it is "
    "`VOLATILE`."
)


@_check
def steers_by_the_newest(run: ObservedRun, when: str, qos: str = "") -> Finding:
    """Whether the controller, whose computation takes 0.33 s, uses the newest of the positions, one every 0.1 s.

    ``qos`` is the sensor's, in ROS 2.
    """
    sent = {as_whole(message.data): message.time for message in run.sent if message.topic == "/position"}
    steps = [line for line in run.values("CONTROLLER", "position") if line.time <= run.seconds]
    if others := [(number, due) for number, due in zip(sent, count(1), strict=False) if number != due]:
        number, due = others[0]
        return Finding(False, f"the sensor published position {number}, where {due} was due.", AS_IT_IS)
    if len(sent) < 99:
        text = f"the sensor published {len(sent)} positions in {say(run.seconds)}, not one every 0.1 s."
        return Finding(False, text, f"{AS_IT_IS} What calls it every 0.1 s has to be free to do so.")
    if wrong := unmatched(run):
        return wrong
    steered = f"the controller steered {len(steps)} times"
    if len(steps) < 20:
        longest = max((after.time - line.time for line, after in pairwise(steps)), default=0.0)
        hint = "Print `[CONTROLLER] position = ` and the number in the message, and then compute for 0.33 s."
        if longest > 0.5:
            hint = f"From one step to the next it took up to {say(longest)}. The computation takes 0.33 s."
        return Finding(False, f"{steered} in {say(run.seconds)}; it can do so 20 times.", hint)
    if short := [after for line, after in pairwise(steps) if after.time - line.time < 0.33 - CLOSE]:
        text = f"the controller steered again at {say(short[0].time)}, less than 0.33 s after the last time."
        return Finding(False, text, "Its computation takes 0.33 s, and the next one begins after that: leave both so.")
    for time, text, _, heard in steps:
        number = as_whole(text)
        made = None if number is None else sent.get(number)
        if made is None:
            said = f"`position = {plain(text)}` is not a position that the sensor has published."
            return Finding(False, said, "A message is not yet its number: print `message.data`.")
        if heard not in ("", text):
            said = f"at {say(time)} the controller printed position {text}, but the message that it got held {heard}."
            return Finding(False, said, "The sensor could be in another process: what it says comes in the message.")
        if time - made > 0.1 + CLOSE:
            said = f"at {say(time)} the controller steered by position {text}, which was {say(time - made)} old."
            first = "A step begins with its line: print it first, and then compute." if time == steps[0].time else ""
            return Finding(False, f"{said} A newer one had arrived.", first)
    return sensor_of(run, qos) or Finding(True, f"{steered}, by the newest position each time.")


# --- numbers ----------------------------------------------------------------------------------------------------------


def as_number(text: str) -> float | None:
    """Return a text as a number; None if it is no number, or not finite."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def as_whole(text: str) -> int | None:
    """Return a text of digits as a number; None for any other text."""
    return int(text) if text.isascii() and text.isdigit() and len(text) < 20 else None
