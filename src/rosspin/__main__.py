"""The command line: ``python -m rosspin run FILE``."""

from __future__ import annotations

import argparse
import os
import sys
import traceback
from collections.abc import Sequence

from .rospy.threads import own_frames
from .rospy.world import NotSimulated
from .run import TimeStandsStill, load, run_simulated, run_wall

__all__ = ["main"]


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line ``argv`` (default: the process's own); the exit status."""
    options = _parser().parse_args(argv)
    try:
        return _run(options)
    except (OSError, ValueError, SyntaxError, NotSimulated, TimeStandsStill, ImportError) as error:
        sys.stdout.flush()
        print(f"rosspin: {_say(error)}", file=sys.stderr)
        return 1


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="rosspin", description="Run a ROS node that spins at a frequency, without ROS.", allow_abbrev=False
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    run = commands.add_parser(
        "run",
        help="run a node file",
        description="Run a node file as rospy would: on the wall clock until Ctrl-C, or in simulated time.",
        allow_abbrev=False,
    )
    run.add_argument("file", metavar="FILE", help="the node, a Python file")
    run.add_argument("--seconds", type=float, metavar="S", help="press Ctrl-C after S seconds")
    run.add_argument("--simulated", action="store_true", help="in simulated time, which takes next to none")
    run.add_argument("--plot", metavar="FILE.svg", help="draw the node's ticks into this file")
    run.add_argument("args", nargs="*", metavar="NODE ARGS", help="the node's own command line, after --")
    return parser


def _run(options: argparse.Namespace) -> int:
    if options.simulated and options.seconds is None:
        raise ValueError("--simulated needs --seconds: nobody can press Ctrl-C in simulated time")
    if options.plot is not None:
        _check_plot(options.plot)
    node = load(options.file)
    record = options.plot is not None
    if options.simulated:
        result = run_simulated(node, options.seconds, options.args, record)
    else:
        result = run_wall(node, options.seconds, options.args, record)
    if options.plot is not None:
        if not result.ticks:
            raise ValueError(f"{options.plot} is not written: the node did not tick")
        from .plots import timeline

        timeline(result.ticks).save(options.plot)
    return result.status


def _check_plot(path: str) -> None:
    """Find out before a long run what would lose its plot."""
    if not path.endswith(".svg"):
        raise ValueError(f"--plot {path}: the name must end in .svg")
    if not os.path.isdir(os.path.dirname(path) or "."):
        raise FileNotFoundError(f"--plot {path}: there is no such folder")
    try:
        import matplotlib  # noqa: F401
    except ModuleNotFoundError:
        raise ImportError("--plot needs matplotlib: pip install matplotlib") from None


def _say(error: Exception) -> str:
    if isinstance(error, SyntaxError):
        return "".join(traceback.format_exception_only(error)).strip()
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, NotSimulated):
        trace = own_frames((error.__cause__ or error).__traceback__)
        places = [frame for frame in traceback.extract_tb(trace) if not frame.filename.startswith("<frozen")]
        return f"{places[-1].filename}:{places[-1].lineno}: {error}" if places else str(error)
    return str(error)


if __name__ == "__main__":
    sys.exit(main())
