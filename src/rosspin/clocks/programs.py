"""Run a program on a clock: at the end it is sent Ctrl-C, and it is killed if it ignores that."""

from __future__ import annotations

import os
import select
import signal
import sys
import threading
import time
from _thread import get_ident
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from typing import Any, NamedTuple

from .clock import NS
from .ending import Ended, end_thread, ending_here
from .frames import Trail, Whereabouts, places, trail
from .guard import LastWords, guard
from .loops import Loops
from .patches import Builtins
from .signals import send, simulated_signals
from .simulation import Simulation
from .stacks import Program, Stack, current, enter
from .threads import followed_threads, simulated_threads
from .virtual_time import virtual_time
from .watchdog import watch

__all__ = [
    "Killed",
    "LastResort",
    "SimulatedProgram",
    "begin_beside",
    "end_program",
    "end_run",
    "ignores_ctrl_c",
    "press_ctrl_c",
    "run_on_the_wall",
    "where_it_waits",
]

# The signal that ends a blocking call in the main thread. Programs leave it alone.
_END: int = getattr(signal, "SIGRTMAX", 0) or getattr(signal, "SIGUSR2", signal.SIGINT)

# What stands among the signals for the end of the program.
_ENDED = 0

# How long (s) a killed program may stay in a call that heeds no signal. As long again, and the guard kills the process.
_DEAF = 1.0


def end_program() -> None:
    """End the caller's program immediately, or the whole run if that is its main program."""
    stack = current()
    if isinstance(stack, Stack) and stack.program.main is not stack.clock.main:
        stack.clock.end(stack.program, spare_me=False)
    end_run()


def end_run() -> None:
    """End the caller's run immediately: :class:`Ended` leaves it."""
    if isinstance(current(), Stack):
        raise Ended
    signal.pthread_kill(threading.main_thread().ident or 0, _END)


class Killed(Exception):
    """A program did not end at Ctrl-C.

    ``waited`` says where its threads were, ``ignores`` whether it ignores SIGINT, and ``blocks`` whether it blocks it.
    """

    def __init__(self, waited: list[Whereabouts], ignores: bool, blocks: bool = False) -> None:
        super().__init__()
        self.waited = waited
        self.ignores = ignores
        self.blocks = blocks


class SimulatedProgram:
    """Runs ``main`` as a program on a simulated clock, in steps. Between steps it is in no one's way.

    A step raises :class:`Died`, and what :class:`Simulation` and :class:`Watchdog` raise.
    """

    def __init__(self, main: Callable[[], object], program: Program, simulation: Simulation) -> None:
        self._program = program
        self._simulation = simulation
        self._builtins = Builtins()
        self._loops = Loops()
        self.before_ctrl_c: Callable[[], object] = lambda: None  # called at the end of its time
        simulation.begin(main, program, _main_ident())

    def run(self, until: int, patience: int | None) -> None:
        """Do what ``advance`` and ``end`` do, in one step."""
        with self._step():
            self._simulation.advance(until)
            self._end(patience)

    def advance(self, until: int) -> None:
        """Continue until all that is due by ``until`` (ns) has run, or until ``main`` has returned."""
        with self._step():
            self._simulation.advance(until)

    def end(self, patience: int | None) -> None:
        """Press Ctrl-C and continue to the end. Raises :class:`Killed` if that takes longer than ``patience`` ns."""
        with self._step():
            self._end(patience)

    def _end(self, patience: int | None) -> None:
        simulation = self._simulation
        if simulation.is_over:
            return

        def kill() -> None:
            raise Killed(where_it_waits(self._program), ignores_ctrl_c(self._program))

        self.before_ctrl_c()
        press_ctrl_c(self._program)
        if patience is not None:
            simulation.at(simulation.now() + patience, kill)
        simulation.advance(None)

    @contextmanager
    def _step(self) -> Iterator[None]:
        simulation = self._simulation
        with watch(simulation.sign_of_life) as watchdog:
            simulation.taking_down = watchdog.taking_down
            with simulated_threads(self._program), virtual_time(), simulated_signals(), self._builtins, self._loops:
                with simulation.heeding_signals(self._program):
                    yield


def begin_beside(main: Callable[[], object], program: Program, simulation: Simulation) -> None:
    """Begin another program on a simulated clock, at the instant of the call."""
    simulation.begin_beside(main, program, _main_ident())


def press_ctrl_c(program: Program) -> None:
    """Send SIGINT to a simulated program: its time is up."""
    program.interrupted = True
    send(program, signal.SIGINT)


def where_it_waits(program: Program) -> list[Whereabouts]:
    """Where the threads of a simulated program are."""
    stacks = program.main.clock.suspended()
    return [_whereabouts(stack.ident, stack.trail) for stack in stacks if stack.ident and stack.own_program is program]


def ignores_ctrl_c(program: Program) -> bool:
    """Whether a simulated program has asked for SIGINT to be ignored."""
    return program.handlers.get(signal.SIGINT) == signal.SIG_IGN


def _main_ident() -> int:
    return threading.main_thread().ident or 0


def _whereabouts(ident: int, trail: Trail) -> Whereabouts:
    thread = threading._active.get(ident)  # type: ignore[attr-defined]
    # Python does not wait for a thread without a Thread object.
    name, daemon = (thread.name, thread.daemon) if thread else (f"thread {ident}", True)
    return Whereabouts(name, places(trail), daemon)


class LastResort(NamedTuple):
    """What to call before the process is killed, if nothing else can end a program.

    ``give_up`` is called in a thread of the process; ``last_words`` outside of it, if code in C lets no thread run.
    """

    give_up: Callable[[Killed], object]
    last_words: LastWords


def run_on_the_wall(
    main: Callable[[], object],
    program: Program,
    until: int | None,
    patience: float,
    last_resort: LastResort | None = None,
) -> None:
    """Run ``main`` as a program on the wall clock. Raises RuntimeError outside of the main thread.

    Ctrl-C comes ``until`` ns after the start, if that is not None, or from the user. Raises :class:`Killed` if the end
    takes ``patience`` seconds more. A last call that heeds no signal is waited for, unless there is a ``last_resort``.
    """
    if threading.current_thread() is not threading.main_thread():
        raise RuntimeError("on the wall clock a node can run only in the main thread, which handles its signals")
    seconds = None if until is None else until / NS
    guarded = guard(seconds, patience + 2 * _DEAF, last_resort.last_words) if last_resort else nullcontext()
    give_up = last_resort.give_up if last_resort else None
    with guarded as interrupted, _own_signals(), _Alarm(program, seconds, patience, interrupted, give_up) as alarm:
        before = enter(program)
        try:
            with followed_threads(), ending_here(), Builtins():
                main()
        except Ended:
            if alarm.waited:
                raise Killed(alarm.waited, alarm.ignores, alarm.blocks) from None
            raise
        finally:
            enter(before)
            for ident in list(program.idents):
                end_thread(ident)


@contextmanager
def _own_signals() -> Iterator[None]:
    """Within this context SIGINT does what it does in a fresh Python; afterwards all handlers are as before."""
    before = {number: signal.getsignal(number) for number in signal.valid_signals()}
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    over = False

    def on_signal(number: int, frame: Any) -> None:
        if not over:
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, on_signal)
    signal.signal(_END, _end)
    try:
        yield
    finally:
        over = True
        signal.setitimer(signal.ITIMER_REAL, 0)
        if signal.pthread_sigmask(signal.SIG_BLOCK, ()) != mask:
            signal.signal(signal.SIGINT, on_signal)
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)  # a Ctrl-C that arrives only now was for the program
        for number, handler in before.items():
            if signal.getsignal(number) != handler:
                signal.signal(number, handler)


def _end(number: int, frame: Any) -> None:
    raise Ended


def _blocks_sigint() -> bool:
    """Whether the main thread blocks SIGINT; only Linux tells."""
    try:
        with open("/proc/self/status") as file:
            masks = [line.split()[1] for line in file if line.startswith("SigBlk:")]
    except OSError:
        return False
    return any(int(mask, 16) >> (signal.SIGINT - 1) & 1 for mask in masks)


class _Alarm:
    """Presses Ctrl-C when it is time, and kills a program that has not ended ``patience`` seconds after a Ctrl-C.

    It learns of any Ctrl-C through a pipe, into which Python writes each signal that it receives, whatever handles it.
    """

    def __init__(
        self,
        program: Program,
        until: float | None,
        patience: float,
        interrupted: Callable[[], None] | None,
        give_up: Callable[[Killed], object] | None,
    ) -> None:
        self.waited: list[Whereabouts] = []
        self.ignores = False
        self.blocks = False
        self._program = program
        self._until = until
        self._patience = patience
        self._interrupted = interrupted
        self._give_up = give_up
        self._ident = get_ident()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def __enter__(self) -> _Alarm:
        self._read, self._write = os.pipe()
        os.set_blocking(self._write, False)
        self._before = signal.set_wakeup_fd(self._write, warn_on_full_buffer=False)
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        signal.set_wakeup_fd(self._before)
        os.write(self._write, bytes([_ENDED]))
        self._thread.join()
        os.close(self._read)
        os.close(self._write)

    def _run(self) -> None:
        came = self._wait(self._until, _ENDED, signal.SIGINT)
        if came == _ENDED:
            return
        self._program.interrupted = True
        if self._interrupted:
            self._interrupted()
        if came is None:
            signal.pthread_kill(self._ident, signal.SIGINT)
        if self._wait(self._patience, _ENDED) == _ENDED:
            return
        frames = sys._current_frames()
        idents = [self._ident, *self._program.idents]
        self.waited = [_whereabouts(ident, trail(frames.get(ident))) for ident in idents]
        self.ignores = signal.getsignal(signal.SIGINT) == signal.SIG_IGN
        self.blocks = _blocks_sigint()
        deaf = time.monotonic() + _DEAF
        while self._wait(0.1, _ENDED) is None:
            if self._give_up and time.monotonic() > deaf:
                self._give_up(Killed(self.waited, self.ignores, self.blocks))
                os.kill(os.getpid(), signal.SIGKILL)
            signal.pthread_kill(self._ident, _END)

    def _wait(self, timeout: float | None, *signals: int) -> int | None:
        """Wait for one of these signals for ``timeout`` seconds. Return which came, the first of them before others."""
        deadline = None if timeout is None else time.monotonic() + timeout
        while select.select([self._read], [], [], None if deadline is None else max(deadline - time.monotonic(), 0))[0]:
            received = os.read(self._read, 4096)
            if came := [number for number in signals if number in received]:
                return came[0]
        return None
