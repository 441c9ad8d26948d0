"""Transforms between frames, compared with what tf2's core has answered to the same calls, in Jazzy and in ROS 1."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from rosspin.tf2.exceptions import TransformException
from rosspin.tf2.frames import Frames
from rosspin.tf2.geometry import Transform
from rosspin.tf2.noetic import NoeticFrames

RECORDED = json.loads((Path(__file__).parent / "recorded.json").read_text(encoding="utf-8"))
RECORDED_NOETIC = json.loads((Path(__file__).parent / "recorded_noetic.json").read_text(encoding="utf-8"))


def answer(frames: Frames, method: str, args: list[Any]) -> Any:
    """What a method gives, as it is recorded."""
    if method == "add":
        args[3] = Transform(*map(tuple, args[3]))
    try:
        found = getattr(frames, method)(*args)
    except TransformException as error:
        return str(error) if method == "latest_common_time" else {type(error).__name__: str(error)}
    if method in ("find", "find_full"):
        (translation, rotation), time = found
        return [*(pytest.approx(part, abs=1e-12) for part in (translation, rotation)), time]
    return list(found) if method == "__iter__" else found


@pytest.mark.parametrize("name", RECORDED)
def test_answers_are_those_of_tf2(name: str) -> None:
    recorded = RECORDED[name]
    logged: list[str] = []
    frames = Frames(recorded["keep"], logged.append, logged.append)
    for method, args, expected in recorded["steps"]:
        assert answer(frames, method, args) == expected, (method, args)
    assert logged == recorded["logged"]


@pytest.mark.parametrize("name", RECORDED_NOETIC)
def test_answers_are_those_of_tf2_in_ros1(name: str) -> None:
    recorded = RECORDED_NOETIC[name]
    frames = NoeticFrames(recorded["keep"], str, str)
    for method, args, expected in recorded["steps"]:
        found = answer(frames, method, args)
        assert ("" if found is None and expected == "" else found) == expected, (method, args)
