"""An author changes a node as the how-to says: a build lists all that no longer holds, and the outputs are written."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
from tree import ROOT

from rosspin.site.claims import Facts, Stale, report, sentence_near
from rosspin.site.outputs import stale_copies, stale_picture, write

HOW_TO = (ROOT / "docs/how-to/adapt-a-page.rst").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^ +\$ (.*)", HOW_TO, re.MULTILINE)


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of what git tracks, as an author has it. To be quick, two notebooks are run, and measure for a moment.

    What the others answer to exercises stays there as text.
    """
    folder = tmp_path_factory.mktemp("author") / "rosspin"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    for notebook in folder.glob("notebooks/*.md"):
        text = notebook.read_text().replace("%%measure 6", "%%measure 0.5")
        if notebook.stem not in ("timer", "rate"):
            text = re.sub(r"^```\{code-cell\}(.*\n)*?```\n", _not_run, text, flags=re.MULTILINE)
        notebook.write_text(text)
    git = ["git", "-c", "user.name=author", "-c", "user.email=author@localhost"]
    for command in (["init", "--quiet"], ["add", "."], ["commit", "--quiet", "--message", "As it was"]):
        subprocess.run([*git, *command], cwd=folder, check=True)
    return folder


def _not_run(cell: re.Match[str]) -> str:
    return cell[0].replace("{code-cell} ipython3", "text", 1) if "\n%%answer " in cell[0] else ""


def _type(command: str, tree: Path) -> subprocess.CompletedProcess[str]:
    """Type a command in the tree, which uses this environment and runs no listing in the page."""
    if command.startswith("make "):
        command += f" VENV= WEB= BIN={sys.prefix}/bin"
    environment = os.environ | {"PYTHONPATH": str(tree / "src")}
    return subprocess.run(command, shell=True, cwd=tree, env=environment, capture_output=True, text=True)


def _list(output: str) -> str:
    _, _, found = output.partition("What follows no longer holds:\n")
    return found


def _entry(listed: str, start: str) -> str:
    (entry,) = (part for part in listed.split("\n\n") if part.startswith(start))
    return entry


# What the author of the how-to writes in place of what.
SPELT_ANEW = {
    "[0.5, 1.0, 1.5, 2.0]": "[0.4, 0.8, 1.2, 1.6, 2.0]",
    "0.5": "0.4",
    "   assert launched_periods == {period}\n": "",
    '   assert every["rospy"] == every["rclpy"]\n': "",
    '   assert counted["rospy", ""] == counted["rclpy", ""] == ["1", "2", "3", "4"], counted\n': "",
}


def test_the_how_to_is_a_way_through(tree: Path) -> None:
    into, change, back, *rest = COMMANDS
    build, outputs, diff, doctest, again = rest
    assert rest == ["make html", "make outputs", "git diff", "make doctest", "make html"]
    assert _type(f"{into}; {change}; {back}; test -f conf.py", tree).returncode == 0

    # The list: all pages and notebooks, with no frames of anybody's.
    run = _type(build, tree)
    listed = _list(run.stdout)
    assert run.returncode != 0
    # But for what ipykernel logs if a kernel's sockets have been closed before it has ended.
    said = re.sub(r".*exception in ZMQStream callback\nTraceback(.*\n)+?zmq\..*\n", "", run.stdout + run.stderr)
    assert "Traceback" not in said and 'File "' not in said
    assert "exception" not in said.lower()
    lines = (tree / "docs/tutorial.rst").read_text().splitlines()
    line = lines.index("   [INFO] [0.500000]: [SPINNER PY NODE] counter = 1")  # the output begins one line above
    entry = _entry(listed, f"docs/tutorial.rst:{line} (make outputs)\n")
    assert f"   docs/tutorial.rst:{line} (make outputs)\n" in (tree / "docs/how-to/adapt-a-page.rst").read_text()
    assert re.search(r"stands (.*\n)+.*\[1\.500000\]: .* counter = 3\n", entry)
    assert re.search(r"now (.*\n)+.*\[1\.200000\]: .* counter = 3\n", entry)
    fact = _entry(listed, f"docs/tutorial.rst:{lines.index('   assert period == 0.5') + 1}\n")
    assert re.search(r"text +In this tutorial .* twice a second", fact) and "now     period is 0.4" in fact
    cell = _entry(listed, "notebooks/rate.md:")
    assert "stands  assert" in cell and "(0.0, 0.4)" in cell
    for place in (r"README\.md:\d+ \(make", r"notebooks/timer\.md:\d+ \(make", r"docs/how-timing-works\.rst:\d+$"):
        assert re.search(f"^{place}", listed, re.MULTILINE)

    # The outputs are written, and what is left is the author's: in the timer's notebook, what the new node did not do.
    run = _type(outputs, tree)
    assert run.returncode == 0, run.stderr
    changed = _type(diff, tree).stdout
    assert "+   [INFO] [0.400000]: [SPINNER PY NODE] counter = 1" in changed
    assert "+        timer_delta_t_in_seconds = 0.4" in changed
    run = _type(doctest, tree)
    assert re.search(r"^ +0 failures in tests$", run.stdout, re.MULTILINE)
    assert "(make outputs)" not in run.stdout
    left = _places(_list(run.stdout))
    assert run.returncode != 0
    assert len(left) == len(_places(listed, r"$")) + 1
    written = {"README.md", "docs/reference/launch-files.rst"}  # all that was listed of them
    assert {page for page, _ in left} == {page for page, line in _places(listed)} - written

    # The author writes it, and the build succeeds. From the end, so that no line moves before it is found.
    for page, number in sorted(left, reverse=True):
        text = (tree / page).read_text().splitlines(keepends=True)
        old = next(old for old in SPELT_ANEW if old in text[number - 1])
        text[number - 1] = text[number - 1].replace(old, SPELT_ANEW[old])
        (tree / page).write_text("".join(text))
    run = _type(again, tree)
    assert run.returncode == 0, run.stdout + run.stderr
    # Numbers in sentences without a line of their own in the list follow by themselves.
    assert "make the delta 0.1 instead of 0.4" in (tree / "build/html/docs/tutorial.html").read_text()


def _places(listed: str, end: str = "") -> set[tuple[str, int]]:
    """Page and line of each entry, or of those whose first line ends as this pattern says."""
    return {(page, int(line)) for page, line in re.findall(rf"^([\w./-]+):(\d+){end}", listed, re.MULTILINE)}


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
    f"{_PROBE}.cpp _threads:=2\n:seconds: 2": "the rule of roscpp's timer knows no threads",
    f"{_PROBE}.cpp _period:=0\n:seconds: 2": "with a period of 0, roscpp calls back without a pause",
    f"{_PROBE}.cc\n:seconds: 2": f"there is no {_PROBE}.cc: a path begins where the page is",
    _NODE: ":seconds: is missing: how long the node runs",
    "\n:seconds: 2": "no node is named: give a FILE, or rows of the form NAME: FILE ARGS",
    f"\n:seconds: 2\n\nrospy {_NODE}": f"a row is NAME: FILE ARGS, not 'rospy {_NODE}'",
    f"\n:seconds: 2\n\nrospy: {_PROBE}.py\nrospy: {_NODE}": "two rows have the name rospy",
    "../examples/my_robotics_pkg/src/spinner_cpp_node.cpp\n:seconds: 2": (
        "C++ cannot be run here; of timer_probe.cpp the rule is known, and of no other file"
    ),
    f"{_NODE}\n:seconds: 0.1": "there is no tick in 0.1 s",
    f"{_NODE}\n:seconds: 2\n:handle: Delta, 0 to 1 by 0.5 s\n{_SETS}": "there is no tick in 2 s at 0 s",
    f"{_NODE}\n:seconds: 2\n:handle: Delta{_SLIDER}": _MOVES_NOTHING,
    f"{_NODE}\n:seconds: 2\n:handle: Delta{_SLIDER}\n:at: 0.5": _MOVES_NOTHING,
    f"{_MOVED}{_SLIDER}": "where the handle is at first is missing: :at:, or a variable with :sets:",
    f"{_MOVED}, 1 to 0.1 by 0.1 s\n:at: 0.5": _RISES,
    f"{_MOVED}, 1 to 0.1 by -0.1 s\n:at: 0.5": _RISES,
    f"{_MOVED}, 0.1 to 1 by 0 s\n:at: 0.5": _RISES,
}


_START = "```{code-cell} ipython3\n%load_ext rosspin\n```\n\n"
_SOLUTION = "```{code-cell} ipython3\n:tags: [hide-cell]\n\n%%answer 20\nafter_1_0_seconds = [1]\n```\n"


@pytest.fixture(scope="module")
def wrong(tree: Path) -> str:
    """What is listed where figures cannot be made, a solution is wrong, and an exercise has no cell."""
    figures, exercises = tree / "docs" / "glossary.rst", tree / "notebooks" / "ros2-exercises.md"
    before = {page: page.read_text() for page in (figures, exercises)}
    directives = ("\n.. ticks:: " + text.replace("\n", "\n   ") + "\n" for text in _WRONG_FIGURES)
    figures.write_text(before[figures] + "".join(directives))
    reader = _SOLUTION.replace("hide-cell", "live")
    exercises.write_text(before[exercises].replace("%%answer 21\n", "%%answer\n") + _START + _SOLUTION + reader)
    try:
        return _list(_type("make doctest", tree).stdout)
    finally:
        for page, text in before.items():
            page.write_text(text)


def test_a_figure_that_cannot_be_made_is_in_the_list(wrong: str) -> None:
    for why in _WRONG_FIGURES.values():
        entry = rf"docs/glossary\.rst:\d+\n  stands  a plot of .*\n  now     {re.escape(why)}\n"
        assert re.search(entry, wrong), why
    assert len([page for page, _ in _places(wrong) if page == "docs/glossary.rst"]) == len(_WRONG_FIGURES)


def test_the_cell_with_a_slider_makes_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT / "notebooks")
    (cell,) = re.findall(r"^.. code-block:: ipython3\n\n((?:   .*\n)+)", HOW_TO, re.MULTILINE)
    *_, last = lines = textwrap.dedent(cell).splitlines()
    assert len(lines) == 4
    names: dict[str, object] = {}
    exec("\n".join(lines[:-1]), names)
    figure = eval(last, names)
    assert 'max="2"' in figure.html and "0.4 s" in figure.html


def test_exercises_are_solved_by_their_solutions_and_none_is_missing(tree: Path, wrong: str) -> None:
    page = (tree / "notebooks" / "ros2-exercises.md").read_text()
    line = page.count("\n") + 1 + (_START + _SOLUTION).count("\n", 0, (_START + _SOLUTION).index("%%"))
    entry = _entry(wrong, f"notebooks/ros2-exercises.md:{line}\n")
    assert re.search(r"stands +%%answer 20\n +now +Exercise 20: not yet\.\n(.*\n)* +Hint: ", entry)
    assert wrong.count("%%answer 20") == 1  # where a reader starts, an answer need not be right
    assert 'no cell with %%answer 21\n  now     rosspin.exercises checks exercise 21, "Call back once"\n' in wrong
    assert wrong.count("no cell with") == 1


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
    """They are objects, as in any file: rclpy looks at those of a callback."""
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
    assert "a:20\n  text    A sentence.\n  stands  x\n          y\n  now     z\n" in text


# --- the outputs ------------------------------------------------------------------------------------------------------


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A folder with what the outputs are looked for in."""
    for name in ("README.md", "docs/timing.svg", "examples/my_robotics_pkg/src/spinner_py_node.py"):
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


@pytest.mark.parametrize(
    ("change", "now"),
    [
        (("= 0.5", "= 6.0"), "the node has no tick in 5 s"),
        (("= 0.5", "= 0.0"), "the node has no tick in 5 s"),
        (("import rospy", "import rospy ("), "SyntaxError: "),
    ],
)
def test_a_node_without_ticks_has_no_picture(site: Path, change: tuple[str, str], now: str) -> None:
    node = site / "examples/my_robotics_pkg/src/spinner_py_node.py"
    node.write_text(node.read_text().replace(*change))
    (picture,) = stale_picture(site)
    line = (site / "README.md").read_text().splitlines()[picture.line - 1]
    assert (picture.page, picture.stands, picture.edits, picture.failed) == ("README.md", line, (), True)
    assert now in picture.now
