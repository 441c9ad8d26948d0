"""An author changes a node as the how-to says: a build lists all that no longer holds, and the outputs are written."""

from __future__ import annotations

import re
import shutil
import textwrap
from pathlib import Path

import pytest

from rosspin.site.claims import Facts, Stale, report, sentence_near
from rosspin.site.outputs import stale_copies, stale_picture, write
from tests.helpers.author import HOW_TO, copied, listed_in, places_in, typed, without_runs
from tests.helpers.small_sites import build
from tests.helpers.small_sites import site as small_site
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

EXERCISES = "notebooks/ros2-exercises.md"


@pytest.fixture(scope="module")
def few(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return copied(tmp_path_factory.mktemp("author"), ["docs/glossary.rst", "notebooks/rate.md"])


# What a figure is asked for, and what is said of it.
_NODE = "../examples/my_robotics_pkg/src/spinner_py_node.py"
_SETS = ":sets: timer_delta_t_in_seconds"
_PROBE = "../examples/timing_probes/src/timer_probe"
_MOVED = f"{_PROBE}.py _period:={{}}\n:seconds: 2\n:handle: Period"
_SLIDER = ", 0.1 to 1 by 0.1 s"
_MOVES_NOTHING = "the handle moves nothing: name a variable with :sets:, or write {} among the arguments"
_RISES = "a handle goes from a number to a greater one, by a step above 0"
_WRONG_FIGURES = {
    f"{_NODE}\n:seconds: 2\n:handle: Delta{_SLIDER}\n:sets: delta": f"{_NODE} assigns no number to delta",
    f"{_NODE}\n:seconds: 2\n:handle: Delta from 0.1 to 1\n:at: 0.5": "a handle is LABEL, FROM to TO by STEP UNIT",
    f"{_PROBE}.cc\n:seconds: 2": f"there is no {_PROBE}.cc: a path begins where the page is",
    f"{_NODE}\n:seconds: 2\n:callbacks: timerCallback tick": f"{_NODE} defines no tick",
    _NODE: ":seconds: is missing: how long the node runs",
    "\n:seconds: 2": "no node is named: give a FILE, or rows of the form NAME: FILE ARGS",
    f"\n:seconds: 2\n\nrospy {_NODE}": f"a row is NAME: FILE ARGS, not 'rospy {_NODE}'",
    f"\n:seconds: 2\n\nrospy: {_PROBE}.py\nrospy: {_NODE}": "two rows have the name rospy",
    f"{_NODE}\n:seconds: 0.1": "there is no tick in 0.1 s",
    f"{_NODE}\n:seconds: 2\n:handle: Delta, 0 to 1 by 0.5 s\n{_SETS}": "there is no tick in 2 s at 0 s",
    f"{_NODE}\n:seconds: 2\n:handle: Delta{_SLIDER}": _MOVES_NOTHING,
    f"{_NODE}\n:seconds: 2\n:handle: Delta{_SLIDER}\n:at: 0.5": _MOVES_NOTHING,
    f"{_MOVED}{_SLIDER}": "the handle's first position is missing: give :at:, or a variable with :sets:",
    f"{_MOVED}, 1 to 0.1 by 0.1 s\n:at: 0.5": _RISES,
    f"{_MOVED}, 1 to 0.1 by -0.1 s\n:at: 0.5": _RISES,
    f"{_MOVED}, 0.1 to 1 by 0 s\n:at: 0.5": _RISES,
}


_WRONG_SCENES = {
    _NODE: ":seconds: is missing: how long the node runs",
    f"{_NODE}\n:seconds: 1": "no executor of ROS 2 has spun, or the node has too many callbacks",
}

_SHOWN = "```{exercise} first-call\n:solution:\n```\n"


@pytest.fixture(scope="module")
def wrong(few: Path) -> str:
    """What is listed where figures cannot be made, and an exercise is left out."""
    figures, exercises = few / "docs" / "glossary.rst", few / EXERCISES
    with open(figures, "a") as page:
        for directive, texts in (("ticks", _WRONG_FIGURES), ("scenes", _WRONG_SCENES)):
            page.writelines(f"\n.. {directive}:: " + text.replace("\n", "\n   ") + "\n" for text in texts)
    text = without_runs((ROOT / EXERCISES).read_text())
    assert text.count(_SHOWN) == 1
    exercises.write_text(text.replace(_SHOWN, ""))
    run = typed("make doctest", few)
    assert run.returncode != 0
    return listed_in(run.stdout)


def test_a_figure_that_cannot_be_made_is_in_the_list(wrong: str) -> None:
    reasons = [*_WRONG_FIGURES.values(), *_WRONG_SCENES.values()]
    for why in reasons:
        entry = rf"docs/glossary\.rst:\d+\n  was     a plot of .*\n  now     {re.escape(why)}\n"
        assert re.search(entry, wrong), why
    assert len([page for page, _ in places_in(wrong) if page == "docs/glossary.rst"]) == len(reasons)


def test_the_cell_with_a_slider_makes_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT / "notebooks")
    (cell,) = re.findall(r"^.. code-block:: ipython3\n\n((?:   .*\n)+)", HOW_TO, re.MULTILINE)
    *_, last = lines = textwrap.dedent(cell).splitlines()
    assert len(lines) == 4
    names: dict[str, object] = {}
    exec("\n".join(lines[:-1]), names)
    figure = eval(last, names)
    assert 'max="2"' in figure.html and "0.4 s" in figure.html


def test_an_exercise_that_is_missing_is_in_the_list(wrong: str) -> None:
    said = r'no exercise first-call\n  now     rosspin\.exercises checks exercise \d+, "When the first call '
    assert re.search(said, wrong)
    assert wrong.count("no exercise ") == 1


# --- facts ------------------------------------------------------------------------------------------------------------


def _found(code: str) -> list[tuple[int, str, str]]:
    return list(Facts().run(code, "a page"))


def test_all_facts_are_looked_at_and_what_only_follows_is_not_told() -> None:
    code = "a = 1\nassert a == 2\nb = 1 / 0\nassert b == 0\nassert a > 3, a\n"
    assert _found(code) == [
        (2, "assert a == 2", "a is 1"),
        (3, "b = 1 / 0", "ZeroDivisionError: division by zero"),
        (5, "assert a > 3, a", "a is 1"),
    ]


@pytest.mark.parametrize(
    ("code", "line", "now"),
    [
        ("a = {'x': 1}\nassert a['x'] == 2 and len(a) == 1", 2, "a['x'] is 1"),
        ("a, b = 1, 2\nassert a == b", 2, "a is 1\nb is 2"),
        ("for n in (1, 2):\n    if n:\n        assert n < 2", 3, "n is 2"),
        ("a = [1, 3]\nassert all(x < 2 for x in a)", 2, "a is [1, 3]"),
        ("limit = 2\na = [1, 3]\nassert max(x * limit for x in a) == 2", 3, "max((x * limit for x in a)) is 6"),
        ("assert False, 'why'", 1, "why"),
        ("def f(x):\n    return x + nothing\nf(1)", 2, "NameError: name 'nothing' is not defined"),
    ],
)
def test_a_fact_says_what_is_so_now(code: str, line: int, now: str) -> None:
    ((found, _, said),) = _found(code)
    assert (found, said) == (line, now)


def test_a_fact_keeps_its_annotations() -> None:
    """They are objects, as in any file: rclpy looks at a callback's."""
    assert _found("def f(x: int): pass\nassert f.__annotations__['x'] is int") == []


def test_a_value_that_is_missing_because_a_fact_failed_is_not_told() -> None:
    facts = Facts()
    assert len(list(facts.run("a = 1\nb = 1 / 0", "a page"))) == 1
    assert facts.value("a:.2f") == ("1.00", None)
    assert facts.value("b:.2f") == ("?", None)
    assert facts.value("c") == ("?", "NameError: name 'c' is not defined")


# --- the list ---------------------------------------------------------------------------------------------------------


PAGE = """\
Title
=====

Before it.

.. facts::

   assert a == 1

It is :fact:`a`
and so on.

.. facts::

   assert b == 1

Heading
-------

After it.
"""


@pytest.mark.parametrize(
    ("block", "text"), [((6, 8), "It is :fact:`a` and so on."), ((13, 15), "It is :fact:`a` and so on.")]
)
def test_a_fact_is_about_the_text_below_it_or_above_it(block: tuple[int, int], text: str) -> None:
    assert sentence_near(PAGE, *block) == text


def test_code_in_a_notebook_is_no_sentence() -> None:
    page = (
        "About it.\n\n```{code-cell}\nx = 1\n\ny = 2\n```\n\n```{code-cell}\n%%facts\nassert x == 2\n```\n\n## Next\n"
    )
    assert sentence_near(page, 9, 12) == "About it."


def test_the_list_is_by_page_and_line() -> None:
    text = report([Stale("b", 1, "x", "y"), Stale("a", 20, "x\ny", "z", "A sentence."), Stale("a", 3, "x", "y")])
    assert re.findall(r"^[ab]:\d+", text, re.MULTILINE) == ["a:3", "a:20", "b:1"]
    assert "a:20\n  text    A sentence.\n  was     x\n          y\n  now     z\n" in text


# --- the outputs ------------------------------------------------------------------------------------------------------


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A folder with what the outputs are looked for in."""
    for name in ("README.md", "docs/vehicle.svg", "examples/ros2/timer_probe.py"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / "notebooks").mkdir()
    return tmp_path


def test_a_copy_follows_its_file(site: Path) -> None:
    (site / "examples/node.py").write_text("import rospy\n\nnew = 2\n")
    cell = "```{{code-cell}} ipython3\n:tags: [live]\n:copy-of: ../examples/node.py\n\n%%simulate 2.0\n{}```\n"
    notebook = site / "notebooks" / "book.md"
    notebook.write_text("# Book\n\n" + cell.format("import rospy\n\nold = 1\n"))
    (stale,) = stale_copies(site)
    assert (stale.line, stale.stands, stale.now) == (10, "old = 1", "new = 2")
    write(site, stale.edits)
    assert notebook.read_text() == "# Book\n\n" + cell.format("import rospy\n\nnew = 2\n")


def test_a_node_that_is_broken_has_no_picture(site: Path) -> None:
    node = site / "examples/ros2/timer_probe.py"
    node.write_text(node.read_text().replace("import rclpy", "import rclpy (", 1))
    (picture,) = stale_picture(site)
    line = (site / "README.md").read_text().splitlines()[picture.line - 1]
    assert (picture.page, picture.stands, picture.edits, picture.failed) == ("README.md", line, (), True)
    assert "SyntaxError: " in picture.now


def test_the_picture_follows_its_node(site: Path) -> None:
    assert stale_picture(site) == []
    node = site / "examples/ros2/timer_probe.py"
    node.write_text(node.read_text().replace("self.block)", "self.block / 2)"))
    (picture,) = stale_picture(site)
    assert "1.8 s: the vehicle keeps to its line" in picture.now
    write(site, picture.edits)
    assert stale_picture(site) == []


TWO_TIMERS = """import rospy
rospy.init_node("n")
def quick_callback(event): pass
def slow_callback(event): pass
period = 0.5
rospy.Timer(rospy.Duration(period), quick_callback)
rospy.Timer(rospy.Duration(1.5), slow_callback)
rospy.spin()
"""


def test_a_figure_has_a_row_for_each_timer(tmp_path: Path) -> None:
    """At each position of its handle, also where one of them has not ticked yet."""
    folder = small_site(tmp_path / "site", {})
    (folder / "node.py").write_text(TWO_TIMERS)
    moved = ":seconds: 2\n   :handle: Period, 0.5 to 2.5 by 2 s\n   :sets: period"
    with open(folder / "index.rst", "a") as index:
        index.write(f"\n.. ticks:: node.py\n   :seconds: 2\n\n.. ticks:: node.py\n   {moved}\n")
    run = build(folder, "html")
    assert run.returncode == 0, run.stdout + run.stderr
    page = (folder / "build/html/index.html").read_text()
    assert page.count("quick_callback: 4 ticks") >= 2 and page.count("slow_callback: 1 tick") >= 2
