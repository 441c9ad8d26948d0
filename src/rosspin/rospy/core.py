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

from .genpy import Duration
from .rostime import get_rostime, wallsleep
from .threads import own_frame, print_traceback
from .world import World, world

__all__ = [
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
    here = world()
    name = kwargs.pop("logger_name", None)
    if here.log_level is None:
        # Before init_node there is no handler but the logging module's last resort.
        if level >= logging.WARNING:
            sys.stderr.write(_message(level, msg, args, kwargs) + "\n")
        return
    if level < here.log_level:
        return
    message = _message(level, msg, args, kwargs) if args or kwargs else str(msg)
    line_format = os.environ.get("ROSCONSOLE_FORMAT", _DEFAULT_FORMAT)
    severity, colour = _SEVERITY[level]
    if line_format == _DEFAULT_FORMAT and "${" not in message:
        line = f"[{severity}] [{_stamp(here)}]: {message}\n"
    else:
        line = _fill(line_format, here, severity, message, f"rosout.{name}" if name else "rosout") + "\n"
    stream = sys.stdout if level < logging.WARNING else sys.stderr
    stream.write(f"{colour}{line}\033[0m" if colour and stream.isatty() else line)


def _message(level: int, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> str:
    """``msg % args`` and what keyword arguments such as ``exc_info`` add, as the logging module puts it."""
    exc_info = kwargs.get("exc_info")
    if isinstance(exc_info, BaseException):
        exc_info = (type(exc_info), exc_info, exc_info.__traceback__)
    elif exc_info and not isinstance(exc_info, tuple):
        exc_info = sys.exc_info()
    record = logging.LogRecord("rosout", level, "", 0, msg, args, exc_info)
    return logging.Formatter().format(record)


def _stamp(here: World) -> str:
    now = f"{here.clock.now() / 1e9:.6f}"
    return now if here.ros_time is None else f"{now}, {here.ros_time / 1e9:.6f}"


def _fill(line_format: str, here: World, severity: str, message: str, logger: str) -> str:
    """Fill in ROSCONSOLE_FORMAT, in rosgraph's order: a field inside the message is filled in too."""
    line = line_format.replace("${severity}", severity).replace("${message}", message)
    seconds = here.clock.now() / 1e9
    line = line.replace("${walltime}", f"{seconds:f}")
    line = _fill_times(line, "${walltime:", seconds, "")
    caller = own_frame(sys._getframe())
    fields = {
        "thread": str(threading.get_ident()),
        "logger": logger,
        "file": caller.f_code.co_filename,
        "line": str(caller.f_lineno),
        "function": _function(caller),
        "node": here.name,
        "time": _stamp(here),
    }
    for name, value in fields.items():
        line = line.replace(f"${{{name}}}", value)
    ros_time = "" if here.ros_time is None else f", {here.ros_time / 1e9:.6f}"
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
    caller = own_frame(sys._getframe())
    return caller.f_code.co_filename, caller.f_lineno, caller.f_lasti


def _throttle_elapsed(site: Hashable, period: float) -> bool:
    here, now = world(), get_rostime()
    last = here.log_times.get(site)
    if last is None or now - last > Duration(period):
        here.log_times[site] = now
        return True
    if last > now:  # time went back: begin anew
        here.log_times = {site: now}
        return True
    return False


def _differs(site: Hashable, msg: str) -> bool:
    msg.encode()  # no text, no comparison: AttributeError, as in rospy
    here = world()
    if here.log_messages.get(site) == msg:
        return False
    here.log_messages[site] = msg
    return True


def _throttled(level: int, period: float, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    if not period or _throttle_elapsed(_call_site(), period):
        _log(level, msg, args, kwargs)


def _throttled_identical(level: int, period: float, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    site = _call_site()
    elapsed = period is not None and _throttle_elapsed(site, period)
    if _differs(site, msg) or elapsed:
        _log(level, msg, args, kwargs)


def _once(level: int, msg: Any, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    site, here = _call_site(), world()
    if site not in here.logged_once:
        here.logged_once.add(site)
        _log(level, msg, args, kwargs)


def logdebug(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log ``msg % args`` as DEBUG, which is hidden unless ``init_node(log_level=rospy.DEBUG)``."""
    _log(logging.DEBUG, msg, args, kwargs)


def loginfo(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log ``msg % args`` as INFO."""
    _log(logging.INFO, msg, args, kwargs)


def logwarn(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log ``msg % args`` as WARN."""
    _log(logging.WARNING, msg, args, kwargs)


def logerr(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log ``msg % args`` as ERROR."""
    _log(logging.ERROR, msg, args, kwargs)


def logfatal(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log ``msg % args`` as FATAL."""
    _log(logging.CRITICAL, msg, args, kwargs)


logout = loginfo
logerror = logerr


def logdebug_throttle(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logdebug, from this line of the node at most once in ``period`` seconds."""
    _throttled(logging.DEBUG, period, msg, args, kwargs)


def loginfo_throttle(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
    """As loginfo, from this line of the node at most once in ``period`` seconds."""
    _throttled(logging.INFO, period, msg, args, kwargs)


def logwarn_throttle(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logwarn, from this line of the node at most once in ``period`` seconds."""
    _throttled(logging.WARNING, period, msg, args, kwargs)


def logerr_throttle(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logerr, from this line of the node at most once in ``period`` seconds."""
    _throttled(logging.ERROR, period, msg, args, kwargs)


def logfatal_throttle(period: float, msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logfatal, from this line of the node at most once in ``period`` seconds."""
    _throttled(logging.CRITICAL, period, msg, args, kwargs)


def logdebug_throttle_identical(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
    """As logdebug_throttle, but at once when the message differs from the last one of this line."""
    _throttled_identical(logging.DEBUG, period, msg, args, kwargs)


def loginfo_throttle_identical(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
    """As loginfo_throttle, but at once when the message differs from the last one of this line."""
    _throttled_identical(logging.INFO, period, msg, args, kwargs)


def logwarn_throttle_identical(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
    """As logwarn_throttle, but at once when the message differs from the last one of this line."""
    _throttled_identical(logging.WARNING, period, msg, args, kwargs)


def logerr_throttle_identical(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
    """As logerr_throttle, but at once when the message differs from the last one of this line."""
    _throttled_identical(logging.ERROR, period, msg, args, kwargs)


def logfatal_throttle_identical(period: float, msg: str, *args: Any, **kwargs: Any) -> None:
    """As logfatal_throttle, but at once when the message differs from the last one of this line."""
    _throttled_identical(logging.CRITICAL, period, msg, args, kwargs)


def logdebug_once(msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logdebug, but from this line of the node only the first time."""
    _once(logging.DEBUG, msg, args, kwargs)


def loginfo_once(msg: Any, *args: Any, **kwargs: Any) -> None:
    """As loginfo, but from this line of the node only the first time."""
    _once(logging.INFO, msg, args, kwargs)


def logwarn_once(msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logwarn, but from this line of the node only the first time."""
    _once(logging.WARNING, msg, args, kwargs)


def logerr_once(msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logerr, but from this line of the node only the first time."""
    _once(logging.ERROR, msg, args, kwargs)


def logfatal_once(msg: Any, *args: Any, **kwargs: Any) -> None:
    """As logfatal, but from this line of the node only the first time."""
    _once(logging.CRITICAL, msg, args, kwargs)


# --- shutdown ---------------------------------------------------------------------------------------------------------


def is_shutdown() -> bool:
    """Whether the node is to end."""
    return world().shutdown


def is_shutdown_requested() -> bool:
    """Whether shutdown has begun; the hooks run between this and ``is_shutdown``."""
    return world().shutdown_requested


def add_client_shutdown_hook(h: Callable[[], Any]) -> None:
    """Have ``h`` called at shutdown; after shutdown at once. What cannot be called: TypeError."""
    if not callable(h):
        raise TypeError(f"shutdown hook [{h}] must be a function or callable object: {type(h)}")
    here = world()
    if here.shutdown:
        h()
    else:
        here.shutdown_hooks.append(h)


def signal_shutdown(reason: str) -> None:
    """End the node: call the hooks, in the order of their registration, then let ``is_shutdown()`` be True.

    An exception in a hook is printed and the next hook called. Only the first call does anything.
    """
    here = world()
    with here.shutdown_lock:
        if here.shutdown_requested:
            return
        here.shutdown_requested = True
    for hook in here.shutdown_hooks:
        try:
            hook()
        except BaseException:
            print_traceback()
    here.shutdown_hooks.clear()
    here.shutdown = True
    try:
        wallsleep(0.1)
    except KeyboardInterrupt:
        pass


def handle_signal(number: int, frame: Any) -> None:
    """What a node does on SIGINT and SIGTERM."""
    signal_shutdown(f"signal-{number}")
