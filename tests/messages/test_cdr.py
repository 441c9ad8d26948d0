"""Messages as bytes: what of CDR no scenario holds. The bytes come from the real ROS 2, recorded on Jazzy."""

from __future__ import annotations

import pytest

from rosspin.messages.cdr import CDRError, deserialize, room, serialize
from rosspin.messages.library import Library
from rosspin.messages.ros2 import Message, Messages


@pytest.fixture(scope="module")
def messages() -> Messages:
    return Messages(Library(2))


def make(messages: Messages, name: str, **fields: object) -> Message:
    kind: type[Message] = messages[name]
    return kind(**fields)


def test_a_wide_string_has_four_bytes_for_each_unit_and_room_for_one_more(messages: Messages) -> None:
    message = make(messages, "example_interfaces/WString", data="aä𝄞")
    data = serialize(message)
    assert data.hex(" ", 4) == "00010000 04000000 61000000 e4000000 34d80000 1edd0000"
    assert deserialize(data, type(message)) == message
    assert room(message) == len(data) + 4


def test_a_number_after_a_shorter_one_is_aligned(messages: Messages) -> None:
    message = make(messages, "sensor_msgs/NavSatStatus", status=-1, service=7)
    assert serialize(message) == b"\0\1\0\0" + b"\xff\0\7\0"
    big = b"\0\0\0\0" + b"\xff\0\0\7"
    assert deserialize(big, type(message)) == message


@pytest.mark.parametrize("data", [b"", b"\0\2\0\0\0\0\0\0", b"\0\1\0\0\xff\xff\xff\xff", b"\0\1\0\0\2\0\0\0a"])
def test_bytes_that_hold_no_message_are_refused(messages: Messages, data: bytes) -> None:
    with pytest.raises(CDRError):
        deserialize(data, messages["std_msgs/String"])
