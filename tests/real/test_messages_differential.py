"""Message classes beside genpy's own: every type of nine packages and of an odd one, with random and wrong values.

ROSSPIN_SEED asks for other values.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosspin.messages.definitions import parse
from rosspin.messages.library import Library
from rosspin.messages.ros1 import Messages
from tests.helpers.seeds import SEED
from tests.helpers.tree import HELPERS, SOURCE

PROBE = HELPERS / "message_probe.py"
# Errors that Python itself words, which change now and then.
PYTHONS_OWN = ("builtins.", "when writing", "unpack requires")


# What no message of ROS has: each kind of array, words of Python's, constants, deep nesting, nothing at all.
ODD = {
    "Leaf": "string[2] names\nbool on\nfloat32 size\nuint8[4] mask\nNothing none\n",
    "Nothing": "# nothing\n",
    "Branch": "Header header\nLeaf leaf\nLeaf[2] leaves\ntime[] times\nduration[2] spans\nfloat64 last\n",
    "Tree": "float32 A=1.5\nstring B= two # three \nbyte C=-1\nchar D=200\nbool E=True\n\n"
    "bool from\nint8 self\nBranch[] branches\nbool[] flags\nbool[3] three\nbyte[] low\nchar[] high\nint64[2] pair\n"
    "string[] words\nLeaf[1] one\nodd_msgs/Branch branch\nstd_msgs/Header second\nNothing[2] nothings\n",
}


def write_odd(folder: Path) -> str:
    """The package odd_msgs, its folder's path."""
    for part in ("msg", "std_msgs"):
        (folder / part).mkdir()
    (folder / "package.xml").write_text("<package><name>odd_msgs</name></package>")
    (folder / "std_msgs" / "Header.msg").write_text(Library(1).definition("std_msgs/Header").text)
    for name, text in ODD.items():
        (folder / "msg" / f"{name}.msg").write_text(text)
    return str(folder)


def probe(python: str, *args: str) -> Any:
    run = subprocess.run([python, str(PROBE), str(SEED), *args], capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


@pytest.fixture(scope="module")
def answers(require: Callable[[str], None], tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, Any]:
    """What the real one says, and what rosspin says."""
    require("ros1")
    folder = write_odd(tmp_path_factory.mktemp("odd_msgs"))
    return probe("/usr/bin/python3", folder), probe(sys.executable, folder, str(SOURCE))


def test_every_type_is_there(answers: tuple[Any, Any]) -> None:
    real, ours = answers
    assert ours["answers"].keys() == real["answers"].keys()
    assert len({name.partition("/")[0] for name in real["answers"]}) == 9 + 1


def test_each_answer_is_the_real_one(answers: tuple[Any, Any]) -> None:
    real, ours = answers
    same_python = real["python"] == ours["python"]
    count = 0
    for name, said in real["answers"].items():
        assert [what for what, _ in ours["answers"][name]] == [what for what, _ in said]
        for (what, theirs), (_, our) in zip(said, ours["answers"][name], strict=True):
            if not same_python and any(words in theirs for words in PYTHONS_OWN):
                assert any(words in our for words in PYTHONS_OWN), f"{name}: {what} (seed {SEED})"
            else:
                assert our == theirs, f"{name}: {what} (seed {SEED})"
            count += 1
    assert count > 10_000


def test_the_full_text_of_an_own_message_is_the_real_one(answers: tuple[Any, Any]) -> None:
    for name in ODD:
        assert answers[1]["texts"][f"odd_msgs/{name}"] == answers[0]["texts"][f"odd_msgs/{name}"]


def test_a_definition_with_its_comments_reads_the_same(answers: tuple[Any, Any]) -> None:
    """The real texts have comments, tabs and blank lines; those that rosspin carries have none."""
    library = Library(1)
    texts = {name: text for name, text in answers[0]["texts"].items() if not name.startswith("odd_msgs/")}
    messages = Messages(library)
    for name, text in texts.items():
        own, *nested = text.split("\n" + "=" * 80 + "\n")
        real, ours = parse(own, name, "real", 1), library.definition(name)
        assert real.constants == ours.constants
        assert [(field.name, field.kind) for field in real.fields] == [
            (field.name, field.kind) for field in ours.fields
        ]
        heads = [part.partition("\n")[0] for part in nested]
        parts = messages[name]._full_text.split("\n" + "=" * 80 + "\n")[1:]
        assert [part.partition("\n")[0] for part in parts] == heads
