"""What every handle of rclpy's C++ module has (source: rclpy/destroyable.py)."""

from __future__ import annotations

from types import TracebackType
from typing import Protocol

__all__ = ["DestroyableType"]


class DestroyableType(Protocol):
    """A type for annotations: something that is destroyed as soon as nothing uses it any more."""

    def __enter__(self) -> None: ...

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exctb: TracebackType | None
    ) -> None: ...

    def destroy_when_not_in_use(self) -> None: ...
