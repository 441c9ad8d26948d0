"""What Ctrl-C and SIGTERM do (source: rclpy/signals.py, and its signal_handler.cpp)."""

from __future__ import annotations

import signal
from enum import Enum
from typing import Any

from .state import state

__all__ = [
    "SignalHandlerOptions",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]


class SignalHandlerOptions(Enum):
    """Which signals shut the contexts down."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


_NUMBERS = {
    SignalHandlerOptions.NO: (),
    SignalHandlerOptions.SIGINT: (signal.SIGINT,),
    SignalHandlerOptions.SIGTERM: (signal.SIGTERM,),
    SignalHandlerOptions.ALL: (signal.SIGINT, signal.SIGTERM),
}


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Let signals shut down the contexts. What handled them before is called afterwards.

    Only the main thread can do that: in another one nothing happens.
    """
    own = state()
    for number in _NUMBERS[options]:
        if number not in own.handlers:
            try:
                own.handlers[number] = signal.signal(number, _handle)
            except ValueError:
                return


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Which signals shut the contexts down."""
    numbers = tuple(sorted(state().handlers))
    return next(options for options, handled in _NUMBERS.items() if handled == numbers)


def uninstall_signal_handlers() -> None:
    """Let signals do what they did before."""
    own = state()
    for number, before in list(own.handlers.items()):
        if signal.getsignal(number) is _handle:
            signal.signal(number, before)
        del own.handlers[number]


def _handle(number: int, frame: Any) -> None:
    """Shut down all contexts and wake the executors. What was there before follows: KeyboardInterrupt at Ctrl-C."""
    own = state()
    for context in list(own.contexts):
        context.end()
    for gate in list(own.waiting):
        gate.open()
    before = own.handlers.get(number)
    if not callable(before):
        return
    if own.asleep:
        own.pending = lambda: before(number, frame)
    else:
        before(number, frame)
