"""What a check says about an answer."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import NamedTuple

from ..vehicle.drives import Drive

__all__ = ["Feedback", "Finding"]

_WORDS = {True: "Right", False: "Wrong", None: "Open"}


class Finding(NamedTuple):
    """One thing about an answer: whether it is right, and what it is (Markdown). ``hint`` says how to continue.

    If nothing has been answered yet, ``right`` is None. ``ticks`` are the lines of a picture in plain text: what came
    above what should have come.
    """

    right: bool | None
    text: str
    hint: str = ""
    ticks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Feedback:
    """What a check has found, shown as Markdown in a notebook and as text elsewhere.

    ``number`` is the exercise's, ``findings`` are in the order in which they were made, ``hint`` says how to continue,
    ``console`` is what the node printed in its first run, as far as it is worth showing. If the node did more than was
    looked at, the last finding says so, and ``whole`` is false. ``progress`` says what else has been solved.
    ``drive`` is what the vehicle did in the first run, if one ran with the node.
    """

    number: int
    findings: tuple[Finding, ...]
    hint: str
    console: str = field(default="", repr=False)
    progress: str = ""
    whole: bool = True
    drive: Drive = field(default=Drive((), ()), repr=False)

    @property
    def passed(self) -> bool:
        """Whether everything is right."""
        return bool(self.findings) and all(finding.right for finding in self.findings)

    @property
    def is_open(self) -> bool:
        """Whether nothing is wrong, but something has not been answered yet."""
        return not self.passed and all(finding.right is not False for finding in self.findings)

    @property
    def verdict(self) -> str:
        """The verdict in words: right, or not yet."""
        return f"Exercise {self.number}: {'right' if self.passed else 'not yet'}."

    def _repr_markdown_(self) -> str:
        lines = [f"**{self.verdict}**", ""]
        said = set()
        for right, text, hint, ticks in self.findings:
            lines.append(f"- {_WORDS[right]}: {text[0].upper()}{text[1:]}")
            if ticks:
                lines += ["", *(f"      {line}" for line in ticks), ""]
            if right is False and hint and hint not in said:
                lines += ["", f"  **Hint:** {hint}", ""]
                said.add(hint)
        if not self.passed and self.hint not in said:
            lines += ["", f"**Hint:** {self.hint}"]
        if self.progress:
            lines += ["", self.progress]
        return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip()

    def __repr__(self) -> str:
        return self._repr_markdown_().replace("**", "").replace("\n\n", "\n")

    __str__ = __repr__
