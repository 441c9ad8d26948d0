"""The command line: ``python -m rosspin run FILE``."""

from __future__ import annotations

import argparse
import json
import os
import signal
import stat
import sys
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext, suppress
from importlib.metadata import version
from pathlib import Path
from typing import Any, BinaryIO

from .clocks.descendants import adopt_orphans, descendants, kill_descendants
from .clocks.explored import Order
from .clocks.frames import Whereabouts, node_place
from .clocks.guard import guard_threads
from .clocks.simulation import Simulation
from .doctor import report
from .faults import Fault, read
from .look import Look, NoLog, look
from .look.pinning import as_files
from .measures import by_source, describe_faults, describe_periods, describe_timeline
from .orders.beside import side_by_side
from .orders.exploring import compare_orders
from .plots import both_orders, overview, picture, pictures
from .real import ros1, ros2
from .results.folders import sweep
from .results.saving import save_whole
from .results.ticks import FaultEvent, Run, Tick
from .run.explain import say_error
from .run.host import Result, duration
from .run.kinds import language_of
from .run.process import leave
from .run.roslaunch.launch import read_launch
from .run.simulate import prepare, run_in_order, run_node, run_nodes, several, tell_uncalled, with_jitter
from .run.source import is_launch_of_ros2, load, refuse_other_ros, split_words, warn_of_files
from .run.wall import wall_clock
from .world.graph import TickLog

__all__ = ["main"]


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line ``argv`` (default: the process's) and return the exit status."""
    try:
        try:
            return _main(argv)
        finally:
            sys.stdout.flush()
    except BrokenPipeError:  # whoever read what is printed has seen enough, as after `| head`
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
        return 128 + getattr(signal, "SIGPIPE", 13)


def _main(argv: Sequence[str] | None) -> int:
    own, node_args = split_words(sys.argv[1:] if argv is None else argv)
    options, unknown = _parser().parse_known_args(own)
    unknown += [word for word in getattr(options, "files", [])[1:] if not (word.endswith(".py") or language_of(word))]
    if unknown:
        options.parser.error(f"unknown arguments: {' '.join(unknown)} (put the node's own arguments after --)")
    options.alone = argv is None  # this process is there for the command alone
    if options.alone:
        sweep()
    try:
        return int(options.do(options, node_args))
    except BrokenPipeError:
        raise
    except (OSError, ValueError, SyntaxError, RuntimeError) as error:
        sys.stdout.flush()
        print(f"rosspin: {say_error(error)}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 128 + signal.SIGINT


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="rosspin", description="Run a ROS node without ROS, and see when it ticks.", allow_abbrev=False
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="show the version")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    run = commands.add_parser(
        "run",
        help="run a node file",
        description="Run a node file on the wall clock until Ctrl-C, in simulated time, or on the real ROS 1 or 2.",
        usage="%(prog)s FILE... [--seconds S] [--simulated [--skip-cpp] [--start S] [--fault FAULT]... "
        "[--jitter S] [--schedule TOKEN] | --ros1 | --ros2] [--plot FILE] [-- NODE ARGS]",
        epilog="Everything after -- is passed to the node: __ns:=/mrp _rate:=10, or on ROS 2 --ros-args -r __ns:=/mrp. "
        "Nodes and launch files are programs, and run with all your rights: a launch file may run commands "
        "(<param command>), or any Python ($(eval), .launch.py).",
        allow_abbrev=False,
    )
    run.add_argument(
        "files",
        metavar="FILE",
        nargs="+",
        help="a node in Python or C++ (with --ros2, in Python), or a launch file; with --simulated, several nodes",
    )
    run.add_argument("--seconds", type=float, metavar="S", help="press Ctrl-C after S seconds")
    where = run.add_mutually_exclusive_group()
    where.add_argument("--simulated", action="store_true", help="run in simulated time, which takes almost no time")
    where.add_argument("--ros1", action="store_true", help="use the real ROS 1, which must be installed")
    where.add_argument("--ros2", action="store_true", help="use the real ROS 2, which must be installed")
    run.add_argument("--skip-cpp", action="store_true", help="leave out the nodes of a launch file that are in C++")
    run.add_argument(
        "--start",
        type=float,
        metavar="S",
        help="with --simulated: what the node's clocks tell at first, in s (default: 0)",
    )
    run.add_argument(
        "--fault",
        action="append",
        default=[],
        metavar="FAULT",
        help="with --simulated: what should go wrong, as in --fault 'Topic(\"/scan\", drop=0.1)'; may be repeated",
    )
    run.add_argument(
        "--jitter",
        type=float,
        default=0.0,
        metavar="S",
        help="with --simulated: threads and callbacks are late by up to S seconds",
    )
    run.add_argument(
        "--schedule",
        metavar="TOKEN",
        help="with --simulated: run in this order of events, which rosspin.explore has found",
    )
    run.add_argument(
        "--plot",
        metavar="FILE",
        help="plot the ticks to this .pdf, .png or .svg, and describe them on stderr; with --schedule, plot the usual "
        "order and this one, step by step where they differ",
    )
    run.set_defaults(do=_run, parser=run)
    judge = commands.add_parser(
        "judge",
        help="judge answers to exercises",
        description="Judge answers to the exercises: hand-ins, node files and notebooks, and folders and zips of them.",
        usage="%(prog)s FILE... [--csv FILE] [--json] [--unsealed] [--workers MODULE:NAME]",
        epilog="The exit status is 0 if all answers are right, 1 if one is not, 2 if the command line is not, and 130 "
        "after Ctrl-C, which keeps what has been judged.",
        allow_abbrev=False,
    )
    judge.add_argument("paths", metavar="FILE", nargs="+", help="a hand-in, or a folder or zip of them")
    judge.add_argument("--csv", metavar="FILE", help="save a table for spreadsheets, with a row for each student")
    judge.add_argument("--json", action="store_true", help="print all that is known as JSON, in place of words")
    judge.add_argument(
        "--unsealed", action="store_true", help="judge also where answers cannot be sealed, with all of your rights"
    )
    judge.add_argument(
        "--workers",
        metavar="MODULE:NAME",
        help="have the processes of this executor judge the answers, as in concurrent.futures:ProcessPoolExecutor",
    )
    judge.set_defaults(do=_judge, parser=judge)
    look = commands.add_parser(
        "look",
        help="look at a log of your own robot",
        description="Say what repeats in a log, at what period and how late, and which fault that looks like. A log is "
        "a console of ROS 1 or ROS 2, a table of ros2 topic echo --csv or rostopic echo -p, or a bag "
        "(.bag, .db3, .mcap).",
        allow_abbrev=False,
    )
    look.add_argument("log", metavar="FILE", help="the log; - reads a text from standard input")
    look.add_argument("--plot", metavar="FILE", help="plot what repeats to this .pdf, .png or .svg")
    look.add_argument(
        "--test", metavar="FOLDER", help="write a node with these periods, and a test that it passes, into this folder"
    )
    look.add_argument("--json", action="store_true", help="print all that was found as JSON, times in seconds")
    look.set_defaults(do=_look, parser=look)
    doctor = commands.add_parser("doctor", help="show what can run here", description="Show what can run here.")
    doctor.set_defaults(do=_doctor, parser=doctor)
    return parser


class _Version(argparse.Action):
    """Says the version, which takes a while to look up, when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *others: Any) -> None:
        print(f"rosspin {version('rosspin')}")
        parser.exit()


def _doctor(options: argparse.Namespace, args: Sequence[str]) -> int:
    for line in report():
        print(line)
    return 0


def _judge(options: argparse.Namespace, args: Sequence[str]) -> int:
    if not hasattr(os, "fork"):
        raise ValueError("judge needs Linux or macOS, or WSL on Windows; the page for teachers needs a browser only")
    from .grading import elsewhere, judge  # not there on Windows

    with elsewhere.executor_of(options.workers) if options.workers else nullcontext() as executor:
        return judge(options.paths, options.csv, options.json, options.unsealed, executor)


def _look(options: argparse.Namespace, args: Sequence[str]) -> int:
    if options.plot is not None:
        _check_plot(options.plot)
    name = options.log if options.log != "-" else "standard input"
    with _open_log(options.log) if options.log != "-" else nullcontext(sys.stdin.buffer) as file:
        try:
            shown = look(file, name, _show_part if sys.stderr.isatty() else lambda part: None)
        except NoLog as error:
            raise ValueError(f"{name}: {error}") from error
    if options.json:
        print(json.dumps(shown.as_dict(), indent=1))
    else:
        print(*shown.report(), sep="\n")
    if options.test is not None:
        _write_test(shown, Path(options.test))
    return _save(options.plot, lambda: overview(shown.ticks())) if options.plot is not None else 0


def _open_log(path: str) -> BinaryIO:
    """Open a log. A device is none, and to open one may change it; a named pipe is not waited for."""
    mode = os.stat(path).st_mode
    if stat.S_ISCHR(mode) or stat.S_ISBLK(mode):
        raise ValueError(f"{path}: this is a device, and no log")
    file = open(path, "rb", opener=lambda path, flags: os.open(path, flags | getattr(os, "O_NONBLOCK", 0)))
    if stat.S_ISFIFO(mode):
        os.set_blocking(file.fileno(), True)  # if nothing writes into it, it is empty
    return file


def _show_part(part: float) -> None:
    """Show on the terminal how far it is, and at the end nothing."""
    bar = f"[{'#' * round(20 * part):.<20}] {part:.0%}" if part < 1 else ""
    print(f"\r{bar}\033[K", end="", file=sys.stderr, flush=True)


def _write_test(shown: Look, folder: Path) -> None:
    """Write the node and the test: both or neither, and none over one that is there already."""
    files = {folder / name: text for name, text in as_files(shown).items()}
    if not files:
        raise ValueError(f"{shown.name}: nothing in it is regular, so there is no test to write")
    for path in files:
        if path.exists():
            raise ValueError(f"{path} is there already")
    folder.mkdir(parents=True, exist_ok=True)
    written = list[Path]()
    try:
        for path, text in files.items():
            save_whole(path, text.encode())
            written.append(path)
    except OSError:
        for path in written:
            path.unlink()
        raise
    print(f"Written: {', '.join(map(str, files))}", file=sys.stderr)


def _run(options: argparse.Namespace, args: Sequence[str]) -> int:
    if options.simulated and options.seconds is None:
        raise ValueError("--simulated needs --seconds: no one can press Ctrl-C in simulated time")
    options.file, *others = options.files
    if others and not options.simulated:
        raise ValueError("several nodes run in simulated time only: --simulated")
    of_ros2 = is_launch_of_ros2(options.file)
    launched = options.file.endswith(".launch") or of_ros2
    if options.ros2 and language_of(options.file):
        raise ValueError(f"{options.file}: on a real ROS, C++ nodes run on ROS 1 only: --ros1")
    if launched and not (of_ros2 or options.ros1 or options.simulated):
        raise ValueError(
            f"{options.file}: launch files run in simulated time or on the real ROS 1: --simulated or --ros1"
        )
    if of_ros2 and not options.simulated:
        raise ValueError(f"{options.file}: launch files of ROS 2 run in simulated time: --simulated")
    if (options.ros1 or options.ros2) and options.file.endswith(".py"):
        refuse_other_ros(options.file, 1 if options.ros1 else 2)
    if options.skip_cpp and not (launched and options.simulated):
        raise ValueError("--skip-cpp is for launch files in simulated time")
    for name in ("start", "fault", "jitter", "schedule"):
        if getattr(options, name) != options.parser.get_default(name) and not options.simulated:
            raise ValueError(f"--{name} is for simulated time: --simulated")
    if options.plot is not None:
        _check_plot(options.plot)
    guarded = guard_threads(_say_where_it_computed) if options.simulated and options.alone else nullcontext()
    with guarded:
        result = _result(options, args, record=options.plot is not None)
    status = result.status
    faults = result.host.recording.fault_events() if options.fault and isinstance(result, Result) else ()
    if faults:
        sys.stdout.flush()
        print(f"rosspin: {describe_faults(faults)}", file=sys.stderr)
    if options.simulated and isinstance(result, Result):
        sys.stdout.flush()
        tell_uncalled(result, options.seconds, sys.stderr)
    if options.plot is not None:
        sys.stdout.flush()
        if options.schedule is None:
            failed = _plot(result.ticks, faults, options.plot)
        else:
            failed = _plot_orders(options, args)
        status = status or failed
    if isinstance(result, Result) and result.host.processes:
        leave(status, result.world)
    return status


def _result(options: argparse.Namespace, args: Sequence[str], record: bool) -> Result | Run:
    if options.ros1 or options.ros2:
        # These signals, which ask this process to end, should end the nodes, too.
        for number in (signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.default_int_handler)
        _warn_of_files(options.file, args)
        real = ros1.launch if options.ros1 else ros2.launch
        return real(options.file, options.seconds, args, sys.stdout)
    ticks = TickLog() if record else None
    faults = _wrong(options)
    files = options.files if len(options.files) > 1 else options.file
    if options.schedule is not None:
        prepared = prepare(files, args, options.skip_cpp, Order.of(options.schedule).deep, faults)
        return run_in_order(prepared, options.seconds, options.schedule, options.start or 0.0, ticks)
    launched = several(files, args, options.skip_cpp)
    simulation = Simulation(duration(options.start or 0.0, "start"))
    if launched:
        return run_nodes(launched, options.seconds, simulation, ticks, faults=faults)
    if options.alone:
        adopt_orphans()
    before = descendants(os.getpid())  # the children of a shell that this process replaced

    def end_others() -> None:
        if options.alone:
            kill_descendants(but=before)

    def give_up(result: Result) -> None:
        sys.stdout.flush()
        end_others()

    try:
        node = load(options.file)
        clock = simulation if options.simulated else wall_clock(node)
        return run_node(node, options.seconds, args, clock, ticks, give_up, faults)
    finally:
        end_others()


def _warn_of_files(file: str, args: Sequence[str]) -> None:
    # The run will show what is wrong with the file.
    with suppress(OSError, SyntaxError, ValueError), warnings.catch_warnings(action="ignore"):
        launched = read_launch(file, args, skip_cpp=True, commands=False).nodes if file.endswith(".launch") else ()
        nodes = [each.node for each in launched] or [file]
        warn_of_files([load(node) for node in nodes if str(node).endswith(".py")])


def _say_where_it_computed(stacks: list[Whereabouts]) -> str:
    place = node_place(place for each in stacks for place in each.places)
    where = f"{place.filename}:{place.line}: " if place else ""
    return f"rosspin: {where}this has let nothing else run for a minute, and heeds no signal; the process was killed\n"


def _check_plot(path: str) -> None:
    """Find out before a long run whether its plot could be saved."""
    if os.path.splitext(path)[1] not in pictures.SUFFIXES:
        raise ValueError(f"--plot {path}: the file name must end in .pdf, .png or .svg")
    if not os.path.isdir(os.path.dirname(path) or "."):
        raise FileNotFoundError(f"--plot {path}: there is no such folder")
    if os.path.isdir(path):
        raise IsADirectoryError(f"--plot {path}: this is a folder")
    if advice := pictures.missing():
        raise ValueError(f"--plot {path}: {advice}")


def _save(path: str, draw: Callable[[], Any]) -> int:
    """Save a figure, or say why not: what was asked for besides counts all the same. Returns an exit status."""
    try:
        pictures.save(draw(), path)
    except (ImportError, OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        print(f"rosspin: {path} was not written: {reason}", file=sys.stderr)
        return 1
    return 0


def _picture(ticks: Sequence[Tick], faults: Sequence[FaultEvent]) -> Any:
    if not ticks:
        raise ValueError("the node did not tick")
    return picture(ticks, faults=faults)


def _wrong(options: argparse.Namespace) -> Sequence[Fault]:
    """Return what should go wrong in the run."""
    return with_jitter([read(text) for text in options.fault], options.jitter)


def _plot_orders(options: argparse.Namespace, args: Sequence[str]) -> int:
    """Save and describe a plot of the order of a token next to the usual one, which takes another run of each."""
    found = compare_orders(
        options.files if len(options.files) > 1 else options.file,
        options.seconds,
        Order.of(options.schedule),
        args,
        options.skip_cpp,
        start=options.start or 0.0,
        faults=_wrong(options),
    )
    if failed := _save(options.plot, lambda: both_orders(found)):
        return failed
    print(f"{options.plot}:", *side_by_side(found), sep="\n", file=sys.stderr)
    return 0


def _plot(ticks: Sequence[Tick], faults: Sequence[FaultEvent], path: str) -> int:
    """Save and describe the plot. Returns an exit status."""
    if failed := _save(path, lambda: _picture(ticks, faults)):
        return failed
    for source, group in by_source(ticks).items():
        print(f"{path}: {describe_timeline(source, group)} {describe_periods(group)}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
