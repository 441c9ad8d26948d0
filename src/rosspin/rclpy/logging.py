"""Loggers and the lines that they print (sources: rclpy/logging.py, rclpy/impl/rcutils_logger.py, rcutils)."""

from __future__ import annotations

import math
import os
import re
import sys
import time
from collections.abc import Callable
from enum import IntEnum
from pathlib import Path
from types import FrameType
from typing import Any, NamedTuple

from ..clocks.clock import NS
from ..world.world import World, current_world
from .arguments import LEVELS, Arguments

__all__ = [
    *("LoggingSeverity", "RcutilsLogger", "clear_config", "get_logger", "get_logger_effective_level"),
    *("get_logger_level", "get_logging_directory"),
    *("get_logging_severity_from_string", "set_logger_level"),
]


class LoggingSeverity(IntEnum):
    """How serious a message is."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


# Publishes a message: its severity, its logger's name, its text, and the line and the code that logged it.
Publish = Callable[[int, str, str, int, Any], None]

_COLOURS = {10: "\033[32m", 20: "\033[0m", 30: "\033[33m", 40: "\033[31m", 50: "\033[31m"}
_DEFAULT_FORMAT = "[{severity}] [{time}] [{name}]: {message}"

# The options of a log call, by filter, in the order in which the filters are applied.
_FILTERS = {
    "throttle": ("throttle_duration_sec", "throttle_time_source_type"),
    "skip_first": ("skip_first",),
    "once": ("once",),
}
_OPTIONS = [option for options in _FILTERS.values() for option in options]


class _Call:
    """A log call in one line of the node: its settings, which must not change, and what it has logged so far."""

    def __init__(self, settings: tuple[Any, ...], options: dict[str, Any]) -> None:
        self.settings = settings
        self.options = options
        self.calls = 0
        clock = options.get("throttle_time_source_type")
        # When it logged, in ns. rclpy begins with 0, which is long ago for all clocks but a simulator's.
        self.last = 0 if getattr(clock, "ros_time_is_active", False) else -math.inf

    def is_wanted(self) -> bool:
        """Whether the filters let this call through. Each is asked only if those before it let it through."""
        if self.options.get("throttle_duration_sec"):
            clock = self.options.get("throttle_time_source_type")
            now = logs().clock.system() if clock is None else clock.now().nanoseconds
            if now < self.last + self.options["throttle_duration_sec"] * 1e9:
                return False
            self.last = now
        self.calls += 1
        if self.options.get("skip_first"):
            return self.calls > 1 and not (self.options.get("once") and self.calls > 2)
        return not self.options.get("once") or self.calls == 1


class _Form(NamedTuple):
    """The format of lines, whether they go to stdout, and whether they are coloured (None: on a terminal)."""

    line: str
    to_stdout: bool
    coloured: bool | None


class Logs:
    """What a process logs, from which level on, and how."""

    ROS = 2

    def __init__(self, world: World) -> None:
        self.clock = world.clock
        self.level = 20  # INFO
        self.levels: dict[str, int] = {}
        self.console = True
        self.root_logger: RcutilsLogger | None = None
        self.rosout: dict[str, Publish] | None = {}  # what publishes for a logger; None: nothing may
        self.is_over = False  # whether its contexts have ended, so that nothing can be published
        self.form: _Form | None = None  # None: not looked up yet


def logs() -> Logs:
    """The logs of the calling process. Raises RuntimeError outside a run."""
    return current_world().part(Logs)


class RcutilsLogger:
    """A logger. Its level is the nearest one that is set: of ``a.b``, of ``a``, or the default."""

    def __init__(self, name: str = "") -> None:
        self.name = name
        self._rosspin_logs = logs()
        self._rosspin_calls: dict[tuple[str, int, int], _Call] = {}

    def __reduce__(self) -> tuple[type[RcutilsLogger], tuple[str]]:
        """Let it be copied deeply and pickled, as rclpy's can."""
        return RcutilsLogger, (self.name,)

    def get_child(self, name: str) -> RcutilsLogger:
        """Return the logger with this name below this one. Raises ValueError if the name is empty."""
        if not name:
            raise ValueError("Child logger name must not be empty.")
        child = RcutilsLogger(f"{self.name}.{name}" if self.name else name)
        if self._rosspin_logs.rosout and self.name in self._rosspin_logs.rosout:
            self._rosspin_logs.rosout[child.name] = self._rosspin_logs.rosout[self.name]
        return child

    def set_level(self, level: int) -> None:
        """Print only what is at least so serious. Raises ValueError if there is no such level."""
        set_logger_level(self.name, level)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the lowest severity that is printed."""
        return LoggingSeverity(_effective(self._rosspin_logs, self.name))

    def is_enabled_for(self, severity: int) -> bool:
        """Whether messages of a severity are printed."""
        return LoggingSeverity(severity) >= _effective(self._rosspin_logs, self.name)

    def log(self, message: str, severity: int, **kwargs: Any) -> bool:
        """Print a message. Return whether it passed the level and the filters.

        ``once``: only the first time that this line of the node is run; ``skip_first``: not the first time;
        ``throttle_duration_sec``: not within so many seconds after the last time, on the clock
        ``throttle_time_source_type``. Raises TypeError for other options, or if the message is not a text, and
        ValueError if the options of a line change between calls.
        """
        severity = LoggingSeverity(severity)
        if severity < _effective(self._rosspin_logs, self.name):
            return False
        name = kwargs.pop("name", self.name)
        filters = _filters(kwargs) if kwargs else []
        frame = sys._getframe(1)
        while frame.f_code.co_filename == __file__ and frame.f_back:
            frame = frame.f_back
        where = (frame.f_code.co_filename, frame.f_lineno, frame.f_lasti)
        call = self._rosspin_calls.get(where)
        if call is None:
            clock = kwargs.get("throttle_time_source_type")
            if clock is not None and not hasattr(clock, "clock_type"):
                text = f'Received throttle_time_source_type of "{clock}" is not a clock instance'
                raise ValueError(text)
            call = self._rosspin_calls[where] = _Call((severity, name, filters), kwargs)
        elif call.settings != (severity, name, filters) or call.options != kwargs:
            _refuse(call, severity, name, filters)
        if filters and not call.is_wanted():
            return False
        printed = _text(message)
        if printed is None:
            raise TypeError(
                "rclpy_logging_rcutils_log(): incompatible function arguments. "
                "The following argument types are supported:\n    1. (arg0: typing.SupportsInt, arg1: str, "
                "arg2: str, arg3: str, arg4: str, arg5: typing.SupportsInt) -> None\n\nInvoked with: "
                f"{severity!r}, {name!r}, {message!r}, {frame.f_code.co_name!r}, "
                f"{os.path.abspath(where[0])!r}, {where[1]}"
            )
        _write(self._rosspin_logs, severity, name, printed, frame)
        return True

    def debug(self, message: str, **kwargs: Any) -> bool:
        """Log a message as DEBUG; the options are as for ``log``."""
        return self.log(message, LoggingSeverity.DEBUG, **kwargs)

    def info(self, message: str, **kwargs: Any) -> bool:
        """Log a message as INFO."""
        return self.log(message, LoggingSeverity.INFO, **kwargs)

    def warning(self, message: str, **kwargs: Any) -> bool:
        """Log a message as WARN."""
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    warn = warning

    def error(self, message: str, **kwargs: Any) -> bool:
        """Log a message as ERROR."""
        return self.log(message, LoggingSeverity.ERROR, **kwargs)

    def fatal(self, message: str, **kwargs: Any) -> bool:
        """Log a message as FATAL."""
        return self.log(message, LoggingSeverity.FATAL, **kwargs)


def _text(message: object) -> str | None:
    """Return what the C part makes of a message, up to a null character; None if it takes it for no text."""
    if message is None:
        return "(null)"
    if isinstance(message, (bytes, bytearray)):
        return message.decode(errors="replace").partition("\0")[0]
    if not isinstance(message, str):
        return None
    try:
        message.encode()
    except UnicodeEncodeError:
        return None
    return message.partition("\0")[0]


def _filters(options: dict[str, Any]) -> list[str]:
    """Return the filters that the options of a log call ask for."""
    filters = [name for name, known in _FILTERS.items() if any(options.get(option) for option in known)]
    if "throttle" in filters and "throttle_duration_sec" not in options:
        raise TypeError(
            'required parameter "throttle_duration_sec" not specified '
            'but is required for the the logging filter "throttle"'
        )
    for option in options:
        if option not in _OPTIONS:
            raise TypeError(f'parameter "{option}" is not one of the recognized logging options "{_OPTIONS}"')
    return filters


def _refuse(call: _Call, *settings: Any) -> None:
    what = ("Logger severity", "Logger name", "Requested logging filters")
    for name, before, now in zip(what, call.settings, settings, strict=True):
        if before != now:
            raise ValueError(f"{name} cannot be changed between calls.")
    raise ValueError("Logging filter parameters cannot be changed between calls.")


def _effective(own: Logs, name: str) -> int:
    levels = own.levels
    while levels and name:
        if level := levels.get(name):
            return level
        name = name.rpartition(".")[0]
    return own.level


def _write(own: Logs, severity: LoggingSeverity, name: str, message: str, frame: FrameType) -> None:
    """Write a line in one go, coloured on a terminal, and publish it. By default all levels go to stderr."""
    if own.console:
        _print(own, severity, name, message, frame)
    publish = own.rosout.get(name) if own.rosout else None
    if publish and not own.is_over:
        publish(severity, name, message, frame.f_lineno, frame.f_code)
    elif publish:  # a signal has come, and no one has shut down
        sys.stderr.write("Failed to publish log message to rosout: publisher's context is invalid\n")


def _print(own: Logs, severity: LoggingSeverity, name: str, message: str, frame: FrameType) -> None:
    now = own.clock.system()
    form = own.form or _read_form(own)
    if form.line == _DEFAULT_FORMAT:
        line = f"[{severity.name}] [{now // NS}.{now % NS:09d}] [{name}]: {message}"
    else:
        fields = {
            "severity": severity.name,
            "name": name,
            "message": message,
            "function_name": frame.f_code.co_name,
            "file_name": os.path.abspath(frame.f_code.co_filename),
            "line_number": str(frame.f_lineno),
            "time": f"{now // NS}.{now % NS:09d}",
            "time_as_nanoseconds": str(now),
            "date_time_with_ms": f"{time.strftime('%Y-%m-%d %H:%M:%S', time.localtime(now // NS))}"
            f".{now // 1_000_000 % 1000:03d}",
        }
        line = re.sub(r"{(\w+)}", lambda match: fields.get(match[1], match[0]), form.line)
    stream = sys.stdout if form.to_stdout else sys.stderr
    if stream.isatty() if form.coloured is None else form.coloured:
        line = f"{_COLOURS[severity]}{line}\033[0m"
    stream.write(line + "\n")


def _read_form(own: Logs) -> _Form:
    """Read the form of lines from the environment. rcutils looks once, at ``init`` or at the first line."""
    coloured = os.environ.get("RCUTILS_COLORIZED_OUTPUT")
    own.form = form = _Form(
        os.environ.get("RCUTILS_CONSOLE_OUTPUT_FORMAT", _DEFAULT_FORMAT),
        os.environ.get("RCUTILS_LOGGING_USE_STDOUT") == "1",
        None if coloured is None else coloured == "1",
    )
    return form


def configure(arguments: Arguments) -> None:
    """Set the log levels of a command line."""
    own = logs()
    _read_form(own)
    own.level = own.level if arguments.level is None else arguments.level
    own.levels.update(arguments.levels)
    own.console = arguments.console
    own.rosout = (own.rosout or {}) if arguments.rosout else None
    for word in arguments.deprecated:
        get_logger("rcl").warning(
            f"Found remap rule '{word}'. This syntax is deprecated. Use '--ros-args --remap {word}' instead."
        )


def publish_on_rosout(name: str, node: str, publish: Publish) -> None:
    """Register the logger of a ``node`` for /rosout, and warn of a second one with its name."""
    loggers = logs().rosout
    assert loggers is not None
    if name in loggers:
        get_logger("rcl.logging_rosout").warning(
            f"Publisher already registered for node name: '{node}'. If this is due to multiple nodes with "
            f"the same name then all logs for the logger named '{name}' will go out over the existing publisher. As "
            "soon as any node with that name is destructed it will unregister the publisher, preventing any further "
            "logs for that name from being published on the rosout topic."
        )
    loggers.setdefault(name, publish)


def leave_rosout(own: Logs, name: str) -> None:
    """Unregister the logger of a node, and those below it."""
    if own.rosout and (publishing := own.rosout.get(name)):
        for each in [each for each, publish in own.rosout.items() if publish == publishing]:
            del own.rosout[each]


def get_logger(name: str) -> RcutilsLogger:
    """Return the logger with this name. Raises ValueError if the name is empty."""
    if not name:
        raise ValueError("Logger name must not be empty.")
    root = globals().get("_root_logger")  # a test may have put one there
    return root.get_child(name) if root else RcutilsLogger(name)


def __getattr__(name: str) -> Any:
    if name == "_root_logger":
        own = logs()
        own.root_logger = own.root_logger or RcutilsLogger()
        return own.root_logger
    raise AttributeError(f"module 'rclpy.logging' has no attribute '{name}'", name=name)


def get_logging_directory() -> Path:
    """Return the folder in which a real ROS writes log files (source: rcl_logging_interface)."""
    home = Path(os.environ.get("ROS_HOME") or "~/.ros")
    return Path(os.environ.get("ROS_LOG_DIR") or home / "log").expanduser()


def clear_config() -> None:
    """Forget what the command line said about logging: levels are as at first, and nothing goes to /rosout."""
    own = logs()
    own.level, own.levels, own.console, own.rosout = LoggingSeverity.INFO, {}, True, None


def set_logger_level(name: str, level: int, detailed_error: bool = False) -> None:
    """Let the logger with this name, and those below it, print only what is at least so serious."""
    own, severity = logs(), LoggingSeverity(level)
    if name:
        own.levels[name] = severity
    else:
        own.level = severity


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level that was set for the logger with this name, UNSET if none was."""
    own = logs()
    return LoggingSeverity(own.levels.get(name, 0) if name else own.level)


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the lowest severity that the logger with this name prints."""
    return LoggingSeverity(_effective(logs(), name))


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity with this name. Raises RuntimeError if there is none."""
    if log_severity.lower() not in LEVELS:
        raise RuntimeError("Failed to get severity name")
    return LoggingSeverity(LEVELS[log_severity.lower()])
