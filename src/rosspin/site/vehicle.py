"""The vehicle of the first page: the nodes that steer it, and what is shown of their runs."""

from __future__ import annotations

import html
import io
import json
from contextlib import chdir
from pathlib import Path

from ..measures import by_source
from ..plots.vehicle import PERIOD, SECONDS, Drive, drive, preview, svg
from ..results.saving import save_whole
from ..run.simulate import simulate

__all__ = ["NODES", "drawing", "figure", "save_preview"]

_PROBE1 = "_second_timer:=true _block:={} _block_call:=8"
_PROBE2 = "--ros-args -p second_timer:=true -p block:={} -p block_call:=8"

# By the name to show: a node with two timers, and its arguments. The second steers; one call of the first takes {} s.
NODES = {
    "ROS 2 in Python": ("examples/ros2/timer_probe.py", _PROBE2),
    "ROS 2 in C++": ("examples/ros2/timer_probe.cpp", _PROBE2),
    "ROS 2, two threads, a group each": ("examples/ros2/timer_probe.py", f"{_PROBE2} -p executor:=multi -p group:=own"),
    "ROS 1 in Python": ("examples/timing_probes/src/timer_probe.py", _PROBE1),
    "ROS 1 in C++": ("examples/timing_probes/src/timer_probe.cpp", _PROBE1),
}
_STEERING = {"second_callback", "callback 2", "lambda 2"}
_LENGTHS = [n / 10 for n in range(21)]  # that the call takes, s
_AT = 1.8  # shown first

_CAPTION = (
    "Simulated. Each dot is a tick of the timer that steers. Where the way is thick and orange, a tick is overdue. "
    "When both callbacks were due at the same time, rclcpp called the one that steers first."
)


def _drive(name: str, length: float) -> Drive:
    file, words = NODES[name]
    ticks = simulate(file, SECONDS, words.format(length).split()).ticks
    steering = next(group for source, group in by_source(ticks).items() if source in _STEERING)
    return drive(tick.real for tick in steering)


def _alternative(name: str, length: float, shown: Drive) -> str:
    overdue = "".join(f" A tick is overdue from {first:g} s to {last:g} s." for first, last in shown.overdue)
    return (
        f"A vehicle on a winding line, steered by a timer every {PERIOD:g} s. {name}, another callback takes "
        f"{length:g} s: the vehicle {shown.words}.{overdue}"
    )


def drawing(root: Path) -> tuple[str, str]:
    """Return the picture of the README as an SVG file, and its text alternative. ``root`` is the source folder."""
    name = next(iter(NODES))
    with chdir(root):
        shown = _drive(name, _AT)
    alternative = _alternative(name, _AT, shown)
    return svg(shown, alternative, standalone=True), alternative


def save_preview(root: Path, file: Path, title: str) -> None:
    """Save the picture of links to the site as a PNG."""
    with chdir(root):
        shown = _drive(next(iter(NODES)), _AT)
    words = f"Another callback takes {_AT:g} s: the vehicle {shown.words}."
    drawn = io.BytesIO()
    preview(shown, title, words).savefig(drawn, format="png", dpi=100, metadata={"Software": None})
    save_whole(file, drawn.getvalue())


def _position(name: str, length: float, shown: Drive) -> tuple[str, str, str, str, float]:
    """Return what web/src/vehicle.js shows of a drive."""
    words = f"It {shown.words}.".replace(" s.", "\N{NO-BREAK SPACE}s.")
    return words, _alternative(name, length, shown), shown.path, shown.dashes, round(shown.when, 2)


def figure(root: Path) -> str:
    """Return the figure of the first page as HTML: as drawn first, with all that the page's script needs to move it."""
    with chdir(root):
        drives = {name: [_drive(name, length) for length in _LENGTHS] for name in NODES}
    positions = [
        [_position(name, *both) for both in zip(_LENGTHS, found, strict=True)] for name, found in drives.items()
    ]
    data = json.dumps([SECONDS, _LENGTHS, positions], separators=(",", ":"))
    first = _LENGTHS.index(_AT)
    words, alternative, *_ = positions[0][first]
    choices = "".join(
        f'<label><input type="radio" name="vehicle" value="{number}"{" checked" * (not number)} autocomplete="off"> '
        f"{html.escape(name)}</label>"
        for number, name in enumerate(NODES)
    )
    return f"""<figure class="rosspin-plot rosspin-vehicle" data-vehicle='{data}'>
<fieldset hidden><legend>A node of</legend>{choices}</fieldset>
<label class="rosspin-handle" hidden>Another callback takes <b aria-hidden="true">{_AT:.1f} s</b>
<input type="range" min="0" max="{len(_LENGTHS) - 1}" step="1" value="{first}" autocomplete="off"
aria-valuetext="{_AT:.1f} s">
</label>
{svg(drives[next(iter(NODES))][first], alternative)}
<p><button type="button" hidden>Play</button> <output>{words}</output></p>
<figcaption>{_CAPTION}</figcaption></figure>"""
