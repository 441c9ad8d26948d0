"""Read XML as tags that know where they are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

__all__ = ["Fault", "Tag", "parse"]


class Fault(ValueError):
    """What is wrong with a launch file, or not simulated. The message begins with file and line."""


@dataclass
class Tag:
    """An element, and the line on which it begins. In XML all attributes are texts."""

    name: str
    attributes: dict[str, Any]
    file: str
    line: int
    children: list[Tag] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        return "".join(self.texts)

    def fault(self, what: str) -> Fault:
        return Fault(f"{self.file}:{self.line}: {what}")


def parse(path: str) -> Tag:
    """Parse a launch file and return its root element. Raises OSError and ValueError."""
    from xml.parsers import expat  # only needed where there is a launch file

    parser = expat.ParserCreate()
    parser.buffer_text = True
    root = Tag("", {}, path, 1)
    open_tags = [root]

    def start(name: str, attributes: dict[str, str]) -> None:
        tag = Tag(name, attributes, path, parser.CurrentLineNumber)
        open_tags[-1].children.append(tag)
        open_tags.append(tag)

    parser.StartElementHandler, parser.EndElementHandler = start, lambda name: open_tags.pop()
    parser.CharacterDataHandler = lambda text: open_tags[-1].texts.append(text)
    with open(path, "rb") as file:
        try:
            parser.ParseFile(file)
        except expat.ExpatError as error:
            raise Fault(f"{path}:{error.lineno}: this is not XML: {expat.ErrorString(error.code)}") from None
        except (LookupError, ValueError) as error:
            raise Fault(f"{path}:1: this cannot be read: {error}") from None  # its encoding
    (launch,) = root.children
    if launch.name != "launch":
        raise launch.fault(f"a launch file begins with <launch>, not with <{launch.name}>")
    return launch
