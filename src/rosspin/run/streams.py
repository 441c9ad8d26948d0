"""The streams of a run: what is printed, captured in order."""

from __future__ import annotations

import codecs
import io
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import Any, TextIO

from .saved_state import one_at_a_time

__all__ = ["Capture", "Lines", "byte_stream", "capture", "nowhere"]


class Capture:
    """What is written to two streams, in order. It is also written to ``stdout`` and ``stderr``, if these are given."""

    def __init__(self, stdout: TextIO | None = None, stderr: TextIO | None = None) -> None:
        self._chunks: list[bytes] = []
        self.stdout = byte_stream(self._keep(stdout))
        self.stderr = byte_stream(self._keep(stderr))

    def __len__(self) -> int:
        """Return how many pieces were written."""
        return len(self._chunks)

    def text(self, since: int = 0) -> str:
        """Return the text, from the piece ``since`` on."""
        return b"".join(self._chunks[since:]).decode(errors="replace")

    @contextmanager
    def redirected(self) -> Iterator[None]:
        """Within this context, what is printed goes here."""
        with one_at_a_time(), redirect_stdout(self.stdout), redirect_stderr(self.stderr):
            yield

    def _keep(self, onward: TextIO | None) -> Callable[[bytes], None]:
        decode = codecs.getincrementaldecoder("utf-8")(errors="replace").decode

        def keep(data: bytes) -> None:
            self._chunks.append(data)
            if onward is not None:
                onward.write(decode(data))

        return keep


class _Sink(io.BufferedIOBase):
    """What a stream writes its bytes to; nodes that print bytes know it as ``sys.stdout.buffer``."""

    def __init__(self, take: Callable[[bytes], None]) -> None:
        self._take = take

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        self._take(bytes(data))
        return len(data)


def byte_stream(take: Callable[[bytes], None]) -> TextIO:
    """Make a stream such as ``sys.stdout``: ``take`` is called with all that is written, as UTF-8."""
    sink: Any = _Sink(take)
    return io.TextIOWrapper(sink, encoding="utf-8", errors="backslashreplace", newline="\n", write_through=True)


def nowhere() -> TextIO:
    """Make a stream that drops what is written."""
    return byte_stream(lambda data: None)


class Lines:
    """A ``stream`` of lines: ``take`` is called with each as soon as it is whole."""

    def __init__(self, take: Callable[[str], object]) -> None:
        self.stream = byte_stream(self._keep)
        self._take = take
        self._rest = b""

    def _keep(self, data: bytes) -> None:
        *lines, self._rest = (self._rest + data).split(b"\n")
        for line in lines:
            self._take(line.decode(errors="replace"))

    def flush(self) -> None:
        """Take what has been written of a last line."""
        if self._rest:
            self._keep(b"\n")


@contextmanager
def capture(stdout: TextIO | None = None, stderr: TextIO | None = None) -> Iterator[Capture]:
    """Within this context, what is printed goes to a :class:`Capture`, and from there to the streams that are given."""
    captured = Capture(stdout, stderr)
    with captured.redirected():
        yield captured
