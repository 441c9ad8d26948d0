"""What is said of an answer."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

__all__ = ["Feedback", "Finding"]

_WORDS = {True: "Right", False: "Wrong", None: "Open"}


class Finding(NamedTuple):
    """One thing about an answer: whether it is right, and in words (Markdown) what it is. ``hint`` is how to go on.

    Where nothing has been answered yet, ``right`` is None.
    """

    right: bool | None
    text: str
    hint: str = ""


@dataclass(frozen=True)
class Feedback:
    """What a check has found; it shows itself as Markdown in a notebook and as text elsewhere.

    ``number`` is that of the exercise, ``findings`` are in the order in which they were made, ``hint`` is how to go on,
    ``console`` is what the node printed in its first run, as far as it is worth showing. If not all that the node did
    could be looked at, the last finding says so, and ``whole`` is false. ``progress`` says what else has been solved.
    """

    number: int
    findings: tuple[Finding, ...]
    hint: str
    console: str = field(default="", repr=False)
    progress: str = ""
    whole: bool = True

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
        """Right or not yet, in words."""
        return f"Exercise {self.number}: {'right' if self.passed else 'not yet'}."

    def _repr_markdown_(self) -> str:
        lines = [f"**{self.verdict}**", ""]
        for right, text, _ in self.findings:
            lines.append(f"- {_WORDS[right]}: {text[0].upper()}{text[1:]}")
        if not self.passed:
            lines += ["", f"**Hint:** {self.hint}"]
        if self.progress:
            lines += ["", self.progress]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return self._repr_markdown_().replace("**", "").replace("\n\n", "\n")

    __str__ = __repr__
