"""Sphinx's own doctest builder catches each form of a lie, in a page and in a notebook; what can be is rewritten."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.helpers.small_sites import CONF, PAGES, arguments, build, listed, site
from tests.helpers.tree import ROOT

# Each in a group of its own, which is its name. As (directive, options, content); what is true passes.
LIES = {
    "doctest": [("doctest", "", ">>> 1 + 1\n3")],
    "hidden": [("doctest", ":hide:", ">>> 1 + 2\n4")],
    "not_skipped": [("doctest", ":skipif: 1 > 2", ">>> 1 + 3\n5")],
    "options": [("doctest", ":options: +NORMALIZE_WHITESPACE", ">>> print(1,    5)\n1   7")],
    "flags": [("doctest", "", ">>> print(1,    6)  # doctest: +ELLIPSIS\n1...7")],
    "this_python": [("doctest", ":pyversion: ==3.*", ">>> 1 + 7\n9")],
    "blank_line": [("doctest", "", ">>> print('8\\n\\n9')\n8\n<BLANKLINE>\n10")],
    "message": [("doctest", "", ">>> int('8')\n8\n>>> int('x')\nTraceback (most recent call last):\nValueError: none")],
    "testcode": [("testcode", "", "for n in (1, 2):\n    print(n)"), ("testoutput", "", "1\n3")],
    "hidden_code": [("testcode", ":hide:", "print('hidden code')"), ("testoutput", "", "hidden")],
    "hidden_output": [("testcode", "", "print('hidden output')"), ("testoutput", ":hide:", "hidden")],
    "output_options": [("testcode", "", "print('a  b')"), ("testoutput", ":options: +NORMALIZE_WHITESPACE", "a c")],
    "code_not_skipped": [("testcode", ":skipif: False", "print('p')"), ("testoutput", ":skipif: False", "q")],
    "in_between": [("testcode", "", "print('a\\n\\nb')"), ("testoutput", "", "a\n\nc")],
    "silent": [("testcode", "", "print('not silent')")],
    "code_fails": [("testcode", "", "1 / 0")],
    "another_error": [
        ("testcode", "", "int('y')"),
        ("testoutput", "", "Traceback (most recent call last):\n    ...\nValueError: none"),
    ],
    "prepared": [("testsetup", "", "x = 10"), ("testcode", "", "print(x)"), ("testoutput", "", "11")],
    "setup": [("testsetup", "", "raise ValueError('before')"), ("doctest", "", ">>> 1\n1")],
    "cleanup": [("doctest", "", ">>> 1\n1"), ("testcleanup", "", "raise ValueError('after')")],
}
TRUE = {
    "true": [
        ("testsetup", "", "import math"),
        ("doctest", "", ">>> math.pi\n3.14...\n>>> x = 2\n>>> int('x')\nTraceback (most recent call last):\n"
         "ValueError: invalid literal for int() with base 10: 'x'"),
        ("testcode", "", "print(x)\nprint('end')"),
        ("testoutput", "", "2\nend"),
        ("testcleanup", "", "del x"),
    ],
    "skipped": [("doctest", ":skipif: 2 > 1", ">>> 1\n2"), ("doctest", ":pyversion: <3.0", ">>> 1\n2")],
}  # fmt: skip
BARE = "\n>>> 'bare'\n'bear'\n"

# Those that no output can be written for: nothing says where, or there is none but an error.
NOT_WRITTEN = {"silent", "code_fails", "setup", "cleanup"}


@pytest.fixture(scope="module")
def lying(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return site(tmp_path_factory.mktemp("lies"), LIES | TRUE, BARE)


@pytest.fixture(scope="module")
def told(lying: Path) -> subprocess.CompletedProcess[str]:
    """As an author types it, without make."""
    command = [sys.executable, "-m", "sphinx", *arguments("doctest")]
    return subprocess.run(command, cwd=lying, capture_output=True, text=True)


def test_what_is_true_passes(tmp_path: Path) -> None:
    run = build(site(tmp_path, TRUE), "doctest")
    assert run.returncode == 0, run.stdout + run.stderr
    output = (tmp_path / "build/doctest/output.txt").read_text()
    count = 10 if sys.version_info >= (3, 13) else 8  # since then doctest counts those that it skips
    assert re.search(rf"^Doctest summary\n=+\n +{count} tests\n +0 failures in tests\n", output, re.MULTILINE)


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("lie", LIES)
def test_each_lie_is_caught(lying: Path, told: subprocess.CompletedProcess[str], lie: str, page: str) -> None:
    output = (lying / "build/doctest/output.txt").read_text()
    where = f"{lie} ({lie} code)" if lie in ("setup", "cleanup") else lie
    found = re.findall(rf'^File "{page}", line \d+, in {re.escape(where)}$', output, re.MULTILINE)
    assert len(found) == 1, output
    assert told.returncode == 1


def test_nothing_else_is_called_a_lie(lying: Path, told: subprocess.CompletedProcess[str]) -> None:
    output = (lying / "build/doctest/output.txt").read_text()
    found = re.findall(r"^ +(\d+) failures? in (?:tests|setup code|cleanup code)$", output, re.MULTILINE)
    bare, in_setup, in_cleanup = 1, len(PAGES), len(PAGES)
    in_tests = len(PAGES) * len(LIES) - in_setup - in_cleanup + bare
    assert [int(number) for number in found] == [in_tests, in_setup, in_cleanup]
    assert re.search(r'^File "index\.rst", line \d+, in default\nFailed example:\n    \'bare\'$', output, re.MULTILINE)


# --- the list ---------------------------------------------------------------------------------------------------------


def test_the_list_says_where_what_stands_and_what_is_so_now(
    lying: Path, told: subprocess.CompletedProcess[str]
) -> None:
    entries = listed(told)
    assert len(entries) == len(PAGES) * len(LIES) + 1
    for (page, number), entry in entries.items():
        line = (lying / page).read_text().splitlines()[number - 1].strip()
        stands = re.search(r"^  was     (.*)", entry, re.MULTILINE)
        assert stands and (stands[1].strip() == line or "(make outputs)" not in entry), entry
    marked = [entry for entry in entries.values() if "(make outputs)" in entry]
    assert len(marked) == len(PAGES) * (len(LIES) - len(NOT_WRITTEN)) + 1
    assert any("now     1\n          2" in entry for entry in marked)


def test_the_next_build_tells_it_again(lying: Path, told: subprocess.CompletedProcess[str]) -> None:
    again = build(lying, "dummy")
    assert again.returncode == 1
    assert listed(again) == listed(told)


def test_outputs_are_written_as_sphinx_reads_them(tmp_path: Path) -> None:
    folder = site(tmp_path, LIES | TRUE, BARE)
    before = {page: (folder / page).read_text() for page in PAGES}
    run = build(folder, "outputs")
    assert all(f"written: {page}\n" in run.stdout for page in PAGES)
    for page, text in before.items():
        assert (folder / page).read_text().count("\n") == text.count("\n")  # as many lines as before
    left = listed(build(folder, "doctest"))
    assert len(left) == len(PAGES) * len(NOT_WRITTEN)
    assert not [entry for entry in left.values() if "(make outputs)" in entry]
    # An error is never written: it is told, and the status is 1.
    assert run.returncode == 1
    assert sum("ZeroDivisionError: division by zero" in entry for entry in listed(run).values()) == len(PAGES)


def test_outputs_in_tabs_and_with_more_or_fewer_lines(tmp_path: Path) -> None:
    text = """
>>> 'a'
{}   \n.. tab-set::

   .. tab-item:: One

      >>> print('b\\n\\nc'); print('d')
{}      >>> x = 1
{}      >>> x
{}
      .. testcode::

         print("e")
         print("  f")

      .. testoutput::

{}
"""
    folder = site(tmp_path, {})
    (folder / "conf.py").write_text(CONF.format(conf=str(ROOT / "conf.py")) + "extensions += ['sphinx_design']\n")
    page = folder / "index.rst"
    head = page.read_text()
    page.write_text(
        head + text.format("b\n", "      q\n", "      1\n", "      1\n", "         e\n         g\n         h")
    )
    assert re.search(r'^File "index\.rst", line \d+, in default$', build(folder, "doctest").stdout, re.MULTILINE)
    assert build(folder, "outputs").returncode == 0
    doctests = ["'a'\n", "      b\n      <BLANKLINE>\n      c\n      d\n", "", "      1\n"]
    assert page.read_text() == head + text.format(*doctests, "         e\n           f")
    assert build(folder, "doctest").returncode == 0


def test_no_name_is_told_as_missing_that_failed_to_be_set(tmp_path: Path) -> None:
    folder = site(tmp_path, {"one": [("doctest", "", ">>> x = 1 / 0\n>>> x\n1\n>>> 1\n2")]})
    entries = [entry for (page, _), entry in listed(build(folder, "dummy")).items() if page == "index.rst"]
    assert len(entries) == 2
    assert "ZeroDivisionError" in entries[0] and "now     1" in entries[1]


def test_a_block_of_two_groups_is_written_once(tmp_path: Path) -> None:
    examples = {"one": [("testsetup", "", "x = 1")], "two": [("testsetup", "", "x = 2")]}
    folder = site(tmp_path, examples | {"one, two": [("doctest", "", ">>> print('x\\n' * x, end='')\ny\ny\ny")]})
    assert build(folder, "outputs").returncode == 0
    text = (folder / "index.rst").read_text()
    assert re.search(r"end=''\)\n(   x\n){1,2}$", text), text
