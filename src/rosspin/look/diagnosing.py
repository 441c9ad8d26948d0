"""Say which fault a log shows, with the evidence and how sure that is; or that it cannot be told."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from ..measures import quantile, say_time
from .reading import Log
from .series import FEWEST, Gap, Series

__all__ = ["PAGES", "TITLES", "Verdict", "diagnose"]

NS = 10**9
MS = 10**6

# What a verdict is called, in the order in which they matter.
TITLES = {
    "clock": "The clock was set",
    "twins": "Two nodes of one name",
    "publishers": "Another publisher on the topic",
    "doubled": "Two counts in one line: two nodes of one name, or two publishers",
    "queue": "A subscriber behind a full queue",
    "stalled": "All late at once: the machine stalled, or a garbage collection",
    "blocked": "A slow callback that blocks its neighbours",
    "overran": "A pass that took longer than its period",
    "held-up": "Held up, and the log does not say by what",
    "sleep": "A sleep of fixed length after the work",
    "healthy": "As it should be",
    "unknown": "I cannot tell",
}

# The page that explains a verdict, for ROS 1 and for ROS 2: its address below that of the site.
_HOW_1, _HOW_2 = "docs/how-timing-works.html", "docs/ros2/how-timing-works.html"
_OWN = "docs/how-to/look-at-your-log.html"
PAGES = {
    **{name: (f"{_OWN}#look-{name}",) * 2 for name in ("clock", "twins", "publishers", "doubled", "stalled")},
    **{name: (f"{_OWN}#look-{name}",) * 2 for name in ("held-up", "unknown")},
    "queue": ("docs/publish.html#publish-queue-size", "docs/ros2/publish.html#ros2-publish-depth"),
    "blocked": (f"{_HOW_1}#spin-calls-callbacks", f"{_HOW_2}#ros2-slow-callback-neighbours"),
    "overran": (f"{_HOW_1}#timer-returns-to-grid", f"{_HOW_2}#ros2-timer-returns-to-grid"),
    "sleep": ("notebooks/drift.html",) * 2,
    "healthy": (f"{_HOW_1}#timer-precision", "notebooks/ros2-timer.html"),
}

_HEARD = ("heard", "received", "receive", "got ", "listen", "subscri", "incoming", "message")


@dataclass(frozen=True)
class Verdict:
    """One of :data:`TITLES`, how ``certain`` it is (sure, likely, possible), the evidence and what explains it."""

    name: str
    certain: str
    evidence: tuple[str, ...]
    page: str
    series: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        return TITLES[self.name]


def diagnose(log: Log, rows: Sequence[Series]) -> list[Verdict]:
    """All that the log shows, what matters most first; never nothing."""
    return _Diagnosis(log, rows).verdicts()


def _places(series: Iterable[Series]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(each.name for each in series))


def _list(names: Iterable[str]) -> str:
    names = [f"“{name}”" for name in names]
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _times(count: int) -> str:
    return {1: "once", 2: "twice"}.get(count, f"{count} times")


class _Diagnosis:
    def __init__(self, log: Log, rows: Sequence[Series]) -> None:
        self.log, self.rows = log, rows
        self.regular = [series for series in rows if series.is_regular]
        self.zero = min((entry.time for entry in log.entries), default=0)
        self.ros = log.ros or (2 if any(series.node for series in rows) else 1)
        # rospy writes microseconds. Its timers have threads of their own, so none of them waits for another.
        self.is_rospy = self.ros == 1 and all(entry.time % 1000 == 0 for entry in log.entries)
        self.found: list[Verdict] = []
        self.queues: list[Series] = []
        self.jumps: list[int] = []

    def verdicts(self) -> list[Verdict]:
        for look in (self.clock_back, self.doubled, self.queue, self.gaps, self.sleep):
            look()
        if not self.found:
            self.say_good()
        order = list(TITLES)
        return sorted(self.found, key=lambda verdict: order.index(verdict.name))

    def say(self, name: str, certain: str, evidence: Sequence[str], series: Iterable[Series] = ()) -> None:
        page = PAGES[name][self.ros - 1]
        self.found.append(Verdict(name, certain, tuple(evidence), page, _places(series)))

    def at(self, time: float) -> str:
        return f"{(time - self.zero) / NS:.2f} s"

    # --- the clock ----------------------------------------------------------------------------------------------------

    def clock_back(self) -> None:
        """A time that is earlier than the one before it, in a line that one process logs in order."""
        evidence, where = [], []
        for series in self.rows:
            for n, (one, other) in enumerate(pairwise(series.times), 1):
                if one - other > 20 * MS and len(series.times) >= FEWEST:
                    self.jumps.append(other)
                    where.append(series)
                    back = one - other + (series.period or 0)
                    count = series.counts[n - 1 : n + 1]
                    goes_on = f", while the count goes on from {count[0]} to {count[1]}" if _follow(count) else ""
                    evidence.append(
                        f"“{series.name}” goes back by {say_time(back / NS)}, to {self.at(other)}{goes_on}."
                    )
        if not evidence:
            return
        told = [text for text in evidence if "goes on" in text]
        if not told and len(evidence) > 3:
            self.say(
                "unknown", "sure", [*evidence[:2], "Lines of several processes may be mixed up in this file."], where
            )
        else:
            few = (told or evidence)[:3]
            self.say("clock", "sure" if told or len(set(map(id, where))) > 1 else "likely", few, where)

    # --- more than one ------------------------------------------------------------------------------------------------

    def doubled(self) -> None:
        if any("same name" in line for line in self.log.said):
            self.say("twins", "sure", [f"ROS says so itself: {self.log.said[0]}"])
            return
        by_line: dict[tuple[str, str], list[Series]] = {}
        for series in self.rows:
            line = series.name if series.node == "" or self.log.kind != "console" else series.name
            by_line.setdefault((series.node, line), []).append(series)
        seen: dict[str, dict[str, list[Series]]] = {}
        for (node, line), group in by_line.items():
            if max(len(series.times) for series in group) >= FEWEST:
                seen.setdefault(node, {})[line] = group
        for node, lines in seen.items():
            self._doubled_in(node, lines)

    def _doubled_in(self, node: str, lines: dict[str, list[Series]]) -> None:
        launched = {process for group in lines.values() for process in {series.process for series in group}}
        both = [series for group in lines.values() for series in group]
        if node and len(launched) > 1:
            names = " and ".join(sorted(launched))
            self.say("twins", "sure", [f"The processes {names} both log as {node}."], both)
            return
        published = set().union(*(series.publishers for series in both)) if self.log.kind == "bag" else set()
        if len(published) > 1:
            self.say("publishers", "sure", [f"The bag names them: {', '.join(sorted(published))}."], both)
            return
        for line, group in lines.items():
            rows = [series for series in group if series.part]
            beside = [(one, other) for one, other in pairwise(rows) if _overlap(one, other)]
            if beside:
                one, other = beside[0]
                evidence = [
                    f"Two counts run through “{line}” side by side: one from {one.counts[0]} to {one.counts[-1]}, "
                    f"one from {other.counts[0]} to {other.counts[-1]}."
                ]
                evidence += [f"Each has a period of its own: {_periods(rows)}."] if all(r.period for r in rows) else []
                self._say_doubled(line, lines, evidence, rows)
            elif len(group) == 1 and _alternates(group[0]):
                series = group[0]
                step = median(other - one for one, other in zip(series.times, series.times[2:], strict=False))
                evidence = [
                    f"“{line}” comes at two rows of times, each with a period of {say_time(step / NS)}: every other "
                    "period is long, every other one short."
                ]
                self._say_doubled(line, lines, evidence, group)

    def _say_doubled(
        self, line: str, lines: dict[str, list[Series]], evidence: list[str], rows: Sequence[Series]
    ) -> None:
        if self.log.kind != "console":
            self.say("publishers", "sure" if rows[0].part else "likely", evidence, rows)
            return
        enough = {
            name: group for name, group in lines.items() if sum(len(series.times) for series in group) >= 2 * FEWEST
        }
        split = [name for name, group in enough.items() if len([series for series in group if series.part]) > 1]
        if len(enough) > 1 and len(split) == len(enough):
            self.say(
                "twins", "likely", [*evidence, "So it is with every line of this node: two processes log it."], rows
            )
        elif len(enough) > len(split):
            evidence.append("The node's other lines have one count: there is one such node, and it hears two.")
            self.say("publishers", "likely", evidence, rows)
        elif any(word in line.lower() for word in _HEARD):
            self.say("publishers", "likely", [*evidence, "The line says that the node hears this."], rows)
        else:
            evidence.append(
                "ros2 node list shows the names, ros2 topic info -v who publishes; in ROS 1, rostopic info."
            )
            self.say("doubled", "sure", evidence, rows)

    # --- a full queue -------------------------------------------------------------------------------------------------

    def queue(self) -> None:
        for series in self.regular:
            ages = self._ages(series)
            grows = len(ages) >= FEWEST and ages[-1] > ages[0] + 2 * series.period and ages[-1] > 3 * series.period
            skips = _skips(series)
            grows = grows and (bool(skips) or any(word in series.name.lower() for word in _HEARD))
            if skips or grows:
                evidence = []
                if skips:
                    lost = sum(skips) - len(skips)
                    evidence.append(
                        f"“{series.name}” leaves out {lost} numbers, but no time: it comes every "
                        f"{say_time(series.period / NS)} all along."
                    )
                if grows:
                    evidence.append(
                        "Each number is logged by the one who sends it first, and then by this line: "
                        f"{say_time(ages[0] / NS)} later at the beginning, {say_time(ages[-1] / NS)} later at the end."
                    )
                self.queues.append(series)
                self.say("queue", "sure" if skips and (grows or series.is_walk) else "likely", evidence, [series])

    def _ages(self, series: Series) -> list[int]:
        """How much later than in another line each number comes in this one, in ns, if it is a line that hears."""
        if not series.counts:
            return []
        for other in self.rows:
            if other is series or not other.counts:
                continue
            sent = dict(zip(other.counts, other.times, strict=True))
            both = [
                time - sent[count] for count, time in zip(series.counts, series.times, strict=True) if count in sent
            ]
            if len(both) >= 0.7 * len(series.counts) and min(both) > -20 * MS and len(set(series.counts)) > FEWEST:
                return both
        return []

    # --- gaps ---------------------------------------------------------------------------------------------------------

    def gaps(self) -> None:
        """What held up one line or several, in windows of time."""
        windows = self._windows()
        by_node: dict[str, list[_Window]] = {}
        at_once = []
        for window in windows:
            nodes = {_node(series) for series, _ in window.late}
            if len(nodes) > 1 and not window.on_time:
                at_once.append(window)
            elif len(nodes) == 1 or not window.on_time:
                by_node.setdefault(nodes.pop(), []).append(window)
            else:
                for node in nodes:
                    by_node.setdefault(node, []).append(window.of(node))
        self._all_at_once(at_once)
        for node, each in by_node.items():
            self._in_one(node, each)

    def _windows(self) -> list[_Window]:
        gaps = []
        for series in self._leading():
            own = [gap for gap in series.gaps if gap.at > 5 and not self._is_explained(series, gap)]
            # A machine has a hiccup now and then.
            small = [gap for gap in own if gap.excess < max(series.period, 30 * MS)]
            if len(small) <= max(2, 0.01 * len(series.times)):
                own = [gap for gap in own if gap not in small or gap.excess > 30 * MS]
            gaps += [(series, gap) for gap in own]
        windows: list[_Window] = []
        for series, gap in sorted(gaps, key=lambda each: each[1].end):
            for window in reversed(windows[-8:]):
                both = min(window.end, gap.end) - max(window.start, gap.start)
                if both > 0.5 * min(window.end - window.start, gap.end - gap.start) and series not in window.lines:
                    window.late.append((series, gap))
                    break
            else:
                windows.append(_Window([(series, gap)], []))
        for window in windows:
            window.on_time = [series for series in self.rows if series not in window.lines and _came(series, window)]
        return windows

    def _is_explained(self, series: Series, gap: Gap) -> bool:
        """Whether the clock was set then, or the node was started again: its count is smaller."""
        counts = series.counts
        return any(gap.start <= jump <= gap.end for jump in self.jumps) or (
            bool(counts) and counts[gap.at] <= counts[gap.at - 1]
        )

    def _leading(self) -> list[Series]:
        """The regular lines, but of several that one pass logs the first alone, and none of a queue."""
        leading: list[Series] = []
        for series in sorted(self.regular, key=lambda series: series.times[0]):
            if series not in self.queues and not any(_accompanies(series, other) for other in leading):
                leading.append(series)
        return leading

    def _all_at_once(self, windows: list[_Window]) -> None:
        if not windows:
            return
        clock = [window for window in windows if window.is_clock() is True]
        if clock and len(clock) == len(windows):
            self._say_forward(clock)
            return
        sure = [window for window in windows if window.is_clock() is False]
        evidence = [
            f"At {self.at(w.start)}, {_list(_places(w.lines))} were all silent for {say_time((w.end - w.start) / NS)}; "
            "what was due came when that was over."
            for w in windows[:3]
        ]
        nodes = sorted({_node(series) or "?" for w in windows for series in w.lines})
        if sure:
            evidence.append(
                f"These are processes of their own ({', '.join(nodes)}): what held them up is outside of them."
            )
            self.say("stalled", "sure" if len(windows) > 1 else "likely", evidence, windows[0].lines)
        else:
            evidence.append("The machine may have stalled, or its clock may have been set forward.")
            self.say("held-up", "likely", evidence, windows[0].lines)

    def _say_forward(self, windows: list[_Window]) -> None:
        evidence = [
            f"At {self.at(w.start)} the times of {_list(_places(w.lines))} step forward by "
            f"{say_time(median(gap.excess for _, gap in w.late) / NS)}, each by the same, and go on as before."
            for w in windows[:3]
        ]
        evidence.append("Nothing that was due came all at once afterwards, as it does when a machine has stalled.")
        self.say("clock", "likely", evidence, windows[0].lines)

    def _in_one(self, node: str, windows: list[_Window]) -> None:
        clock = [window for window in windows if window.is_clock() is True]
        if clock and len(clock) == len(windows) and not any(window.on_time for window in windows):
            self._say_forward(clock)
            return
        lines = list({id(series): series for window in windows for series in window.lines}.values())
        starter = self._starter(node, windows)
        longest = max(windows, key=lambda window: window.end - window.start)
        size = say_time((longest.end - longest.start) / NS)
        many = (
            f"{_times(len(windows))}, for up to {size}"
            if len(windows) > 1
            else f"once, at {self.at(longest.start)}, for {size}"
        )
        evidence = [f"{_list(_places(lines))} {'was' if len(lines) == 1 else 'were'} silent {many}."]
        if starter is not None:
            series, where, hits = starter
            if [series] == lines:
                self.say("overran", "likely", evidence, lines)
                return
            evidence.append(
                f"“{series.name}” came {where} {'that' if len(windows) == 1 else f'{hits} of these {len(windows)}'}."
            )
            evidence.append("While that callback works, those of the same thread or group wait.")
            self.say("blocked", "sure" if hits > 2 else "likely", evidence, [series, *lines])
            return
        late = max(len(window.late) for window in windows)
        witnesses = [window for window in windows if window.on_time]
        own = [series for window in witnesses for series in window.on_time if _node(series) == node]
        if late == 1 and len(lines) == 1 and len(witnesses) >= 0.6 * len(windows):
            beside = _list(_places([series for window in witnesses for series in window.on_time][:2]))
            evidence.append(f"Meanwhile {beside} came: the machine went on, and only this was held up.")
            evidence.append(_back(lines[0], windows))
            self.say("overran", "likely" if own or self.log.kind != "console" or node else "possible", evidence, lines)
            return
        if late == 1 and len(lines) == 1 and (every := _every(windows)):
            evidence.append(f"It is every {every}th pass: something that the loop itself does then takes long.")
            self.say("overran", "likely", evidence, lines)
            return
        if late > 1 and len(windows) > 2 and self.is_rospy and not own:
            evidence.append(
                "In rospy each timer has a thread of its own, so what holds up all is Python or the machine."
            )
            self.say("stalled", "likely", evidence, lines)
            return
        if late > 1:
            evidence.append(
                "All were late at the same moments, and no line comes before each of them: a callback that logs "
                "nothing, a garbage collection, or the machine."
            )
        else:
            evidence.append("Nothing else in the log says whether it was its own work or the whole machine.")
        self.say("held-up", "sure", evidence, lines)

    def _starter(self, node: str, windows: Sequence[_Window]) -> tuple[Series, str, int] | None:
        """The line of this node that stands where these windows begin, or where they end, and hardly elsewhere."""
        best = None
        alone = all(len(window.late) == 1 for window in windows) and _every(windows) > 0
        for series in self.rows:
            if _node(series) != node or sum(_goes_on(series, window) for window in windows) > 0.3 * len(windows):
                continue
            for where, edge in (("just before", _begins), ("at the end of", _ends)):
                hits = [n for window in windows for n in edge(series, window)[:1]]
                if len(hits) < 2 or len(hits) < 0.7 * len(windows):
                    continue
                is_every = len(hits) > 2 and len({b - a for a, b in pairwise(hits)}) == 1
                if len(set(hits)) < 0.6 * len(series.times) and (alone or not is_every):
                    continue
                if len(windows[0].lines) == 1 and all(window.lines == [series] for window in windows):
                    continue
                if best is None or len(hits) > best[2]:
                    best = series, where, len(hits)
        return best

    # --- a sleep, or nothing ------------------------------------------------------------------------------------------

    def sleep(self) -> None:
        for series in self.regular:
            if series in self.queues or series.is_chosen or len(series.times) < 12 or series.is_quantised:
                continue
            walks = series.is_walk
            exact = series.spread < 2_000 and 0 < series.drift < 0.5
            if not (walks or exact) or series.drift <= 0.001 and not walks:
                continue
            period = say_time(series.period / NS)
            evidence = [f"“{series.name}” has a period of {series.period / MS:.4g} ms: {NS / series.period:.4g} Hz."]
            if walks:
                evidence.append("A late one makes all later ones late: each period begins when the last one ends.")
            if series.chosen and series.drift < 0.6:
                hertz, work = f"{NS / series.chosen:.4g} Hz", say_time((series.period - series.chosen) / NS)
                evidence.append(f"If it should be {hertz}, the work between two sleeps takes {work}.")
            evidence.append(f"A callback that always takes longer than its period, here {period}, looks the same.")
            self.say("sleep", "likely" if walks else "possible", evidence, [series])

    def say_good(self) -> None:
        good = [
            series
            for series in self.regular
            if series.is_chosen or (series.is_walk is False and not series.is_quantised)
        ]
        odd = [series for series in self.rows if not series.is_regular and len(series.times) >= 2 * FEWEST]
        doubts = [f"{_list(_places(odd[:3]))}: at no regular times."] if odd else []
        doubts += [_doubt(series) for series in self.regular if series not in good][:3]
        most = max((len(series.times) for series in good), default=0)
        evidence = [_praise(series) for series in good]
        if most and not any(len(series.times) > most for series in odd):
            self.say("healthy", "likely" if most >= 30 else "possible", evidence, good)
        else:
            doubts += evidence or ([] if doubts else [f"No line comes {FEWEST} times or more at regular times."])
        if doubts:
            self.say("unknown", "sure", doubts, [series for series in self.rows if series not in good])


def _praise(series: Series) -> str:
    late = say_time(quantile([abs(late) for late in series.late], 0.98) / NS)
    grid, latest = f"{NS / series.period:.4g} Hz", say_time(max(series.late) / NS)
    lost = f", {len(series.missing)} of the grid missing" if series.missing else ""
    most = f"98% of {len(series.times)} within {late} of a grid of {grid}"
    return f"“{series.name}”: {most}, the latest {latest} late{lost}."


def _doubt(series: Series) -> str:
    why = "too few or too even to tell what keeps the time"
    if series.is_quantised:
        why = "its periods have two lengths, as those of a line that is logged only now and then (throttled)"
    return f"“{series.name}”: regular, but {why}."


@dataclass
class _Window:
    """Lines that were silent at the same time, and those that came meanwhile."""

    late: list[tuple[Series, Gap]]
    on_time: list[Series]

    @property
    def lines(self) -> list[Series]:
        return [series for series, _ in self.late]

    @property
    def start(self) -> int:
        return max(gap.start for _, gap in self.late)

    @property
    def due(self) -> float:
        """When the first of what did not come was due."""
        return min(gap.start + series.period for series, gap in self.late)

    @property
    def end(self) -> int:
        return min(gap.end for _, gap in self.late)

    def of(self, node: str) -> _Window:
        """The part of this that is about one node."""
        late = [(series, gap) for series, gap in self.late if _node(series) == node]
        return _Window(late, self.on_time)

    def is_clock(self) -> bool | None:
        """Whether all stepped by the same time; False if all came again at the same time; None if that is the same."""
        if len(self.late) < 2:
            return None
        ends = [gap.end for _, gap in self.late]
        steps = [gap.excess for _, gap in self.late]
        apart, unequal = max(ends) - min(ends), max(steps) - min(steps)
        if unequal < 12 * MS and apart > max(25 * MS, 2.5 * unequal):
            return True
        return False if apart < 40 * MS and unequal > max(15 * MS, 1.7 * apart) else None


def _node(series: Series) -> str:
    return series.process or series.node


def _follow(counts: Sequence[int]) -> bool:
    return len(counts) == 2 and 0 < counts[1] - counts[0] < 3


def _overlap(one: Series, other: Series) -> bool:
    """Whether two rows of counts run at the same time, and not one after the other."""
    first, last = max(one.times[0], other.times[0]), min(one.times[-1], other.times[-1])
    return all(sum(1 for time in series.times if first <= time <= last) >= 4 for series in (one, other))


def _periods(rows: Iterable[Series]) -> str:
    return " and ".join(say_time(series.period / NS) for series in rows)


def _alternates(series: Series) -> bool:
    """Whether a line comes at two rows of times that have the same period."""
    steps = [other - one for one, other in pairwise(series.times)]
    if len(steps) < 16 or series.is_regular or min(steps) < 0:
        return False
    pairs = [other - one for one, other in zip(series.times, series.times[2:], strict=False)]
    middle, centre = median(steps), median(pairs)
    wide = (quantile(steps, 0.75) - quantile(steps, 0.25)) / middle
    narrow = median(abs(step - centre) for step in pairs) / centre
    return wide > 0.1 and narrow < 0.02


def _skips(series: Series) -> list[int]:
    """By how much the count goes on where it leaves numbers out but no time; none unless that is how the line is."""
    counts = series.counts
    if len(counts) < FEWEST or series.part or series.per_pass > 1:
        return []
    steps = [
        (other - one, later - earlier)
        for (one, other), (earlier, later) in zip(pairwise(counts), pairwise(series.times), strict=True)
    ]
    skipped = [count for count, time in steps if count > 1 and time < 1.5 * series.period]
    lost = sum(skipped) - len(skipped)
    if len(skipped) < 3 or lost < 0.15 * len(steps) or any(count < 0 for count, _ in steps):
        return []
    # Every tenth value, say, is left out on purpose.
    if len({count for count, _ in steps}) == 1:
        return []
    return skipped


def _accompanies(series: Series, other: Series) -> bool:
    """Whether a line comes with each of another one of its node."""
    if _node(series) != _node(other) or series.part != other.part or abs(len(series.times) - len(other.times)) > 2:
        return False
    both = list(zip(series.times, other.times, strict=False))
    return sum(1 for one, first in both if abs(one - first) < 0.05 * series.period) > 0.9 * len(both)


def _came(series: Series, window: _Window) -> bool:
    """Whether a line came while others were silent, and not late itself."""
    excess = median(gap.excess for _, gap in window.late)
    inside = [n for n, time in enumerate(series.times) if window.start < time < window.end]
    return any(not series.is_regular or series.late[n] < 0.3 * excess for n in inside)


def _goes_on(series: Series, window: _Window) -> bool:
    """Whether a line comes in the middle of a window: then it is not what others wait for."""
    return any(window.due + 5 * MS < time < window.end - 0.25 * (window.end - window.due) for time in series.times)


def _begins(series: Series, window: _Window) -> list[int]:
    """The entries of a line that stand where a window begins: before the first tick that was due in it."""
    return [n for n, time in enumerate(series.times) if window.start - 5 * MS <= time <= window.due + 5 * MS]


def _ends(series: Series, window: _Window) -> list[int]:
    edge = 0.1 * (window.end - window.start)
    if series in window.lines:  # a late line comes when it is over
        return []
    return [n for n, time in enumerate(series.times) if window.end - edge <= time <= window.end + 10 * MS]


def _every(windows: Sequence[_Window]) -> int:
    """Of how many passes one is slow, if it is always as many; 0 if not."""
    counts = [window.late[0][1].at for window in windows]
    series = windows[0].lines[0]
    if series.counts:
        counts = [series.counts[at] for at in counts]
    steps = {other - one for one, other in pairwise(counts)}
    return steps.pop() if len(counts) > 2 and len(steps) == 1 else 0


def _back(series: Series, windows: Sequence[_Window]) -> str:
    new = sum(1 for start in series.grids[1:] if any(abs(start - gap.at) < 6 for w in windows for _, gap in w.late))
    lost = len(series.missing)
    kept = "It is back on its grid afterwards" if not new else "A new grid begins afterwards"
    return f"{kept}; {lost or 'no'} tick{'' if lost == 1 else 's'} of the grid {'is' if lost == 1 else 'are'} missing."
