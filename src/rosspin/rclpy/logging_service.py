"""The services by which others read and set log levels (source: rclpy/logging_service.py)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .logging import get_logger_level, set_logger_level

if TYPE_CHECKING:
    from .node import Node

__all__ = ["LoggingService"]


class LoggingService:
    """Offers ``get_logger_levels`` and ``set_logger_levels`` below a node's name."""

    def __init__(self, node: Node) -> None:
        types = import_module("rcl_interfaces.srv")
        name = node.get_name()
        node.create_service(types.GetLoggerLevels, f"{name}/get_logger_levels", self._get)
        node.create_service(types.SetLoggerLevels, f"{name}/set_logger_levels", self._set)

    def _get(self, request: Any, response: Any) -> Any:
        kind = import_module("rcl_interfaces.msg").LoggerLevel
        response.levels = [kind(name=name, level=get_logger_level(name)) for name in request.names]
        return response

    def _set(self, request: Any, response: Any) -> Any:
        kind = import_module("rcl_interfaces.msg").SetLoggerLevelsResult
        for asked in request.levels:
            result = kind(successful=True)
            try:
                set_logger_level(asked.name, asked.level)
            except ValueError:
                result = kind(successful=False, reason="Failed reason: Invalid logger level.")
            response.results.append(result)
        return response
