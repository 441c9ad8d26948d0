"""Make a program small enough for a page: without names that are never seen, or what a node hardly ever calls."""

from __future__ import annotations

import re
from collections.abc import Iterator

__all__ = ["lean"]

_CUSTOM, _IMPORTS, _CODE, _DATA = 0, 2, 10, 11

# What the C++ library links into each program that prints: wide characters, money, dates, catalogues of messages. How
# their objects are made is left in, as each program makes them when it starts.
_ARGUMENTS = r"(?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*>::"
_UNCALLED = re.compile(
    r"\bstd::__2::(?:__)?(?:"
    rf"(money_get|money_put|moneypunct|messages|time_get|time_get_c_storage|time_put)<{_ARGUMENTS}"
    rf"|(num_get|num_put|numpunct|ctype|collate)<wchar_t{_ARGUMENTS}"
    rf"|(codecvt)<char(?:8|16|32)_t{_ARGUMENTS})"
    r"(?!(?:__)?(?:\1|\2|\3)\b)\w"
    r"|\bstd::__2::(?:utf|ucs)\d+_to_\w+\(|\bbasic_string<wchar_t,|^__strftime|\b__time_put::__do_put\("
    r"|\bcodecvt<wchar_t, char, __mbstate_t>::do_(?:in|out|length|unshift)\("
    r"|^(?:mbsn?rtowcs|wcsnrtombs|week_num|__mo_lookup)$"
    r"|\b__(?:double_or_nothing|get_up_to_n_digits|pad_and_output)\[\w+:\w+\]<wchar_t"
)
# How numbers are read, from a stream and if they are hexadecimal, which is as long as a fourth of that.
_OF_INPUT = re.compile(
    r"^std::__2::istreambuf_iterator<.*\bnum_get<|\bnum_get<.*>::do_get\(|\b__num_get(?:_|\b)|^(?:vs?f?scanf|hexfloat)$"
    r"|\b__(?:get_up_to_n_digits|scan_keyword)\b"
)
_READS = re.compile(r">>|\bcin\b|istream|lexical_cast|get_time|scanf|strto|ato[fil]|sto[dfil]")

# How a node that does call the others asks for it.
_CALLED = re.compile(
    r"\bw(?:char_t|string|cout|cerr|clog|cin|\w*stream)\b|char(?:8|16|32)_t|\b[uU]?L\"|money|(?:_|strf)time\b|<codecvt>|<format>|messages<"
)

# The names of the node's own functions: a timer is named after its callback, and the place of a fault is told by it.
_OWN = re.compile(
    r"(?:\(anonymous namespace\)::)?(?![^(]*\b(?:std|rosspin|rclcpp|rcl_interfaces|ros|boost|__cxxabiv1)::)"
    r"(?!operator |decltype|void \(|rcutils|non-virtual|\S* strip_|__)[^(]+\(.*\)"
)

# The name of a type, which is kept for each kind of pointer whose use is checked.
_TYPE = re.compile(rb"(?<=\xff\xff\0\0)'[^\0]+")

_UNREACHABLE = b"\0\0\x0b"


def lean(program: bytes, text: str) -> bytes:
    """Return a program that does what the one made of ``text`` does."""
    sections = [*_sections(program)]
    names: dict[int, str] = {}
    for kind, data in sections:
        if kind == _CUSTOM and data.startswith(b"\x04name"):
            names = dict(_names(data[5:]))
    imported = next((_read(data, 0)[0] for kind, data in sections if kind == _IMPORTS), 0)
    patterns = [uncalled for uncalled, called in ((_UNCALLED, _CALLED), (_OF_INPUT, _READS)) if not called.search(text)]
    uncalled = {number for number, name in names.items() if any(each.search(name) for each in patterns)}
    made = program[:8]
    for kind, data in sections:
        if kind == _CODE:
            made += _section(kind, _code(data, {number - imported for number in uncalled}))
        elif kind == _DATA:
            made += _section(kind, _TYPE.sub(lambda name: bytes(len(name[0])), data))
        elif kind != _CUSTOM:
            made += _section(kind, data)
    own = sorted((number, name) for number, name in names.items() if _OWN.fullmatch(name))
    table = _number(len(own)) + b"".join(_number(number) + _sized(name.encode()) for number, name in own)
    return made + _section(_CUSTOM, _sized(b"name") + b"\x01" + _sized(table))


def _code(data: bytes, uncalled: set[int]) -> bytes:
    count, at = _read(data, 0)
    made = [_number(count)]
    for number in range(count):
        size, at = _read(data, at)
        made.append(_sized(_UNREACHABLE if number in uncalled else data[at : at + size]))
        at += size
    return b"".join(made)


def _names(data: bytes) -> Iterator[tuple[int, str]]:
    """Read the names of functions, by their numbers."""
    at = 0
    while at < len(data):
        kind = data[at]
        size, at = _read(data, at + 1)
        end = at + size
        if kind == 1:
            count, at = _read(data, at)
            for _ in range(count):
                number, at = _read(data, at)
                length, at = _read(data, at)
                yield number, data[at : at + length].decode()
                at += length
        at = end


def _sections(program: bytes) -> Iterator[tuple[int, bytes]]:
    at = 8
    while at < len(program):
        kind = program[at]
        size, at = _read(program, at + 1)
        yield kind, program[at : at + size]
        at += size


def _section(kind: int, data: bytes) -> bytes:
    return bytes([kind]) + _sized(data)


def _sized(data: bytes) -> bytes:
    return _number(len(data)) + data


def _read(data: bytes, at: int) -> tuple[int, int]:
    """Read a number; return it, and where it ends."""
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            return value, at


def _number(value: int) -> bytes:
    made = b""
    while value > 127:
        made += bytes([value & 127 | 128])
        value >>= 7
    return made + bytes([value])
