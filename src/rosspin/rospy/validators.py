"""Checks of arguments, made once and called with each argument (source: rospy/impl/validators.py)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["ParameterInvalid", "Validator", "non_empty"]

Validator = Callable[[Any, Any], Any]


class ParameterInvalid(Exception):
    """An argument is not what it should be."""

    def __init__(self, message: object) -> None:
        self._message = message

    def __str__(self) -> str:
        return str(self._message)


def non_empty(param_name: str) -> Validator:
    """Return a check of ``param_name``: it returns an argument that is true, and raises ParameterInvalid for others."""

    def validator(param: Any, context: Any) -> Any:
        if not param:
            raise ParameterInvalid(f"ERROR: parameter [{param_name}] must be specified and non-empty")
        return param

    return validator
