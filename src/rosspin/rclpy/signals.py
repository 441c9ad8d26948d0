"""What Ctrl-C and SIGTERM do (source: rclpy/signals.py, and its signal_handler.cpp)."""

from __future__ import annotations

import signal
from typing import Any

from .context import state
from .enumerations import CppEnum

__all__ = [
    *("SignalHandlerOptions", "get_current_signal_handlers_options", "install_signal_handlers"),
    "uninstall_signal_handlers",
]


class SignalHandlerOptions(CppEnum):
    """Which signals shut the contexts down."""

    ALL = 3
    NO = 0
    SIGINT = 1
    SIGTERM = 2


_NUMBERS = {
    SignalHandlerOptions.NO: (),
    SignalHandlerOptions.SIGINT: (signal.SIGINT,),
    SignalHandlerOptions.SIGTERM: (signal.SIGTERM,),
    SignalHandlerOptions.ALL: (signal.SIGINT, signal.SIGTERM),
}


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Let signals shut down the contexts. Their earlier handlers are called afterwards.

    This does nothing outside the main thread.
    """
    own = state()
    for number in _NUMBERS[options]:
        if signal.getsignal(number) is not _handle:
            try:
                own.before[number] = signal.signal(number, _handle)
            except ValueError:
                return
        own.handled.add(number)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return which signals shut the contexts down now."""
    handled = state().handled
    return next(options for options, numbers in _NUMBERS.items() if handled == {*numbers})


def uninstall_signal_handlers() -> None:
    """Let signals do what they did before."""
    state().handled.clear()  # the handlers stay: only the main thread could remove them


def _handle(number: int, frame: Any) -> None:
    """Shut down all contexts and wake the executors, then call the earlier handler: KeyboardInterrupt at Ctrl-C."""
    own = state()
    before = own.before[number]
    watcher = own.world.recording.watcher
    if number in own.handled:
        if watcher:
            watcher.says("gets the signal: rclpy shuts its contexts down and wakes the executors.")
        for context in list(own.contexts):
            context.end()
        for event in list(own.waiting):
            event.set()
        own.clock.sleep(0)  # threads that wait go first
    elif not callable(before):
        signal.signal(number, before)
        signal.raise_signal(number)
    if not callable(before):
        return
    if watcher:
        watcher.says("continues with what the signal does in Python: at Ctrl-C it raises KeyboardInterrupt here.")
    if own.asleep:
        own.pending = lambda: before(number, frame)
    else:
        before(number, frame)
