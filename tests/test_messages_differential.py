"""Message classes beside genpy's own: every type of nine packages, with random values and wrong ones.

ROSSPIN_SEED asks for other values.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosspin.messages.definitions import parse
from rosspin.messages.library import Library
from rosspin.messages.ros1 import Messages

PROBE = Path(__file__).with_name("message_probe.py")
SOURCE = Path(__file__).parent.parent / "src"
SEED = os.environ.get("ROSSPIN_SEED", "1")
# Errors that Python itself words, which it does anew now and then.
PYTHONS_OWN = ("builtins.", "when writing", "unpack requires")


def probe(python: str, *args: str) -> Any:
    run = subprocess.run([python, str(PROBE), SEED, *args], capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


@pytest.fixture(scope="module")
def answers(require: Callable[[str], None]) -> tuple[Any, Any]:
    """What the real one says, and what rosspin says."""
    require("ros1")
    return probe("/usr/bin/python3"), probe(sys.executable, str(SOURCE))


def test_every_type_is_there(answers: tuple[Any, Any]) -> None:
    real, ours = answers
    assert ours["answers"].keys() == real["answers"].keys()
    assert len({name.partition("/")[0] for name in real["answers"]}) == 9


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


def test_a_definition_with_its_comments_reads_the_same(answers: tuple[Any, Any]) -> None:
    """The real texts have comments, tabs and blank lines; those that rosspin carries have none."""
    library = Library(1)
    messages = Messages(library)
    for name, text in answers[0]["texts"].items():
        own, *nested = text.split("\n" + "=" * 80 + "\n")
        real, ours = parse(own, name, "real", 1), library.definition(name)
        assert real.constants == ours.constants
        assert [(field.name, field.kind) for field in real.fields] == [
            (field.name, field.kind) for field in ours.fields
        ]
        heads = [part.partition("\n")[0] for part in nested]
        parts = messages[name]._full_text.split("\n" + "=" * 80 + "\n")[1:]
        assert [part.partition("\n")[0] for part in parts] == heads
