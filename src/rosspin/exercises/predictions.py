"""Judge predictions and choices: the judges of answers that are not run as nodes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from .feedback import Finding
from .judging import Answer, Judge, a_value, above, plain, say
from .observed import Value

__all__ = ["chosen", "predicted", "same"]

Prediction = tuple[str, Sequence[float], str, Mapping[tuple[float, ...], str]]
"""What a variable stands for, in words; the right numbers; the hint for whoever gives others; and the numbers that
follow from wrong beliefs, with what to say to whoever holds one (no more than the hint if that is empty)."""

# What can be asked for: how to say one number, what to call a list of them, and an example.
_ASKED = {
    "times": (say, "times in seconds", "[1.0, 2.0, 3.0]"),
    "counters": (lambda number: f"{number:g}", "counters", "[1, 2, 3]"),
    "numbers": (lambda number: f"{number:g}", "numbers", "[1, 1, 2, 2]"),
}
_NTH = ("the first", "the second", "the third", "the fourth")
_LETTER = re.compile(r"\W*([A-Z])(?=\W*$|\s*[:.,;)*-](?!\W*[A-Z]\W*$))", re.IGNORECASE)  # not two of them
_LEAST = 3  # of so many numbers it is said which one is wrong


def predicted(asked: str = "times", /, **predictions: Prediction) -> Judge:
    """Judge whether variables are lists of the right numbers: "times" (s), "counters" or "numbers", as ``asked``."""

    def judge(answer: Answer) -> Iterator[Finding]:
        variables = answer.variables(*predictions)
        for variable, prediction in predictions.items():
            value, what = variables.get(variable), prediction[0]
            if value is None or value.is_open:
                yield Finding(None, f"{what}: there is no prediction yet.", f"Give `{variable}` a list of {asked}.")
            elif value.numbers is None:
                _, listed, example = _ASKED[asked]
                other = a_value(value.type)
                if value.type in ("list", "tuple"):
                    other = "one that holds something else"
                text = f"{what}: the prediction is a list of {listed}, not {other}."
                yield Finding(False, text, f"Write it as `{example}`.")
            else:
                yield _compare(value.numbers, prediction, asked)

    return judge


def _compare(given: Sequence[float], prediction: Prediction, asked: str) -> Finding:
    what, right, hint, beliefs = prediction
    say_one = _ASKED[asked][0]
    said = ", ".join(map(say_one, given)) or "nothing at all"
    if same(given, right):
        return Finding(True, f"{what}: {said}.")
    if asked == "times" and same([number / 1000 for number in given], right):
        return Finding(False, f"{what}: not {said}.", "These are milliseconds, and a time is asked for in seconds.")
    why = next((why for wrong, why in beliefs.items() if same(given, wrong)), None)
    if why is None and len(given) != len(right) >= _LEAST:
        more = len(right) - len(given)
        if given and more > 0 and same(given, right[: len(given)]):
            hint = f"These are right, and {'one more is' if more == 1 else f'{more} more are'} asked for."
        elif same(given[: len(right)], right):
            hint = f"The first {len(right)} are right, and no more are asked for."
        return Finding(False, f"{what}: {len(right)} {asked} are asked for, not {len(given)}.", hint)
    pairs = zip(given, right, strict=False)
    first = next((n for n, (one, other) in enumerate(pairs) if not same([one], [other])), min(len(given), len(right)))
    known = why is not None or first >= len(given) or len(right) < _LEAST
    text = f"not {said}" if known else f"{_NTH[first]} of these {asked} is not {say_one(given[first])}"
    return Finding(False, f"{what}: {text}.", why or hint, _beside(given, right, first, say_one))


def _beside(
    given: Sequence[float], right: Sequence[float], first: int, say_one: Callable[[float], str]
) -> tuple[str, ...]:
    """Show what a run gives above what was given, up to the ``first`` that differs: the others are left to find."""
    come = [say_one(number) for number in right[: first + 1]]
    if len(right) <= first:
        come.append("nothing more" if first else "nothing")
    elif len(right) > first + 1:
        come.append("...")
    return above(**{"the run": come, "you": [say_one(number) for number in given] or ["nothing"]})


def same(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether two lists have the same numbers, as precisely as a reader means them."""
    return len(one) == len(other) and all(abs(a - b) < 0.01 for a, b in zip(one, other, strict=True))


def chosen(choices: Mapping[str, str], /, **right: str) -> Judge:
    """Judge whether variables are the right letters. ``choices`` say what would be seen if a letter were right."""

    def judge(answer: Answer) -> Iterator[Finding]:
        variables = answer.variables(*right)
        for variable, letter in right.items():
            value = variables.get(variable)
            if value is None or value.is_open:
                yield Finding(None, f"`{variable}`: there is no answer yet.")
                continue
            found = _LETTER.match(value.text)
            named = found[1].upper() if found and value.type == "str" else ""
            if named not in choices:
                letters = f"one of the letters A to {max(choices)}"
                text = f"`{variable}`: the answer is {letters}, not `{plain(_shown(value))}`."
                yield Finding(False, text, 'Write it as `"A"`.')
            elif named != letter:
                yield Finding(False, f"`{variable}`: it is not {named}.", choices[named])
            else:
                yield Finding(True, f"`{variable}`: it is {named}.")

    return judge


def _shown(value: Value) -> str:
    return repr(value.text) if value.type == "str" else value.text or value.type
