"""Say which fault a log shows, with the evidence and how sure that is; or that it cannot be told."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from ..measures import quantile, say_time
from .reading import Log
from .series import FEWEST, MS, NS, Gap, Series
from .windows import Window, every, find_windows, node_of

__all__ = ["TITLES", "Verdict", "diagnose"]

# What a verdict is called, in the order in which they matter.
TITLES = {
    "clock": "The clock was set",
    "twins": "Two nodes of one name",
    "publishers": "Another publisher on the topic",
    "doubled": "Two counts in one line: two nodes of one name, or two publishers",
    "queue": "A subscriber behind a full queue",
    "lost": "Numbers left out together with their time: lost on the way",
    "stalled": "All late together: the machine stalled, or a garbage collection",
    "blocked": "A slow callback that blocks its neighbours",
    "overran": "A pass that took longer than its period",
    "held-up": "Held up, and the log does not say by what",
    "bursts": "In bursts: several together, and then none",
    "sleep": "A sleep of fixed length after the work",
    "healthy": "As it should be",
    "unknown": "I cannot tell",
}

_HEARD = ("heard", "received", "receive", "got ", "listen", "subscri", "incoming", "message")


@dataclass(frozen=True)
class Verdict:
    """One of :data:`TITLES`, how ``certain`` it is (sure, likely, possible), and the evidence."""

    name: str
    certain: str
    evidence: tuple[str, ...]
    series: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        return TITLES[self.name]

    @property
    def page(self) -> str:
        """What explains it, in words and with a figure: an address within the site."""
        return f"docs/how-to/look-at-your-log.html#look-{self.name}"


def diagnose(log: Log, rows: Sequence[Series]) -> list[Verdict]:
    """Return all that the log shows, what matters most first; never nothing."""
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
        self.ros = log.ros
        # rospy writes microseconds. Its timers have threads of their own, so none of them waits for another.
        self.is_rospy = self.ros == 1 and all(entry.time % 1000 == 0 for entry in log.entries)
        self.diagnosed: list[Verdict] = []
        self.queues: list[Series] = []
        self.jumps: list[int] = []

    def verdicts(self) -> list[Verdict]:
        self.clock_back()
        if not any(verdict.name == "unknown" for verdict in self.diagnosed):  # else runs, or processes, are mixed up
            for look in (self.doubled, self.queue, self.lost, self.gaps, self.bursts, self.sleep):
                look()
        if not self.diagnosed:
            self.say_good()
        order = list(TITLES)
        return sorted(self.diagnosed, key=lambda verdict: order.index(verdict.name))

    def say(self, name: str, certain: str, evidence: Sequence[str], series: Iterable[Series] = ()) -> None:
        self.diagnosed.append(Verdict(name, certain, tuple(evidence), _places(series)))

    def at(self, time: float) -> str:
        return f"{(time - self.zero) / NS:.2f} s"

    # --- the clock ----------------------------------------------------------------------------------------------------

    def clock_back(self) -> None:
        """Say where the time goes back in a line that one process logs in order."""
        evidence, where, restarts = list[str](), list[Series](), list[str]()
        for series in self.rows:
            for n, (one, other) in enumerate(pairwise(series.times), 1):
                if one - other > 20 * MS and len(series.times) >= FEWEST:
                    self.jumps.append(other)
                    count = series.counts[n - 1 : n + 1]
                    if count and count[1] <= count[0]:
                        restarts.append(f"“{series.name}” goes back to {self.at(other)} and to {count[1]}.")
                        continue
                    where.append(series)
                    back = one - other + (series.period or 0)
                    goes_on = f", while the count continues from {count[0]} to {count[1]}" if _follow(count) else ""
                    evidence.append(
                        f"“{series.name}” goes back by {say_time(back / NS)}, to {self.at(other)}{goes_on}."
                    )
        if restarts:
            self.say("unknown", "sure", [*restarts[:2], "There are several runs in this file: look at each by itself."])
            return
        if not evidence:
            return
        steady = [text for text in evidence if "continues" in text]
        most = max(where.count(series) for series in where)
        if most > 3 or not steady and len(evidence) > 3:
            self.say(
                "unknown", "sure", [*evidence[:2], "Lines of several processes may be mixed up in this file."], where
            )
        else:
            few = (steady or evidence)[:3]
            self.say("clock", "sure" if steady or len(set(map(id, where))) > 1 else "likely", few, where)

    # --- more than one ------------------------------------------------------------------------------------------------

    def doubled(self) -> None:
        if any("same name" in line for line in self.log.said):
            self.say("twins", "sure", [f"ROS says so itself: {self.log.said[0]}"])
            return
        nodes: dict[str, dict[str, list[Series]]] = {}
        for series in self.rows:
            if len(series.times) >= FEWEST:
                nodes.setdefault(series.node, {}).setdefault(series.name, []).append(series)
        for node, lines in nodes.items():
            self._doubled_in(node, lines)

    def _doubled_in(self, node: str, lines: dict[str, list[Series]]) -> None:
        both = [series for group in lines.values() for series in group]
        for group in lines.values():
            if len(launched := {series.process for series in group if series.process}) > 1:
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
            if not any(verdict.name == "twins" for verdict in self.diagnosed):  # once is enough
                evidence.append("So it is with every line of this node: two processes log it.")
                self.say("twins", "likely", evidence, [series for group in enough.values() for series in group])
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
            skips = _skips(series)
            ages = self._ages(series)
            grows = len(ages) >= FEWEST and ages[-1] > ages[0] + 2 * series.period
            # A timer that says how many there are by now leaves out as many.
            if not skips or not grows and (series.keeps_time or _is_quantity(series)):
                continue
            lost, period = sum(skips) - len(skips), say_time(series.period / NS)
            evidence = [f"“{series.name}” leaves out {lost} numbers, but no time: it comes every {period}, always."]
            if grows:
                first, last = say_time(ages[0] / NS), say_time(ages[-1] / NS)
                evidence.append(
                    "Each number is logged by the one who sends it, and then by this line: "
                    f"{first} later at the beginning, {last} later at the end."
                )
            else:
                evidence.append(
                    "If that is no message's number, but one that grows, a loop that reads it looks the same."
                )
            self.queues.append(series)
            self.say("queue", "sure" if grows else "likely", evidence, [series])

    def lost(self) -> None:
        """Say where numbers are missing in gaps of just their length: someone has sent or logged them all the same."""
        for series in self.regular:
            gone = [_left_out(series, gap) for gap in series.gaps]
            if sum(map(bool, gone)) >= max(2, 0.5 * len(gone)):
                evidence = [
                    f"“{series.name}” leaves out {sum(gone)} of {sum(gone) + len(series.times)} numbers, and each time "
                    "there is a gap of just their length: the sender kept sending."
                ]
                self.say("lost", "likely", evidence, [series])

    def _ages(self, series: Series) -> list[int]:
        """Return how much later than in another line each number comes in this one (ns), if there is such a line."""
        for other in self.rows:
            if other is series or not other.counts or not series.counts:
                continue
            sent = dict(zip(other.counts, other.times, strict=True))
            heard = zip(series.counts, series.times, strict=True)
            both = [time - sent[count] for count, time in heard if count in sent]
            if len(both) >= 0.7 * len(series.counts) and min(both) > -20 * MS:
                return both
        return []

    # --- gaps ---------------------------------------------------------------------------------------------------------

    def gaps(self) -> None:
        """Say what held up one line or several."""
        rows = [series for series in self.rows if series not in self.queues]
        at_once, by_node = list[Window](), dict[str, list[Window]]()
        for window in find_windows(rows, self._is_explained):
            nodes = {node_of(series) for series in window.lines}
            if len(nodes) > 1 and not window.on_time:
                at_once.append(window)
                continue
            for node in nodes:
                by_node.setdefault(node, []).append(window.of(node))
        if at_once:
            self._all_at_once(at_once)
        for node, windows in by_node.items():
            self._in_one(node, windows)

    def _is_explained(self, series: Series, gap: Gap) -> bool:
        """Whether in a gap the clock was set, numbers were lost, or the node was started again and counts from 1."""
        counts = series.counts
        jumped = any(gap.start <= jump <= gap.end for jump in self.jumps)
        return jumped or _left_out(series, gap) > 0 or (bool(counts) and counts[gap.at] <= counts[gap.at - 1])

    def _all_at_once(self, windows: list[Window]) -> None:
        lines = windows[0].lines
        if all(window.is_clock() for window in windows):
            self._say_forward(windows)
            return
        evidence = [
            f"At {self.at(window.start)}, {_list(_places(window.lines))} were all silent for "
            f"{say_time(window.length / NS)}; what was due came when that was over."
            for window in windows[:3]
        ]
        if any(window.is_clock() is False for window in windows):
            nodes = ", ".join(sorted({node_of(series) or "?" for window in windows for series in window.lines}))
            evidence.append(f"These are nodes of their own ({nodes}): what held them up is outside of them.")
            self.say("stalled", "sure" if len(windows) > 1 else "likely", evidence, lines)
        else:
            evidence.append("The machine may have stalled, or its clock may have been set forward.")
            self.say("held-up", "likely", evidence, lines)

    def _say_forward(self, windows: list[Window]) -> None:
        evidence = [
            f"At {self.at(w.start)} the times of {_list(_places(w.lines))} step forward by "
            f"{say_time(median(gap.excess for _, gap in w.late) / NS)}, each by the same, and continue as before."
            for w in windows[:3]
        ]
        evidence.append("Nothing that was due came together afterwards, as it does when a machine has stalled.")
        self.say("clock", "likely", evidence, windows[0].lines)

    def _in_one(self, node: str, windows: list[Window]) -> None:
        """Say why lines of one node were silent."""
        if all(window.is_clock() and not window.on_time for window in windows):
            self._say_forward(windows)
            return
        lines = list(dict.fromkeys(series for window in windows for series in window.lines))
        longest = max(windows, key=lambda window: window.length)
        size = say_time(longest.length / NS)
        often = f"once, at {self.at(longest.start)}, for {size}"
        if len(windows) > 1:
            often = f"{_times(len(windows))}, for up to {size}"
        evidence = [f"{_list(_places(lines))} {'was' if len(lines) == 1 else 'were'} silent {often}."]
        if starter := self._starter(node, windows):
            series, where, hits = starter
            evidence.append(f"“{series.name}” came {where} {hits} of these {len(windows)}.")
            evidence.append("While that callback works, the others of its thread or group wait.")
            self.say("blocked", "sure" if hits > 2 else "likely", evidence, dict.fromkeys([series, *lines]))
        elif len(lines) == 1:
            self._one_line(lines[0], windows, evidence)
        else:
            self._some_lines(node, lines, windows, evidence)

    def _one_line(self, series: Series, windows: list[Window], evidence: list[str]) -> None:
        """Judge whether the only line that was silent was held up by its own work."""
        beside = dict.fromkeys(other for window in windows for other in window.on_time)
        passes = every(windows)
        if sum(bool(window.on_time) for window in windows) >= 0.6 * len(windows):
            evidence.append(f"Meanwhile {_list(_places(beside)[:2])} came: only this was held up.")
            self.say("overran", "likely", [*evidence, _back(series, windows)], [series])
        elif passes:
            evidence.append(f"It is one pass in {passes}, always: something that the loop itself does then takes long.")
            self.say("overran", "likely", evidence, [series])
        else:
            evidence.append("Nothing else in the log says if it was its own work, the machine, or a clock set forward.")
            self.say("held-up", "sure", evidence, [series])

    def _some_lines(self, node: str, lines: list[Series], windows: list[Window], evidence: list[str]) -> None:
        """Several lines of one node were silent, and none of them, or of its others, began that."""
        went_on = any(node_of(series) == node for window in windows for series in window.on_time)
        if len(windows) > 2 and self.is_rospy and not went_on:
            evidence.append("In rospy each timer has a thread of its own: what holds up all is Python or the machine.")
            self.say("stalled", "likely", evidence, lines)
        else:
            evidence.append(
                "No line comes before each of these times: it was a callback that logs nothing, a garbage collection, "
                "the machine, or a clock that was set forward."
            )
            self.say("held-up", "sure", evidence, lines)

    def _starter(self, node: str, windows: Sequence[Window]) -> tuple[Series, str, int] | None:
        """Find the line of this node that comes where these windows begin, or where they end, and hardly elsewhere."""
        found = []
        for series in self.rows:
            if node_of(series) != node or all(window.lines == [series] for window in windows):
                continue
            if sum(window.goes_on(series) for window in windows) > 0.3 * len(windows):
                continue
            for where, edge in (("just before", Window.entries_at_start), ("at the end of", Window.entries_at_end)):
                hits = [n for window in windows for n in edge(window, series)[:1]]
                # A callback that is slow in each tenth pass, say, begins a window then; unless the late line does that.
                often = len(hits) > 2 and len({later - n for n, later in pairwise(hits)}) == 1 and not every(windows)
                if len(hits) >= max(2, 0.7 * len(windows)) and (often or len(set(hits)) >= 0.6 * len(series.times)):
                    found.append((series, where, len(hits)))
        return max(found, key=lambda each: each[2], default=None)

    # --- bursts -------------------------------------------------------------------------------------------------------

    def bursts(self) -> None:
        for series in self.rows:
            if series.per_pass == 1 or series.is_list or len(series.times) < FEWEST:
                continue
            seconds = (series.times[-1] - series.times[0]) / (len(series.times) - 1) / NS
            size = f"{series.per_pass:.3g}"
            evidence = [
                f"“{series.name}” comes in bursts of {size}{'' if series.per_pass % 1 == 0 else ' on average'}, each "
                f"{say_time(series.length / NS)} long: {1 / seconds:.4g} bursts a second, "
                f"and {series.per_pass / seconds:.4g} a second on average.",
                "Who sends collects them, or who receives is held up: a buffer, a slow callback, a wireless network. A "
                "callback that logs the line so often each time looks the same.",
            ]
            self.say("bursts", "likely" if series.counts else "possible", evidence, [series])

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
            if series.is_even and (series.is_chosen or (series.is_walk is False and not series.is_quantised))
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
    if not series.is_even:
        late = say_time(quantile([abs(late) for late in series.late], 0.98) / NS)
        why = f"98% of {len(series.times)} are within no less than {late} of a grid of {NS / series.period:.4g} Hz"
    elif series.is_quantised:
        why = "its periods have two lengths, as of a line that is logged only now and then (throttled)"
    return f"“{series.name}”: regular, but {why}."


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
    if not (middle and centre):  # most stamps are the same: they are whole seconds, or /clock stands
        return False
    wide = (quantile(steps, 0.75) - quantile(steps, 0.25)) / middle
    narrow = median(abs(step - centre) for step in pairs) / centre
    return wide > 0.1 and narrow < 0.02


def _left_out(series: Series, gap: Gap) -> int:
    """Return how many numbers are missing in a gap, if it is as long as they would have taken; else 0."""
    if not series.counts or series.per_pass > 1:
        return 0
    step = series.counts[gap.at] - series.counts[gap.at - 1]
    return step - 1 if step > 1 and abs((gap.end - gap.start) / series.period - step) < 0.3 + 0.02 * step else 0


def _skips(series: Series) -> list[int]:
    """By how much the count continues where it leaves numbers out but no time; none unless that is how the line is."""
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
    # A quantity that grows, such as an odometer's, counts nothing. A count continues by one now and then.
    if len(skipped) == len(steps) and max(skipped) - min(skipped) > max(2, 0.5 * median(skipped)):
        return []
    return skipped


def _is_quantity(series: Series) -> bool:
    """Whether the number says how many there are, as in "got 120 samples"."""
    return bool(re.search(rf"\b{series.counts[0]} [a-z]+s\b", series.texts[0]))


def _back(series: Series, windows: Sequence[Window]) -> str:
    new = sum(1 for start in series.grids[1:] if any(abs(start - gap.at) < 6 for w in windows for _, gap in w.late))
    lost = len(series.missing)
    kept = "It is back on its grid afterwards" if not new else "A new grid begins afterwards"
    return f"{kept}; {lost or 'no'} tick{'' if lost == 1 else 's'} of the grid {'is' if lost == 1 else 'are'} missing."
