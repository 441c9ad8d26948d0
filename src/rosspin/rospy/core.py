"""Logging and shutdown (sources: rospy/core.py, rosgraph/roslogging.py)."""

from __future__ import annotations

import logging
import os
import sys
import threading
import time
from collections.abc import Callable, Hashable
from types import FrameType
from typing import Any

from ..clocks.frames import format_error, node_frame
from ..messages.genpy import Duration
from .names import valid_name
from .rosgraph import SEP
from .rostime import get_rostime, wallsleep
from .state import State, state
from .validators import ParameterInvalid, Validator

__all__ = [
    "get_node_uri",
    "is_shutdown",
    "logdebug",
    "logdebug_once",
    "logdebug_throttle",
    "logdebug_throttle_identical",
    "logerr",
    "logerr_once",
    "logerr_throttle",
    "logerr_throttle_identical",
    "logfatal",
    "logfatal_once",
    "logfatal_throttle",
    "logfatal_throttle_identical",
    "loginfo",
    "loginfo_once",
    "loginfo_throttle",
    "loginfo_throttle_identical",
    "logout",
    "logwarn",
    "logwarn_once",
    "logwarn_throttle",
    "logwarn_throttle_identical",
    "signal_shutdown",
]

# --- logging ----------------------------------------------------------------------------------------------------------

_DEFAULT_FORMAT = "[${severity}] [${time}]: ${message}"

# The severity as it is printed, and its colour on a terminal.
_SEVERITY = {
    logging.DEBUG: ("DEBUG", "\033[32m"),
    logging.INFO: ("INFO", ""),
    logging.WARNING: ("WARN", "\033[33m"),
    logging.ERROR: ("ERROR", "\033[31m"),
    logging.CRITICAL: ("FATAL", "\033[31m"),
}


def _log(level: int, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    """Write a line: WARN and above on stderr, coloured on a terminal only; the rest on stdout."""
    node = state()
    name = kwargs.pop("logger_name", None)
    if node.log_level is None:
        # Before init_node there is no handler but the logging module's last resort.
        if level >= logging.WARNING:
            sys.stderr.write(_message(level, msg, args, kwargs) + "\n")
        return
    if level < node.log_level:
        return
    message = _message(level, msg, args, kwargs) if args or kwargs else str(msg)
    line_format = os.environ.get("ROSCONSOLE_FORMAT", _DEFAULT_FORMAT)
    severity, colour = _SEVERITY[level]
    if line_format == _DEFAULT_FORMAT and "${" not in message:
        line = f"[{severity}] [{_stamp(node)}]: {message}\n"
    else:
        line = _fill(line_format, node, severity, message, f"rosout.{name}" if name else "rosout") + "\n"
    stream = sys.stdout if level < logging.WARNING else sys.stderr
    stream.write(f"{colour}{line}\033[0m" if colour and stream.isatty() else line)


def _message(level: int, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> str:
    """Format ``msg % args``, and what keyword arguments such as ``exc_info`` add, as the logging module does."""
    exc_info = kwargs.get("exc_info")
    if isinstance(exc_info, BaseException):
        exc_info = (type(exc_info), exc_info, exc_info.__traceback__)
    elif exc_info and not isinstance(exc_info, tuple):
        exc_info = sys.exc_info()
    record = logging.LogRecord("rosout", level, "", 0, msg, args, exc_info)
    return logging.Formatter().format(record)


def _stamp(node: State) -> str:
    now = f"{node.clock.system() / 1e9:.6f}"
    return now if node.ros_time is None else f"{now}, {node.ros_time / 1e9:.6f}"


def _fill(line_format: str, node: State, severity: str, message: str, logger: str) -> str:
    """Fill in ROSCONSOLE_FORMAT, in rosgraph's order: a field inside the message is filled in too."""
    line = line_format.replace("${severity}", severity).replace("${message}", message)
    seconds = node.clock.system() / 1e9
    line = line.replace("${walltime}", f"{seconds:f}")
    line = _fill_times(line, "${walltime:", seconds, "")
    caller = node_frame(sys._getframe())
    fields = {
        "thread": str(threading.get_ident()),
        "logger": logger,
        "file": caller.f_code.co_filename,
        "line": str(caller.f_lineno),
        "function": _function(caller),
        "node": node.name,
        "time": _stamp(node),
    }
    for name, value in fields.items():
        line = line.replace(f"${{{name}}}", value)
    ros_time = "" if node.ros_time is None else f", {node.ros_time / 1e9:.6f}"
    return _fill_times(line, "${time:", seconds, ros_time)


def _fill_times(line: str, opening: str, seconds: float, suffix: str) -> str:
    """Fill in a time with a strftime format, such as ``${time:%H:%M:%S}``."""
    while opening in line:
        start = line.index(opening) + len(opening)
        time_format = line[start : line.index("}", start)]
        text = time.strftime(time_format, time.localtime(seconds)) + suffix
        line = line.replace(f"{opening}{time_format}}}", text)
    return line


def _function(frame: FrameType) -> str:
    name = frame.f_code.co_name
    return f"{type(frame.f_locals['self']).__name__}.{name}" if "self" in frame.f_locals else name


def _call_site() -> Hashable:
    caller = node_frame(sys._getframe())
    return caller.f_code.co_filename, caller.f_lineno, caller.f_lasti


def _throttle_elapsed(site: Hashable, period: float) -> bool:
    node, now = state(), get_rostime()
    last = node.log_times.get(site)
    if last is None or now - last > Duration(period):
        node.log_times[site] = now
        return True
    if last > now:  # time went back: begin again
        node.log_times = {site: now}
        return True
    return False


def _differs(site: Hashable, msg: str) -> bool:
    msg.encode()  # raises AttributeError for what is not a text, as in rospy
    node = state()
    if node.log_messages.get(site) == msg:
        return False
    node.log_messages[site] = msg
    return True


def _plain(level: int) -> Callable[..., None]:
    def log(msg: Any, *args: Any, **kwargs: Any) -> None:
        _log(level, msg, args, kwargs)

    return log


def _throttled(level: int) -> Callable[..., None]:
    def log(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
        if not period or _throttle_elapsed(_call_site(), period):
            _log(level, msg, args, kwargs)

    return log


def _throttled_identical(level: int) -> Callable[..., None]:
    def log(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
        site = _call_site()
        elapsed = period is not None and _throttle_elapsed(site, period)
        if _differs(site, msg) or elapsed:
            _log(level, msg, args, kwargs)

    return log


def _once(level: int) -> Callable[..., None]:
    def log(msg: Any, *args: Any, **kwargs: Any) -> None:
        site, node = _call_site(), state()
        if site not in node.logged_once:
            node.logged_once.add(site)
            _log(level, msg, args, kwargs)

    return log


def _family(suffix: str, make: Callable[[int], Callable[..., None]], doc: str) -> list[Callable[..., None]]:
    """Make a log function for each severity: ``logdebug``, ``loginfo``, ... with a suffix, and ``doc`` filled in."""
    family = []
    for name, level in zip(("debug", "info", "warn", "err", "fatal"), _SEVERITY, strict=True):
        log = make(level)
        log.__name__ = log.__qualname__ = f"log{name}{suffix}"
        log.__doc__ = doc.format(name=f"log{name}", severity=_SEVERITY[level][0])
        family.append(log)
    return family


logdebug, loginfo, logwarn, logerr, logfatal = _family("", _plain, "Log ``msg % args`` as {severity}.")
logdebug.__doc__ = "Log ``msg % args`` as DEBUG, which is hidden unless ``init_node(log_level=rospy.DEBUG)``."
logout = loginfo
logerror = logerr

logdebug_throttle, loginfo_throttle, logwarn_throttle, logerr_throttle, logfatal_throttle = _family(
    "_throttle", _throttled, "Like {name}, but this line of the node logs at most once in ``period`` seconds."
)
(
    logdebug_throttle_identical,
    loginfo_throttle_identical,
    logwarn_throttle_identical,
    logerr_throttle_identical,
    logfatal_throttle_identical,
) = _family(
    "_throttle_identical",
    _throttled_identical,
    "Like {name}_throttle, but log a message that differs from the last one of this line without waiting.",
)
logdebug_once, loginfo_once, logwarn_once, logerr_once, logfatal_once = _family(
    "_once", _once, "Like {name}, but this line of the node logs only the first time."
)


# --- the node ---------------------------------------------------------------------------------------------------------


def is_initialized() -> bool:
    """Whether ``init_node`` has been called."""
    return state().initialized


def set_initialized(initialized: bool) -> None:
    """Set whether the node is initialised."""
    state().initialized = initialized


def is_topic(param_name: str) -> Validator:
    """Return a check of a topic's name: it returns the full name, or raises ParameterInvalid."""
    check = valid_name(param_name)

    def validator(param_value: Any, caller_id: str) -> str:
        name = str(check(param_value, caller_id))
        if param_value == SEP:
            raise ParameterInvalid(f"ERROR: parameter [{param_name}] cannot be the global namespace")
        return name

    return validator


# --- shutdown ---------------------------------------------------------------------------------------------------------


def get_node_uri() -> str | None:
    """Return where the node would be found on a network, where no one listens; None before ``init_node``."""
    return state().uri


def is_shutdown() -> bool:
    """Whether the node has been shut down."""
    return state().shutdown


def is_shutdown_requested() -> bool:
    """Whether shutdown has begun. The hooks run after that, and before ``is_shutdown`` becomes true."""
    return state().shutdown_requested


def add_client_shutdown_hook(h: Callable[[], Any]) -> None:
    """Call ``h`` at shutdown, or immediately if that has been. Raises TypeError if it is not callable."""
    if not callable(h):
        raise TypeError(f"shutdown hook [{h}] must be a function or callable object: {type(h)}")
    node = state()
    if node.shutdown:
        h()
    else:
        node.shutdown_hooks.append(h)


def may_register(kind: str, what: str, name: str) -> bool:
    """Whether the master takes a name; if not, log that as rospy does (sources: rospy/impl/registration.py, rosmaster).

    ``kind`` is publication, subscription or service; ``what`` is the master's word: topic or service.
    """
    if ":" in name or " " in name:
        why = "contains illegal chars"
    elif name == "/":
        why = "cannot be the global namespace"
    else:
        return True
    logfatal(f"unable to register {kind} [{name}] with master: ERROR: parameter [{what}] {why}")
    return False


def signal_shutdown(reason: str) -> None:
    """Shut the node down: call the hooks, in the order of registration, then make ``is_shutdown()`` true.

    An exception in a hook is printed, and the next hook is called. Only the first call has an effect.
    """
    node = state()
    with node.shutdown_lock:
        if node.shutdown_requested:
            return
        node.shutdown_requested = True
    for hook in node.shutdown_hooks:
        try:
            hook()
        except BaseException as error:
            sys.stderr.write(format_error(error))
            node.world.note_error(error)
    node.shutdown_hooks.clear()
    for finish in node.before_shutdown:
        finish()
    node.shutdown = True
    for close in node.at_shutdown:
        close()
    try:
        wallsleep(0.1)
    except KeyboardInterrupt:
        pass


def handle_signal(number: int, frame: Any) -> None:
    """Shut the node down at SIGINT or SIGTERM."""
    signal_shutdown(f"signal-{number}")
