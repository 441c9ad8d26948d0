"""tf2's core as it is in ROS 1 (sources: buffer_core.cpp, cache.cpp 0.7.6): what differs from ROS 2's."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator

from .frames import Frames, Moving, faults
from .geometry import Transform

__all__ = ["NoeticFrames"]

_FARTHEST = 0.01  # by how much the square of a quaternion's length may differ from 1


class _Moving(Moving):
    """Keeps one transform for each time, the first."""

    def add(self, stamp: int, parent: str, transform: Transform) -> str:
        stamps = self.stamps
        if stamps and stamps[-1] > stamp + self._keep:
            reasons = "(Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained)"
            return f"TF_OLD_DATA ignoring data from the past {reasons}"
        at = bisect_left(stamps, stamp)
        if at < len(stamps) and stamps[at] == stamp:
            return "TF_REPEATED_DATA ignoring data with redundant timestamp"
        stamps.insert(at, stamp)
        self._states.insert(at, (parent, transform))
        old = bisect_left(stamps, stamps[-1] - self._keep)
        del stamps[:old], self._states[:old]
        return ""

    def _shown(self, time: int) -> str:
        return f"{time // 1_000_000_000}.{time % 1_000_000_000:09}"

    def _by(self, distance: int) -> str:
        return f"{self._shown(distance)}s "


class NoeticFrames(Frames):
    """Keeps the transforms of the last ``keep`` ns, as they are: what is no rotation is refused, not made one."""

    _REASONS = ""
    _moving = _Moving

    def _taken(self, transform: Transform) -> Transform:
        return transform

    def _faults(self, parent: str, child: str, transform: Transform, authority: str) -> Iterator[str]:
        for fault in faults(parent, child, transform, authority):
            yield fault.replace("frame_id and  child_frame_id ", "frame_id and child_frame_id  ")
        if abs(sum(part * part for part in transform.rotation) - 1) > _FARTHEST:
            quaternion = " ".join(f"{part:f}" for part in transform.rotation)
            yield (
                f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority '
                f'"{authority}" because of an invalid quaternion in the transform ({quaternion})'
            )

    def _is_replaced(self, cache: object, is_static: bool) -> bool:
        return False

    def _misnamed(self, frame: str, where: str) -> str:
        if frame.startswith("/"):
            return f"Invalid argument \"{frame}\" passed to {where} in tf2 frame_ids cannot start with a '/' like: "
        return "" if frame else f"Invalid argument passed to {where} in tf2 frame_ids cannot be empty"

    def why_not(self, target: str, source: str, time: int) -> str | None:  # type: ignore[override]
        """Why ``find`` would raise; "" if it would not, None for a name that is only warned of."""
        return "" if target == source else self._why(time, time, target=target, source=source)

    def why_not_full(  # type: ignore[override]
        self, target: str, target_time: int, source: str, source_time: int, fixed: str
    ) -> str | None:
        """Likewise for ``find_full``."""
        return self._why(target_time, source_time, target=target, source=source, fixed=fixed)

    def _why(self, target_time: int, source_time: int, **frames: str) -> str | None:
        for name, frame in frames.items():
            if why := self._misnamed(frame, f"canTransform argument {name}_frame"):
                self._warning(why)
                return None
        if lacking := [name for name, frame in frames.items() if frame not in self._caches]:
            return " ".join(
                f"fixed_frame: {frames[name]}does not exist."  # as it is there
                if name == "fixed"
                else f"canTransform: {name}_frame {frames[name]} does not exist."
                for name in lacking
            )
        fixed = frames.get("fixed", frames["source"])
        why = self._why_no_way(frames["target"], fixed, target_time)
        return why or ("" if fixed == frames["source"] else self._why_no_way(fixed, frames["source"], source_time))

    def _shown(self, time: int) -> str:
        return f"{time / 1e9:.3f}"
