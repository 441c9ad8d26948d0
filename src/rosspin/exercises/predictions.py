"""Judge predictions and choices: the judges of answers that are not run as nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from .feedback import Finding
from .judging import Answer, Judge, a_value, above, plain, say
from .seen import Value

__all__ = ["RIGHT", "chosen", "predicted", "same"]

RIGHT = ""
"""Marks the right numbers, in place of what to say about wrong ones."""

Meanings = Mapping[tuple[float, ...], str]

# What can be asked for: how to say one number, what to call a list of them, and an example.
_ASKED = {
    "times": (say, "times in seconds", "[1.0, 2.0, 3.0]"),
    "counters": (lambda number: f"{number:g}", "counters", "[1, 2, 3]"),
    "numbers": (lambda number: f"{number:g}", "numbers", "[1, 1, 2, 2]"),
}
_NTH = ("the first", "the second", "the third")


def predicted(predictions: Mapping[tuple[str, str, str], Meanings], asked: str = "times") -> Judge:
    """Judge whether variables are lists of the right numbers: "times" (s), "counters" or "numbers", as ``asked``.

    ``predictions`` maps each variable, given by its name, in words and with a hint, to numbers that somebody may give:
    the right ones, and those that follow from a wrong belief, with what to say to whoever holds it. The hint is for
    whoever gives other numbers.
    """

    def judge(answer: Answer) -> Iterator[Finding]:
        variables = answer.variables(*(variable for variable, *_ in predictions))
        for (variable, what, hint), meanings in predictions.items():
            value = variables.get(variable)
            if value is None or value.is_open:
                yield Finding(None, f"{what}: there is no prediction yet.", f"Give `{variable}` a list of {asked}.")
            elif value.numbers is None:
                _, listed, example = _ASKED[asked]
                text = f"{what}: the prediction is a list of {listed}, not {a_value(value.type)}."
                yield Finding(False, text, f"Write it as `{example}`.")
            else:
                yield _compare(what, value.numbers, meanings, asked, hint)

    return judge


def _compare(what: str, given: Sequence[float], meanings: Meanings, asked: str, hint: str) -> Finding:
    say_one = _ASKED[asked][0]
    said = ", ".join(map(say_one, given)) or "nothing at all"
    right = next(numbers for numbers, why in meanings.items() if why == RIGHT)
    if same(given, right):
        return Finding(True, f"{what}: {said}.")
    why = next((why for numbers, why in meanings.items() if same(given, numbers)), "")
    if not why and len(given) != len(right) == len(_NTH):
        return Finding(False, f"{what}: {len(right)} {asked} are asked for, not {len(given)}.", hint)
    pairs = zip(given, right, strict=False)
    first = next((n for n, (one, other) in enumerate(pairs) if not same([one], [other])), min(len(given), len(right)))
    known = why or first >= len(given) or len(right) < len(_NTH)
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
    """Whether two lists have the same numbers, as precisely as anybody means them."""
    return len(one) == len(other) and all(abs(a - b) < 0.01 for a, b in zip(one, other, strict=True))


def chosen(right: Mapping[str, str], choices: Mapping[str, str]) -> Judge:
    """Judge whether variables are the right letters. ``choices`` says what would be seen if a letter were right."""

    def judge(answer: Answer) -> Iterator[Finding]:
        variables = answer.variables(*right)
        for variable, letter in right.items():
            value = variables.get(variable)
            if value is None or value.is_open:
                yield Finding(None, f"`{variable}`: there is no answer yet.")
                continue
            named = value.text.strip(" ().").upper() if value.type == "str" else ""
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
