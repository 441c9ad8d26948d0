"""The frames of a tree, and where each was in its parent (sources: tf2's buffer_core.cpp, cache.cpp, static_cache.cpp).

Times are in ns; the time 0 stands for the latest one.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Container, Iterator

from .exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
)
from .geometry import IDENTITY, Transform, interpolate

__all__ = ["Frames", "Moving", "faults", "shown"]

_DEEPEST = 1000  # how far a frame may be from the root


class Moving:
    """Where a frame was, in which parent, during the last ``keep`` ns."""

    def __init__(self, keep: int) -> None:
        self._keep = keep
        self.stamps: list[int] = []  # in order
        self._states: list[tuple[str, Transform]] = []

    def add(self, stamp: int, parent: str, transform: Transform) -> str:
        """Add a transform. Return why it is ignored; "" if it is not."""
        stamps, state = self.stamps, (parent, transform)
        if stamps:
            oldest = stamps[-1] - self._keep
            old = bisect_left(stamps, oldest)
            del stamps[:old], self._states[:old]
            if stamp < oldest:
                return "TF_OLD_DATA ignoring data from the past"
        at = bisect_right(stamps, stamp)
        if state not in self._states[at - stamps.count(stamp) : at]:
            stamps.insert(at, stamp)
            self._states.insert(at, state)
        return ""

    def at(self, time: int) -> tuple[str, Transform]:
        """The parent at a time, and the transform. Raises ExtrapolationException."""
        stamps = self.stamps
        if not stamps:
            raise ExtrapolationException("")
        if time in (0, stamps[-1]):
            return self._states[-1]
        if time == stamps[0]:
            return self._states[0]
        if len(stamps) == 1:
            raise ExtrapolationException(
                f"Lookup would require extrapolation at time {self._shown(time)}, "
                f"but only time {self._shown(stamps[0])} is in the buffer"
            )
        if time > stamps[-1]:
            raise ExtrapolationException(
                f"Lookup would require extrapolation {self._by(time - stamps[-1])}into the future.  "
                f"Requested time {self._shown(time)} but the latest data is at time {self._shown(stamps[-1])}"
            )
        if time < stamps[0]:
            raise ExtrapolationException(
                f"Lookup would require extrapolation {self._by(stamps[0] - time)}into the past.  "
                f"Requested time {self._shown(time)} but the earliest data is at time {self._shown(stamps[0])}"
            )
        after = bisect_right(stamps, time)
        (parent, one), (later_parent, other) = self._states[after - 1 : after + 1]
        if parent != later_parent:
            return parent, one
        ratio = (time - stamps[after - 1]) / (stamps[after] - stamps[after - 1])
        return parent, interpolate(one, other, ratio)

    def latest(self) -> tuple[int, str] | None:
        """The newest time and the parent then."""
        return (self.stamps[-1], self._states[-1][0]) if self.stamps else None

    def clear(self) -> None:
        """Forget all."""
        self.stamps.clear()
        self._states.clear()

    def _shown(self, time: int) -> str:
        return shown(time)

    def _by(self, distance: int) -> str:
        """By how much something is too far away, as texts say it."""
        return ""


class _Static:
    """Where a frame is always; the methods are as in :class:`Moving`."""

    stamps = (0,)

    def add(self, stamp: int, parent: str, transform: Transform) -> str:
        self._state = parent, transform
        return ""

    def at(self, time: int) -> tuple[str, Transform]:
        return self._state

    def latest(self) -> tuple[int, str]:
        return 0, self._state[0]

    def clear(self) -> None:
        pass


class Frames:
    """Keeps the transforms of the last ``keep`` ns. ``error`` and ``warning`` log why one was not taken."""

    def __init__(self, keep: int, error: Callable[[str], object], warning: Callable[[str], object]) -> None:
        self._keep = keep
        self._error = error
        self._warning = warning
        self._caches: dict[str, Moving | _Static | None] = {}  # None: has no parent
        self._authorities: dict[str, str] = {}

    def __iter__(self) -> Iterator[str]:
        return iter(self._caches)

    def clear(self) -> None:
        """Forget where frames were, except for static ones."""
        for cache in self._caches.values():
            if cache:
                cache.clear()

    def add(
        self, parent: str, child: str, stamp: int, transform: Transform, authority: str, is_static: bool = False
    ) -> None:
        """Add where a frame was in its parent, as ``authority`` says."""
        parent, child = parent.removeprefix("/"), child.removeprefix("/")
        transform = self._taken(transform)
        if found := list(self._faults(parent, child, transform, authority)):
            for fault in found:
                self._error(fault)
            return
        cache = self._caches.get(child)
        if cache is None or self._is_replaced(cache, is_static):
            cache = self._caches[child] = _Static() if is_static else self._moving(self._keep)
        self._caches.setdefault(parent, None)
        if why := cache.add(stamp, parent, transform):
            self._warning(
                f"{why} for frame {child} at time {shown(stamp)} according to authority {authority}{self._REASONS}"
            )
        else:
            self._authorities[child] = authority

    # What differs in the core of ROS 1 follows, and is replaced there.

    _REASONS = "\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"
    _moving = Moving

    def _taken(self, transform: Transform) -> Transform:
        """The transform as it is kept, or given."""
        return transform.normalised()

    def _faults(self, parent: str, child: str, transform: Transform, authority: str) -> Iterator[str]:
        return faults(parent, child, transform, authority)

    def _is_replaced(self, cache: Moving | _Static, is_static: bool) -> bool:
        """Whether a transform makes what is kept of its frame start again."""
        return isinstance(cache, _Static) is not is_static

    def _misnamed(self, frame: str, where: str) -> str:
        """What is wrong with the name of a frame; "" if nothing is."""
        if frame.startswith("/"):
            return f"Invalid argument \"{frame}\" passed to {where} - in tf2 frame_ids cannot start with a '/'"
        return "" if frame else f'Invalid argument "" passed to {where} - in tf2 frame_ids cannot be empty'

    def _why_unusable(self, **frames: str) -> str:
        for name, frame in frames.items():
            where = f"canTransform argument {name}_frame"
            if why := self._misnamed(frame, where):
                return why.replace("Invalid argument", "Invalid frame ID", 1)
            if frame not in self._caches:
                return f'Invalid frame ID "{frame}" passed to {where} - frame does not exist'
        return ""

    def _shown(self, time: int) -> str:
        return shown(time)

    # --- looking up ---

    def find(self, target: str, source: str, time: int) -> tuple[Transform, int]:
        """The transform from ``source`` to ``target``, and its time. Raises what tf2 raises."""
        if target == source:
            latest = None if time else self._latest(target)
            return IDENTITY, latest[0] if latest else time
        self.check(target, "lookupTransform argument target_frame")
        self.check(source, "lookupTransform argument source_frame")
        transform, time = self._walk(target, source, time)
        return self._taken(transform), time

    def find_full(
        self, target: str, target_time: int, source: str, source_time: int, fixed: str
    ) -> tuple[Transform, int]:
        """The transform from ``source`` at one time to ``target`` at another, by way of a frame that stays."""
        for name, frame in (("target", target), ("source", source), ("fixed", fixed)):
            self.check(frame, f"lookupTransform argument {name}_frame")
        first, _ = self.find(fixed, source, source_time)
        second, time = self.find(target, fixed, target_time)
        return (second @ first).normalised(), time

    def why_not(self, target: str, source: str, time: int) -> str:
        """Why ``find`` would raise; "" if it would not."""
        if target == source:
            return ""
        return self._why_unusable(target=target, source=source) or self._why_no_way(target, source, time)

    def why_not_full(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> str:
        """Why ``find_full`` would raise; "" if it would not."""
        return (
            self._why_unusable(target=target, source=source, fixed=fixed)
            or self._why_no_way(target, fixed, target_time)
            or self._why_no_way(fixed, source, source_time)
        )

    def check(self, frame: str, where: str) -> None:
        """Raise InvalidArgumentException or LookupException for the name of a frame that cannot be looked up."""
        if why := self._misnamed(frame, where):
            raise InvalidArgumentException(why)
        if frame not in self._caches:
            raise LookupException(f'"{frame}" passed to {where} does not exist. ')

    def _why_no_way(self, target: str, source: str, time: int) -> str:
        try:
            if target != source:
                self._walk(target, source, time)
        except (ConnectivityException, ExtrapolationException, LookupException) as error:
            return str(error)
        return ""

    def _walk(self, target: str, source: str, time: int) -> tuple[Transform, int]:
        time = time or self.latest_common_time(target, source)
        up, top, failure = self._climb(source, [target], time)
        down, end, failed = self._climb(target, [top, source], time)
        if end == source != top:
            up = IDENTITY
        elif end != top:
            if error := failed or failure:
                raise ExtrapolationException(
                    f"{error}, when looking up transform from frame [{source}] to frame [{target}]"
                )
            raise self._unconnected(target, source)
        return down.inverse() @ up, time

    def _climb(self, frame: str, to: Container[str], time: int) -> tuple[Transform, str, ExtrapolationException | None]:
        """Go up from a frame to one of others, or as far as possible. Return the way, where it ends, and why there."""
        way = IDENTITY
        for _ in range(_DEEPEST + 1):
            cache = self._caches[frame]
            if frame in to or cache is None:
                return way, frame, None
            try:
                frame, step = cache.at(time)
            except ExtrapolationException as error:
                return way, frame, error
            way = step @ way
        raise self._loop()

    def latest_common_time(self, target: str, source: str) -> int:
        """The latest time at which the transform is known; 0 if it is forever. Raises what tf2 raises."""
        if target == source:
            latest = self._latest(source)
            return latest[0] if latest else 0
        above = []
        for stamp, parent in self._ancestors(source):
            above.append((stamp, parent))
            if parent == target:
                return _first(above)
        below = []
        parents = [parent for _, parent in above]
        for stamp, parent in self._ancestors(target):
            below.append((stamp, parent))
            if parent in parents:
                return _first(below + above[: parents.index(parent) + 1])
            if parent == source:
                return _first(below)
        raise self._unconnected(target, source)

    def _ancestors(self, frame: str) -> Iterator[tuple[int, str]]:
        for _ in range(_DEEPEST + 1):
            latest = self._latest(frame)
            if latest is None:
                return
            yield latest
            frame = latest[1]
        raise self._loop()

    def _latest(self, frame: str) -> tuple[int, str] | None:
        cache = self._caches.get(frame)
        return cache.latest() if cache else None

    def _unconnected(self, target: str, source: str) -> ConnectivityException:
        return ConnectivityException(
            f"Could not find a connection between '{target}' and '{source}' because they are not part of the same tree."
            "Tf has two or more unconnected trees."
        )

    def _loop(self) -> LookupException:
        return LookupException(f"The tf tree is invalid because it contains a loop.\n{self.as_string()}\n")

    # --- telling ---

    def as_string(self) -> str:
        """A line for each frame that has a parent."""
        return "".join(
            f"Frame {name} exists with parent {latest[1] if (latest := cache.latest()) else 'NO_PARENT'}.\n"
            for name, cache in self._caches.items()
            if cache
        )

    def as_yaml(self) -> str:
        """What is known of each frame, in YAML."""
        yaml = "" if self._caches else "[]"
        for name, cache in self._caches.items():
            if not cache or not (latest := cache.latest()):
                continue
            span = cache.stamps[-1] - cache.stamps[0]
            yaml += (
                f"{name}: \n  parent: '{latest[1]}'\n  broadcaster: '{self._authorities[name]}'\n"
                f"  rate: {len(cache.stamps) * 1e9 / max(span, 100_000):.3f}\n"
                f"  most_recent_transform: {self._shown(cache.stamps[-1])}\n"
                f"  oldest_transform: {self._shown(cache.stamps[0])}\n"
                f"  buffer_length: {span / 1e9:.3f}\n"
            )
        return yaml


def _first(ancestors: list[tuple[int, str]]) -> int:
    return min((stamp for stamp, _ in ancestors if stamp), default=0)


def faults(parent: str, child: str, transform: Transform, authority: str) -> Iterator[str]:
    """Why tf2 ignores a transform."""
    if child == parent:
        yield (
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  '
            f'child_frame_id "{child}" because they are the same'
        )
    if not child:
        yield f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id not set '
    if not parent:
        yield (
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}" '
            "because frame_id not set"
        )
    ignoring = f'Ignoring transform for child_frame_id "{child}" from authority "{authority}" because of'
    vector, quaternion = (f"({' '.join(f'{part:f}' for part in each)})" for each in transform)
    if any(map(math.isnan, (*transform.translation, *transform.rotation))):
        yield f"TF_NAN_INPUT: {ignoring} a nan value in the transform {vector} {quaternion}"
    if math.isnan(transform.rotation[3]):
        yield f"TF_DENORMALIZED_QUATERNION: {ignoring} an invalid quaternion in the transform {quaternion}"


def shown(time: int) -> str:
    """A time in seconds, with six digits after the point."""
    seconds, nanoseconds = divmod(time, 1_000_000_000)
    return f"{seconds + 1e-9 * nanoseconds:.6f}"
