"""What the message classes of ROS 1 say to random values: run with the real genpy and with rosspin's classes.

``python message_probe.py SEED PACKAGE [SOURCE]``: PACKAGE is the folder of odd_msgs, with definitions that the packages
of ROS lack; with rosspin's SOURCE its classes are used. Prints one JSON object: for each message a list of [what was
done, what came of it]. Both draw the same values from the seed.
"""

from __future__ import annotations

import importlib
import io
import json
import math
import random
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

PACKAGES = [
    "std_msgs",
    "geometry_msgs",
    "sensor_msgs",
    "nav_msgs",
    "rosgraph_msgs",
    "actionlib_msgs",
    "diagnostic_msgs",
    "trajectory_msgs",
    "visualization_msgs",
]
TEXTS = ["", "a", "a b", 'say "a"\n', "ä € 😀", "true", "1.0", "- x", "word " * 40, "a" * 100, "\t\\n", "#", "x: y"]
FLOATS = [0.0, -0.0, 1.5, 0.1, 1e30, 1e-300, math.inf, -math.inf, math.nan, 3, True]


def message_class(name: str) -> Any:
    package, _, short = name.partition("/")
    return getattr(importlib.import_module(f"{package}.msg"), short)


def draw(type_: str, draws: random.Random) -> Any:
    """A random value of a type as in float64[9]."""
    base, bracket, length = type_.partition("[")
    if bracket:
        count = int(length[:-1]) if length != "]" else draws.randrange(4)
        if base in ("uint8", "char") and draws.random() < 0.5:
            return bytes(draws.randrange(256) for _ in range(count))
        return draws.choice([list, tuple])(draw(base, draws) for _ in range(count))
    if base in ("float32", "float64"):
        return draws.choice([*FLOATS, draws.uniform(-1e3, 1e3)])
    if base == "string":
        return draws.choice(TEXTS)
    if base == "bool":
        return draws.choice([True, False, 0, 1])
    if base in ("time", "duration"):
        return type(message_class(f"std_msgs/{base.title()}")().data)(draws.randrange(2**31), draws.randrange(10**9))
    if "int" in base or base in ("byte", "char"):
        bits = int("".join(filter(str.isdigit, base)) or 8)
        lowest = 0 if base[0] == "u" or base == "char" else -(2 ** (bits - 1))
        return draws.choice([lowest, lowest + 2**bits - 1, draws.randrange(lowest, lowest + 2**bits), 0, 1])
    return fill(message_class(base)(), draws)


def fill(message: Any, draws: random.Random) -> Any:
    for name, type_ in zip(message.__slots__, message._slot_types):
        setattr(message, name, draw(type_, draws))
    return message


def outcome(do: Callable[[], object]) -> str:
    """A result as text, or the error: its class and its words."""
    try:
        return str(do())
    except Exception as error:
        return f"{type(error).__module__}.{type(error).__name__}: {error}"


def sent(message: Any) -> bytes:
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def shape(value: Any) -> Any:
    """A value with the types of all its parts."""
    if hasattr(value, "secs"):
        return [type(value).__name__, shape(value.secs), shape(value.nsecs)]
    if hasattr(value, "__slots__") and not isinstance(value, (int, float)):
        name = getattr(value, "_type", type(value).__name__)
        return [name, *(shape(getattr(value, slot, None)) for slot in value.__slots__ if slot[0] != "_")]
    if isinstance(value, (list, tuple)):
        return [type(value).__name__, *map(shape, value)]
    return f"{type(value).__name__} {value!r}"


def wrong_values() -> list[Any]:
    other = message_class("std_msgs/String")("hi")
    header = message_class("std_msgs/Header")()
    time = type(message_class("std_msgs/Time")().data)(1, 2)
    return [
        *[-1, 2**8, 2**70, -(2**70), 1.5, True, math.nan, "x", "ä", b"x", b"", None, {}, object],
        *[[], [1], (1,), ["a"], ("a",), [None], [256], [-1], [1.5], [[1]], [True, 2], [b"x"], "ab", bytearray(b"x")],
        *[other, header, time, [other], [header], [time], [1] * 36, [other, 1]],
    ]


def paths(message: Any, prefix: str = "") -> Iterator[tuple[Any, str, str]]:
    """The fields of a message, and of its nested ones: (owner, name, path)."""
    for name in message.__slots__:
        yield message, name, prefix + name
        inner = getattr(message, name)
        if hasattr(inner, "__slots__") and hasattr(inner, "_type"):
            yield from paths(inner, f"{prefix}{name}.")
        elif isinstance(inner, (list, tuple)) and inner and hasattr(inner[0], "_type"):
            yield from paths(inner[0], f"{prefix}{name}[0].")
        elif hasattr(inner, "secs"):
            yield from ((inner, part, f"{prefix}{name}.{part}") for part in ("secs", "nsecs"))


def probe(name: str, draws: random.Random) -> list[list[str]]:
    """Everything about one message."""
    cls = message_class(name)
    said = [[what, str(getattr(cls, what))] for what in ("_type", "_md5sum", "_has_header", "__slots__", "_slot_types")]
    constants = sorted(item for item in vars(cls).items() if item[0].isupper() and isinstance(item[1], (int, str)))
    said.append(["constants", str(constants)])
    said.append(["default", str(shape(cls()))])
    said.append(["class", str(cls)])
    for _ in range(6):
        message, state = cls(), draws.getstate()
        fill(message, draws)
        said.append(["str", outcome(lambda: message)])
        said.append(["repr", outcome(lambda: repr(message))])
        said.append(["bytes", outcome(lambda: sent(message).hex())])
        said.append(["read", outcome(lambda: shape(cls().deserialize(sent(message))))])
        said.append(["read, str", outcome(lambda: cls().deserialize(sent(message)))])
        for part in (0, 3, 10, 40):
            said.append([f"read {part}", outcome(lambda: shape(cls().deserialize(sent(message)[:part])))])
        said.append(["equal to what was sent", outcome(lambda: cls().deserialize(sent(message)) == message)])
        again = random.Random()
        again.setstate(state)
        said.append(["equal to the same", outcome(lambda: fill(cls(), again) == message)])
        said.append(["equal to another", outcome(lambda: (cls() == message, cls() != message, message == 3))])
        values = [getattr(message, slot) for slot in message.__slots__]
        said.append(["by position", outcome(lambda: cls(*values))])
        said.append(["by keyword", outcome(lambda: cls(**dict(zip(message.__slots__[:2], values))))])
    said.append(["hash", outcome(lambda: hash(cls()))])
    said.append(["too many", outcome(lambda: cls(*range(len(cls.__slots__) + 1)))])
    said.append(["too few", outcome(lambda: cls(*range(2, len(cls.__slots__) + 1)))])
    said.append(["unknown", outcome(lambda: cls(nope=1))])
    said.append(["both", outcome(lambda: cls(1, nope=1))])
    said.append(["new attribute", outcome(lambda: setattr(cls(), "nope", 1))])
    said.append(["pickled", outcome(lambda: shape(__import__("pickle").loads(__import__("pickle").dumps(cls()))))])
    message = fill(cls(), draws)
    wrong, places = wrong_values(), list(paths(message))
    for owner, slot, path in draws.sample(places, min(12, len(places))):
        right = getattr(owner, slot)
        # A time multiplies what it holds by 1e9, be it a list.
        values = wrong if hasattr(owner, "_type") else [value for value in wrong if not hasattr(value, "__len__")]
        for value in draws.sample(values, 10):
            setattr(owner, slot, value)
            about = f"{path} = {type(value).__name__} {str(value)[:20]}"
            said.append([about, outcome(lambda: sent(message).hex())])
            said.append([f"{about}, checked", outcome(lambda: message._check_types())])
            said.append([f"{about}, str", outcome(lambda: owner)])
        if draws.random() < 0.7:  # else it stays wrong: a second fault, and how far the check gets
            setattr(owner, slot, right)
    return said


def generate(package: Path) -> None:
    """Have genpy write its modules of odd_msgs; std_msgs/Header lies there, too, as Debian has no .msg files."""
    from genpy.generator import MsgGenerator

    out = package / "generated" / "odd_msgs" / "msg"
    files = sorted((package / "msg").glob("*.msg"))
    search = {"odd_msgs": [str(package / "msg")], "std_msgs": [str(package / "std_msgs")]}
    assert not MsgGenerator().generate_messages("odd_msgs", [str(file) for file in files], str(out), search)
    (out / "__init__.py").write_text("".join(f"from ._{file.stem} import {file.stem}\n" for file in files))
    sys.path.insert(0, str(package / "generated"))


def main(seed: str, package: str, source: str | None = None) -> None:
    if source:
        sys.path.insert(0, source)
        from rosspin.messages import MessageFinder

        sys.meta_path.insert(0, MessageFinder(1, Path(package)))
    else:
        generate(Path(package))
    answers, texts = {}, {}
    for package in [*PACKAGES, "odd_msgs"]:
        module = importlib.import_module(f"{package}.msg")
        names = getattr(module, "__all__", [name for name in vars(module) if isinstance(getattr(module, name), type)])
        for name in sorted(names):
            answers[f"{package}/{name}"] = probe(f"{package}/{name}", random.Random(f"{seed} {package} {name}"))
            texts[f"{package}/{name}"] = message_class(f"{package}/{name}")._full_text
    json.dump({"python": sys.version_info[:2], "answers": answers, "texts": texts}, sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
