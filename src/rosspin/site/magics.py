"""The cell magics ``%%simulate``, ``%%measure``, ``%%drive`` and ``%%answer``, for nodes, and ``%%facts``."""

from __future__ import annotations

import argparse
import json
import shlex
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NoReturn, TextIO

from IPython.core.error import UsageError
from IPython.core.magic import Magics as BaseMagics
from IPython.core.magic import cell_magic, line_magic, magics_class

from .. import plots
from ..clocks.simulation import Simulation
from ..exercises import EXERCISES, Feedback, check
from ..exercises.own import LESSONS
from ..plots import drive_beside, pictures
from ..results.ticks import Run
from ..run.beside import run_beside
from ..run.simulate import run_captured, tell_uncalled
from ..run.source import Code, load_cell, split_words
from ..run.streams import capture
from ..run.wall import measured
from ..vehicle import VEHICLES
from ..world.graph import TickLog
from .claims import MIME, Facts

__all__ = ["Magics"]


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{self.prog}: {message}\n{self.format_usage()}")


def _parser(name: str) -> _Parser:
    parser = _Parser(prog=f"%%{name}", add_help=False, allow_abbrev=False)
    parser.add_argument("seconds", type=float, help="press Ctrl-C after this many seconds")
    parser.add_argument("--name", default="run", help="the variable in which to store the Run (default: run)")
    parser.add_argument("--quiet", action="store_true", help="do not show the node's console")
    return parser


def _below_its_magic(cell: str) -> str:
    """Put an empty line in the place of the magic's line, so that the line numbers are the cell's."""
    return f"\n{cell}"


@magics_class
class Magics(BaseMagics):
    """Cell magics. A cell that runs as a node file imports a stand-in with ``import rospy`` or ``import rclpy``.

    Or it is in C++, and includes one: ``ros/ros.h`` or ``rclcpp/rclcpp.hpp``.
    """

    def __init__(self, shell: Any) -> None:
        super().__init__(shell)
        self._solved: set[int] = set()  # the exercises that were answered right

    @cell_magic
    def simulate(self, line: str, cell: str) -> None:
        """``%%simulate SECONDS [--name NAME] [--quiet] [-- NODE ARGS]``: run the cell in simulated time."""
        self._run("simulate", partial(run_captured, Simulation()), line, cell)

    @cell_magic
    def measure(self, line: str, cell: str) -> None:
        """``%%measure SECONDS [--name NAME] [--quiet] [-- NODE ARGS]``: run the cell on the wall clock."""
        self._run("measure", measured, line, cell)

    @cell_magic
    def answer(self, line: str, cell: str) -> Feedback:
        """``%%answer NAME``: check the cell, a node file, as the answer to an exercise."""
        if line.strip().isdecimal():  # it may be from an older version, in which the numbers were others
            raise UsageError("%%answer NAME: an exercise is given by its name, as in %%answer ten-hertz")
        try:
            feedback = check(line.strip(), _below_its_magic(cell))
        except ValueError as error:
            raise UsageError(f"%%answer NAME: {error}") from None
        print(feedback.console, end="")
        if feedback.drive.spots:
            self._display(drive_beside(feedback.drive, {}, feedback.drive.spots[-1].time, "simulated"))
        if not (feedback.passed and self._is_attended()):
            return feedback
        self._solved.add(feedback.number)
        answered = EXERCISES[feedback.number - 1]
        on_page = {each.number for each in EXERCISES if (each.ros, not each.part) == (answered.ros, not answered.part)}
        solved = f"You have solved {len(self._solved & on_page)} of {len(on_page)} exercises."
        return replace(feedback, progress=solved)

    @line_magic("answer")  # type: ignore[arg-type]
    def task(self, line: str) -> None:
        """``%answer NAME [LANGUAGE]``: put the exercise of this name into a cell of its own below.

        The language is Python unless it is ``cpp``, in which some exercises are, too.
        """
        name, language = [*line.split(), "", ""][:2]
        lesson = next((each for each in LESSONS if each.exercise.name == name), None)
        if lesson is None:
            raise UsageError(f"%answer NAME: there is no such exercise; the names are {', '.join(_names())}")
        offered = {each.language: each for each in (lesson, *lesson.others)}
        if language and language not in offered:
            raise UsageError(f"%answer {name}: it is offered in {' and '.join(offered)}")
        lesson = offered.get(language, lesson)
        shell: Any = self.shell
        text = f"**{lesson.exercise.title}**\n\n{lesson.text}"
        shell.display_pub.publish({"text/markdown": text, "text/plain": text})
        shell.set_next_input(f"%%answer {lesson.exercise.name}\n{lesson.node.rstrip()}")

    @cell_magic
    def drive(self, line: str, cell: str) -> None:
        """``%%drive SECONDS [--name NAME] [--quiet] [-- NODE ARGS]``: run the cell with a vehicle, and draw it."""
        self._display(plots.drive(self._run("drive", _beside_a_vehicle, line, cell)))

    @cell_magic
    def facts(self, line: str, cell: str) -> None:
        """``%%facts``: statements that hold if the text around the cell is true. Those that fail are reported, no more.

        A build of the site then fails; a reader who has changed a node continues.
        """
        shell: Any = self.shell
        found = list(Facts(shell.user_ns).run(_below_its_magic(cell), f"<cell {shell.execution_count}>"))
        if found:
            said = "\n".join(f"The text around this cell no longer holds: {stands}\n{now}" for _, stands, now in found)
            shell.display_pub.publish({MIME: json.dumps(found), "text/plain": said})

    def _is_attended(self) -> bool:
        """Whether a reader runs the notebook and can be asked for input, not a build of the site."""
        kernel = getattr(self.shell, "kernel", None)
        return kernel is None or bool(kernel._allow_stdin)

    def _display(self, figure: Any) -> None:
        shell: Any = self.shell
        shell.display_pub.publish({"text/html": pictures.page(figure), "text/plain": pictures.alternative(figure)})

    def _run(self, magic: str, run: Callable[..., Run], line: str, cell: str) -> Run:
        own, args = split_words(shlex.split(line))
        options = _parser(magic).parse_args(own)
        shell: Any = self.shell
        node = load_cell(_below_its_magic(cell), f"<cell {shell.execution_count}>")
        streams = () if options.quiet else (sys.stdout, sys.stderr)
        found = shell.user_ns[options.name] = run(node, options.seconds, args, *streams)
        return found


def _beside_a_vehicle(node: Code, seconds: float, args: Sequence[str], *streams: TextIO) -> Run:
    with capture(*streams) as console:
        result = run_beside(node, args, [VEHICLES[node.hint or 2]], seconds, Simulation(), TickLog())
    tell_uncalled(result, seconds, *streams[1:])
    return result.run(console.text(), "simulated", seconds)


def _names() -> list[str]:
    return [each.exercise.name for each in LESSONS]
