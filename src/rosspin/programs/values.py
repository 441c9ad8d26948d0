"""Values as a C++ node and its host exchange them: text in which each character is a byte (see runtime/host.cpp)."""

from __future__ import annotations

from typing import Any

__all__ = ["packed", "unpacked"]


def packed(value: Any) -> str:
    """Write a value: None, a bool, a number, a text, bytes, a list or a dictionary."""
    match value:
        case None:
            return "n"
        case bool():
            return "t" if value else "f"
        case int():
            return f"i{value};"
        case float():
            return f"d{value!r};"
        case str():
            data = value.encode(errors="surrogateescape").decode("latin-1")
            return f"s{len(data)}:{data}"
        case bytes():
            return f"b{len(value)}:{value.decode('latin-1')}"
        case list() | tuple():
            return f"l{''.join(map(packed, value))}e"
        case dict():
            return f"m{''.join(packed(str(name)) + packed(each) for name, each in value.items())}e"
    raise TypeError(f"{value!r} cannot be given to a C++ node")


def unpacked(text: str) -> list[Any]:
    """Read all values of a text."""
    values, at = [], 0
    while at < len(text):
        value, at = _read(text, at)
        values.append(value)
    return values


def _read(text: str, at: int) -> tuple[Any, int]:
    kind, at = text[at], at + 1
    if kind in "ntf":
        return {"n": None, "t": True, "f": False}[kind], at
    if kind in "id":
        end = text.index(";", at)
        return (int if kind == "i" else float)(text[at:end]), end + 1
    if kind in "sb":
        colon = text.index(":", at)
        end = colon + 1 + int(text[at:colon])
        data = text[colon + 1 : end].encode("latin-1")
        return data if kind == "b" else data.decode(errors="surrogateescape"), end
    items = []
    while text[at] != "e":
        item, at = _read(text, at)
        items.append(item)
    return (items if kind == "l" else dict(zip(items[::2], items[1::2], strict=True))), at + 1
