"""Logs whose fault is known are told apart, as often as the page says; see known_logs.py."""

from __future__ import annotations

import json
import random
from collections import Counter
from functools import cache
from itertools import pairwise

import pytest

from rosspin.look import TITLES, Look, Verdict, look
from tests.helpers.known_logs import CASES, Case, draw
from tests.helpers.known_logs_made import load
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

PAGE = (ROOT / "docs/how-to/look-at-your-log.rst").read_text(encoding="utf-8")


@cache
def looked(case: Case) -> Look:
    return look(load(case), case.name)


def outcome(case: Case) -> str:
    return case.outcome(looked(case).verdicts[0].name)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_no_verdict_is_wrong(case: Case) -> None:
    assert outcome(case) in ("right", "open"), "\n".join(looked(case).report())


def test_of_faults_drawn_at_random_few_are_wrong() -> None:
    """None of these seeds was used while the rules were written."""
    found = Counter(outcome(draw(seed)) for seed in range(5000, 5040))
    assert found["wrong"] <= 0.05 * 40
    said = f"they name {found['right']}, leave {found['open']} open and get {found['wrong']} wrong."
    assert f"Of 40 more whose faults, rates and lengths were drawn at random after that, {said}" in " ".join(
        PAGE.split()
    )


def test_the_page_has_the_numbers() -> None:
    rows = []
    for name, title in TITLES.items():
        cases = [case for case in CASES if case.truth == name]
        if cases:
            found = Counter(map(outcome, cases))
            assert not found["unknown"] + found["wrong"], name
            numbers = len(cases), found["right"], found["open"]
            rows.append("".join([f"      * - {title}\n", *(f"        - {number}\n" for number in numbers)]))
    assert "".join(rows) in PAGE, "".join(rows)


@pytest.mark.parametrize("name", TITLES)
def test_each_verdict_leads_to_a_section_and_its_figure(name: str) -> None:
    """The build draws the figure only if the log in it gets this verdict."""
    title, verdict = TITLES[name], Verdict(name, "sure", ())
    assert verdict.page == f"docs/how-to/look-at-your-log.html#look-{name}"
    _, found, section = PAGE.partition(f".. _look-{name}:\n\n{title}\n{'-' * len(title)}\n")
    assert found
    section = section.partition("\n.. _look-")[0]
    assert f":shows: {name}\n" in section


@pytest.mark.parametrize("case", CASES[::7], ids=lambda case: case.name)
def test_all_of_it_is_json(case: Case) -> None:
    found = json.loads(json.dumps(looked(case).as_dict(), allow_nan=False))
    assert found["verdicts"][0]["title"] == looked(case).verdicts[0].title
    for series in found["series"]:
        assert len(series["late"]) in (0, len(series["times"]))


def by_name(name: str) -> Look:
    return looked(next(case for case in CASES if case.name == name))


def test_what_is_measured() -> None:
    """A timer of 10 Hz whose 70th pass of 20 Hz took 0.22 s: three ticks were lost, and one came late."""
    (series,) = by_name("r2_overran_alone").series
    assert series.period == pytest.approx(50e6, rel=1e-3)
    assert len(series.missing) == 3
    assert max(series.late) == pytest.approx(20e6, abs=10e6)


def test_ticks_are_on_the_grid_that_fits_best() -> None:
    found = by_name("r2_three_nodes")
    ticks = found.ticks()
    assert {tick.source for tick in ticks} == {"arm: joint state: #", "eye: frame: #", "motor: wheel speed: #"}
    assert sorted(abs(tick.lateness) for tick in ticks)[int(0.9 * len(ticks))] < 0.01


def test_timers_of_rclpy_hide_a_clock_that_is_set_back() -> None:
    """As the page says: a loop that sleeps goes back with it, and a timer of the same node does not."""
    back = {
        series.node: any(later < time for time, later in pairwise(series.times))
        for series in by_name("r2_clock_back_two").series
    }
    assert back == {"motor": True, "eye": False}


def lines(times: list[float], text: str = "[INFO] [{:.9f}] [base]: odometry: {}") -> bytes:
    return "\n".join(text.format(1.7e9 + time, n) for n, time in enumerate(times, 1)).encode()


def test_a_restart_is_no_gap() -> None:
    first, then = lines([n * 0.1 for n in range(40)]), lines([8 + n * 0.1 for n in range(40)])
    assert look(first + b"\n" + then).verdicts[0].name == "healthy"


def test_a_throttled_line_is_no_sleep() -> None:
    """Logged once a second at most, in a loop of 10 Hz: after 1.0 s or after 1.1 s."""
    times = [0.0]
    for n in range(60):
        times.append(times[-1] + (1.1 if n * 7 % 3 else 1.0) + (n % 5) * 1e-4)
    (verdict,) = look(lines(times)).verdicts
    assert verdict.name == "unknown" and "throttled" in verdict.evidence[0]


def test_two_lines_of_one_pass_are_not_two_nodes() -> None:
    both = "[INFO] [{0:.9f}] [base]: left: {1}\n[INFO] [{0:.9f}] [base]: right: {1}"
    times = [n * 0.1 + (n % 7) * 1e-4 + (0.5 if n > 30 else 0.0) for n in range(60)]
    assert [verdict.name for verdict in look(lines(times, both)).verdicts] == ["held-up"]


def test_bursts_are_told_with_their_length_and_both_rates() -> None:
    times = [n // 5 * 0.5 + n % 5 * 0.0005 for n in range(200)]
    (verdict,) = look(lines(times)).verdicts
    told = "comes in bursts of 5, each 2 ms long: 2 bursts a second, and 10 a second on average."
    assert verdict.name == "bursts" and told in verdict.evidence[0]
    table = "\n".join(["%time,field.data", *(f"{int(1.7e18 + time * 1e9)},0.5" for time in times)])
    assert look(table.encode()).verdicts[0].name == "bursts"


def test_a_list_that_is_logged_each_time_is_no_burst() -> None:
    told = "\n".join(
        f"[INFO] [{1.7e9 + n * 0.5 + leg * 0.001:.6f}] [base]: leg {leg}: {n * leg % 7}"
        for n in range(40)
        for leg in range(4)
    )
    assert [verdict.name for verdict in look(told.encode()).verdicts] == ["healthy"]


def test_two_rows_of_times_without_a_count() -> None:
    times = sorted([n * 0.1 + n % 3 * 1e-4 for n in range(60)] + [n * 0.1 + 0.03 for n in range(60)])
    table = "\n".join(["%time,field.data", *(f"{int(1.7e18 + time * 1e9)},0.5" for time in times)])
    assert look(table.encode()).verdicts[0].name == "publishers"


def test_there_is_a_known_log_for_each_verdict() -> None:
    assert {case.truth for case in CASES} | {"doubled", "held-up"} == TITLES.keys()
    assert f": {sum(case.is_real for case in CASES)} recorded on the real ROS 1 and ROS 2, the" in PAGE


@pytest.mark.parametrize("stamps", [[1700000000] * 30, [1700000000 + number // 8 for number in range(40)]])
def test_stamps_that_are_the_same_are_no_trouble(stamps: list[int]) -> None:
    text = "".join(f"[INFO] [{stamp}.000000000] [node]: beat {number}\n" for number, stamp in enumerate(stamps))
    assert look(text.encode(), "log").verdicts


def test_a_quantity_that_grows_is_no_count() -> None:
    draw, total, text = random.Random(0), 0, ""
    for number in range(100):
        total += draw.randint(5, 15)
        text += f"[INFO] [{1700000000 + number / 10:.9f}] [odo]: ticks {total}\n"
    assert [verdict.name for verdict in look(text.encode(), "log").verdicts] == ["healthy"]


@pytest.mark.parametrize("steps", [(1, 2), (2, 3), (9, 10, 11), (99, 100, 101)])
@pytest.mark.parametrize("jitter", [0.0, 1e-4, 2e-3])
def test_what_a_timer_says_of_a_number_that_grows_is_no_queue(steps: tuple[int, ...], jitter: float) -> None:
    draw, total, text = random.Random(1), 0, ""
    for number in range(100):
        total += draw.choice(steps)
        text += f"[INFO] [{1.7e9 + number / 10 + abs(draw.gauss(0, jitter)):.9f}] [imu]: total {total}\n"
    assert [verdict.name for verdict in look(text.encode()).verdicts] == ["healthy"]


def test_nor_is_how_many_there_are() -> None:
    """Even of a loop that sleeps, whose periods are as if a callback always worked."""
    draw, time, total, text = random.Random(1), 1.7e9, 0, ""
    for _ in range(100):
        total, time = total + draw.choice((2, 3)), time + 0.1037 + abs(draw.gauss(0, 1e-3))
        text += f"[INFO] [{time:.9f}] [imu]: got {total} samples\n"
    assert "queue" not in {verdict.name for verdict in look(text.encode()).verdicts}


@pytest.mark.parametrize(
    "case", [case for case in CASES if case.form == "console" and not case.jumps][::3], ids=lambda case: case.name
)
def test_a_log_that_is_twice_in_its_file_is_told_once(case: Case) -> None:
    data = load(case)
    found = look(data + b"\n" + data)
    assert found.verdicts == look(data).verdicts
    assert any("the same again: it was set aside" in note for note in found.notes)


def test_runs_in_the_wrong_order_are_no_clock() -> None:
    late, early = lines([100 + n * 0.1 for n in range(60)]), lines([n * 0.1 for n in range(60)])
    found = look(late + b"\n" + early)
    assert [verdict.name for verdict in found.verdicts] == ["healthy"]
    assert "Another run begins after 60 entries" in found.notes[0]
    cut = b"\n".join(early.splitlines()[7:])
    (verdict,) = look(late + b"\n" + cut).verdicts
    assert verdict.name == "unknown" and "several runs in this file: look at each by itself" in verdict.evidence[-1]


@pytest.mark.parametrize("seed", [0, None])
def test_lines_out_of_order_are_no_clock(seed: int | None) -> None:
    times = [n * 0.1 for n in range(100)]
    if seed is None:
        times.reverse()
    else:
        random.Random(seed).shuffle(times)
    (verdict,) = look(lines(times)).verdicts
    assert verdict.name == "unknown" and "may be mixed up" in verdict.evidence[-1]
