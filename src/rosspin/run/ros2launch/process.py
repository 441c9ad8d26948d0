"""The process of an action: how it starts, what it prints, how it ends (source: launch/actions/execute_local.py)."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from ...clocks.ctrl_c import ROS2_LAUNCH
from ...clocks.programs import press_ctrl_c
from ...clocks.signals import send
from ...clocks.simulation import Simulation
from ...clocks.threads import unlist_threads
from ..host import Host
from ..process import Process
from ..source import Code
from ..streams import Lines, nowhere
from . import events
from .substitutions import perform, perform_typed

if TYPE_CHECKING:
    from .actions import ExecuteProcess
    from .service import LaunchService, Timer

__all__ = ["ExecuteLocal"]

# What goes to the screen.
_OUTPUTS = {name: {"stdout", "stderr"} for name in ("screen", "both", "full")} | {"log": {"stderr"}, "own_log": set()}


class ExecuteLocal:
    """The process of an action, whose code is ``code``; a respawn gives it a new one. ``args`` is its command line."""

    def __init__(
        self, service: LaunchService, host: Host, action: ExecuteProcess, name: str, code: Code, args: Sequence[str]
    ) -> None:
        self.action, self.name = action, name
        self.is_over = False  # it has ended for good
        self._service, self._host, self._code, self._args = service, host, code, args
        self._process: Process | None = None
        self._is_ending = False  # it has been asked to
        self._timers: list[Timer] = []
        self._respawns = 0
        context = service.context
        for lacking in ("env", "prefix", "shell"):
            if getattr(action, lacking):
                raise NotImplementedError(f"{type(action).__name__}({lacking}=...) is not simulated")
        self._patience = [
            perform(context, given or f"{usual:g}")
            for given, (_, usual) in zip((action.sigterm_timeout, action.sigkill_timeout), ROS2_LAUNCH.signals)
        ]
        self._respawn = perform_typed(context, action.respawn, bool)
        self._folder = perform(context, action.cwd) if action.cwd else ""
        added = action.additional_env or {}
        self._environment = dict(context.environment)
        self._environment |= {perform(context, key): perform(context, value) for key, value in added.items()}
        output = action.output if isinstance(action.output, dict) else perform(context, action.output)
        self._shown = _shown(output)
        for handler in (
            events.EventHandler(matcher=self._is_meant(events.ShutdownProcess), entities=lambda *_: self.end(True)),
            events.EventHandler(matcher=self._is_meant(events.SignalProcess), entities=self._on_signal),
            events.OnShutdown(on_shutdown=lambda event, context: self.end(not event.due_to_sigint)),
            events.OnProcessExit(target_action=action, on_exit=action.on_exit),
        ):
            context.register_event_handler(handler)

    def _is_meant(self, kind: type[Any]) -> Callable[[Any], bool]:
        return lambda event: type(event) is kind and bool(event.process_matcher(self.action))

    @property
    def is_running(self) -> bool:
        return self._process is not None and not self._process.world.over

    def begin(self) -> None:
        """Start it."""

        def show(line: str) -> None:
            self._service.write(f"[{self.name}] {line}\n")

        streams = [Lines(show) for _ in range(2)]
        out, err = (
            stream.stream if name in self._shown else nowhere() for name, stream in zip(("stdout", "stderr"), streams)
        )
        process = self._process = self._host.add(self._code, self._args, self._environment, self._folder, out, err)
        # ``add`` only adds to this process's own; what the launch file has unset should be missing, too.
        process.environment = {os.fsencode(key): os.fsencode(value) for key, value in self._environment.items()}
        process.world.at_end.append(lambda: self._service.soon(lambda: self._exit(streams)))
        self._host.begin(process)
        self._service.log("INFO", self.name, "process started")
        event = events.ProcessStarted(action=self.action, process_name=self.name, cmd=self._command())
        self._service.context.emit_event_sync(event)

    def _command(self) -> list[str]:
        return [self._code.argv0, *self._args]

    def _exit(self, streams: Sequence[Lines]) -> None:
        """Say how it has ended, and start it again if it should be."""
        assert self._process
        unlist_threads(self._process.world)
        code = _exit_code(self._process)
        if code:
            self._service.log(
                "ERROR", self.name, f"process has died [exit code {code}, cmd '{self._shown_command()}']."
            )
        else:
            self._service.log("INFO", self.name, "process has finished cleanly")
        for stream in streams:
            stream.flush()
        words = self._command()
        event = events.ProcessExited(action=self.action, process_name=self.name, cmd=words, returncode=code)
        self._service.context.emit_event_sync(event)
        most = self.action.respawn_max_retries
        if self._respawn and not self._is_ending and not self._service.context.is_shutdown:
            if most < 0 or self._respawns < most:
                self._respawns += 1
                self._timers = [self._service.after(self.action.respawn_delay or 0, self.begin)]
                return
        for timer in self._timers:
            timer.cancel()
        self.is_over = True

    def _shown_command(self) -> str:
        return " ".join(filter(str.strip, self._command())).replace(self._service.folder, "/tmp")

    # --- its end ---

    def end(self, with_sigint: bool) -> None:
        """See to it that it ends: with SIGINT, unless it has come from the terminal, then SIGTERM, then SIGKILL."""
        if self._is_ending or self.is_over:
            return
        self._is_ending = True
        if not self.is_running:  # it waits for its respawn
            self.is_over = True
            for timer in self._timers:
                timer.cancel()
            return
        first, second = self._patience
        both = str(float(first) + float(second))
        self._timers = [
            self._service.after(float(first), lambda: self._escalate(first, signal.SIGINT, signal.SIGTERM)),
            self._service.after(float(both), lambda: self._escalate(both, signal.SIGTERM, signal.SIGKILL)),
        ]
        if with_sigint:
            self._emit(signal.SIGINT)

    def _escalate(self, seconds: str, after: signal.Signals, number: signal.Signals) -> None:
        waited = f"failed to terminate '{seconds}' seconds after receiving '{after.name}'"
        self._service.log("ERROR", self.name, f"process[{self.name}] {waited}, escalating to '{number.name}'")
        self._emit(number)

    def _emit(self, number: signal.Signals) -> None:
        event = events.SignalProcess(signal_number=number, process_matcher=events.matches_action(self.action))
        self._service.context.emit_event_sync(event)

    def _on_signal(self, event: events.SignalProcess, context: Any) -> None:
        if self._process is None:
            raise RuntimeError("Signal event received before execution.")
        world, number = self._process.world, event.signal
        if world.over:
            return
        self._service.log("INFO", self.name, f"sending signal '{number.name}' to process[{self.name}]")
        if number == signal.SIGKILL:
            assert isinstance(self._host.clock, Simulation)
            world.exit_status = -number
            self._host.clock.end(world)
        elif number == signal.SIGINT:
            press_ctrl_c(world)
        else:
            send(world, number)

    def press_ctrl_c(self) -> None:
        """Let the terminal send it SIGINT."""
        if self._process and self.is_running:
            press_ctrl_c(self._process.world)


def _exit_code(process: Process) -> int:
    """Negative for a signal, by which Python also ends if nothing catches a KeyboardInterrupt."""
    world = process.world
    status = world.exit_status or 0
    interrupted = status == 128 + signal.SIGINT and any(type(each) is KeyboardInterrupt for each in world.errors)
    return -signal.SIGINT if interrupted else status


def _shown(output: Any) -> set[str]:
    """Return which of stdout and stderr go to the screen."""
    if not isinstance(output, dict):
        if output not in _OUTPUTS:
            raise ValueError(f'{output} is not a valid standard output config i.e. "screen", "log" or "both"')
        return _OUTPUTS[output]
    places = {key: {value} if isinstance(value, str) else set(value) for key, value in output.items()}
    return {name for name in ("stdout", "stderr") if "screen" in places.get(name, set()) | places.get("both", set())}
