"""Compare what was predicted, or chosen, with what is right."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from .feedback import Finding
from .judging import Answer, a_value, plain, say
from .seen import Value

__all__ = ["Beliefs", "Prediction", "as_number", "as_whole", "choose", "compare", "same"]

# Numbers that a wrong belief predicts, and what to say to whoever predicts them.
Beliefs = Mapping[tuple[float, ...], str]

# What can be asked for: how a number is said, what a list of them is, and an example.
_ASKED = {
    "times": (say, "times in seconds", "[1.0, 2.0, 3.0]"),
    "counters": (lambda number: f"{number:g}", "counters", "[1, 2, 3]"),
}


class Prediction(NamedTuple):
    """A variable that is asked for: in words what it is, the numbers that are right, and wrong ones.

    ``asked`` says what the numbers are: "times" (s) or "counters".
    """

    variable: str
    what: str
    real: Sequence[float]
    beliefs: Beliefs
    asked: str = "times"


def compare(answer: Answer, predictions: Sequence[Prediction]) -> Iterator[Finding]:
    """Whether each variable is the numbers that are right; of a wrong belief it is said why it is wrong."""
    variables = answer.variables(*(prediction.variable for prediction in predictions))
    for prediction in predictions:
        variable, what, _, _, asked = prediction
        _, listed, example = _ASKED[asked]
        value = variables.get(variable)
        if value is None or value.is_open:
            yield Finding(None, f"{what}: there is no prediction yet.", f"Give `{variable}` a list of {asked}.")
            continue
        if value.numbers is None:
            text = f"{what}: the prediction is a list of {listed}, not {a_value(value.type)}."
            yield Finding(False, text, f"Write it as `{example}`.")
        else:
            yield _compare_numbers(prediction, value.numbers)


def _compare_numbers(prediction: Prediction, predicted: Sequence[float]) -> Finding:
    _, what, real, beliefs, asked = prediction
    say_one = _ASKED[asked][0]
    said = ", ".join(map(say_one, predicted)) or "nothing at all"
    if same(predicted, real):
        return Finding(True, f"{what}: {said}.")
    for numbers, why in beliefs.items():
        if same(predicted, numbers):
            return Finding(False, f"{what}: not {said}.", why)
    if not real:
        return Finding(False, f"{what}: not {said}.")
    if len(predicted) != len(real):
        return Finding(False, f"{what}: {len(real)} {asked} are asked for, not {len(predicted)}.")
    wrong = next(n for n, pair in enumerate(zip(predicted, real, strict=True)) if not same(pair[:1], pair[1:]))
    return Finding(False, f"{what}: {_NTH[wrong]} of these {asked} is not {say_one(predicted[wrong])}.")


_NTH = ("the first", "the second", "the third")


def same(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether two lists are of the same numbers, as far as anybody means them."""
    return len(one) == len(other) and all(abs(a - b) < 0.01 for a, b in zip(one, other, strict=True))


def choose(answer: Answer, right: Mapping[str, str], choices: Mapping[str, str]) -> Iterator[Finding]:
    """Whether each variable is the right letter; ``choices`` has what would be seen if it were another."""
    variables = answer.variables(*right)
    for variable, letter in right.items():
        value = variables.get(variable)
        if value is None or value.is_open:
            yield Finding(None, f"`{variable}`: there is no answer yet.")
            continue
        named = value.text.strip(" ().").upper() if value.type == "str" else ""
        if named not in choices:
            text = f"`{variable}`: the answer is one of the letters A to {max(choices)}, not `{plain(_shown(value))}`."
            yield Finding(False, text, 'Write it as `"A"`.')
        elif named != letter:
            yield Finding(False, f"`{variable}`: it is not {named}.", choices[named])
        else:
            yield Finding(True, f"`{variable}`: it is {named}.")


def _shown(value: Value) -> str:
    return repr(value.text) if value.type == "str" else value.text or value.type


def as_number(text: str) -> float | None:
    """A text as a number; None if it is none, or not finite."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def as_whole(text: str) -> int | None:
    """A text of digits as a number; None if it is none."""
    return int(text) if text.isascii() and text.isdigit() and len(text) < 20 else None
