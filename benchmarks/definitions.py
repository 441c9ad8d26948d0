"""Write the message definitions that rosspin carries, from the pinned rosbags: `make definitions`.

rosbags has the definitions of the ROS releases, without comments and without default values; the defaults of the few
ROS 2 fields that have one are added here. One text for each ROS, each definition headed as in a bag file.
"""

from __future__ import annotations

from pathlib import Path

from rosbags.typesys import Stores, get_typestore

from rosspin.results.saving import save_whole

FOLDER = Path(__file__).parents[1] / "src" / "rosspin" / "messages"

COMMON = [
    "std_msgs",
    "geometry_msgs",
    "sensor_msgs",
    "nav_msgs",
    "rosgraph_msgs",
    "actionlib_msgs",
    "diagnostic_msgs",
    "trajectory_msgs",
    "visualization_msgs",
]

# File -> the release, ROS 1 or 2, its packages, whose they are.
FILES = {
    "noetic.txt": (
        Stores.ROS1_NOETIC,
        1,
        COMMON,
        "# The message definitions of ROS Noetic, without their comments. They come from the packages std_msgs and\n"
        "# rosgraph_msgs and from those of common_msgs, (c) Willow Garage, Inc. and others, BSD-3-Clause.\n",
    ),
    "jazzy.txt": (
        Stores.ROS2_JAZZY,
        2,
        ["builtin_interfaces", "rcl_interfaces", *COMMON],
        "# The message definitions of ROS 2 Jazzy, without their comments. They come from the packages of\n"
        "# common_interfaces and rcl_interfaces, (c) Open Source Robotics Foundation, Inc. and others, Apache-2.0.\n",
    ),
}

# (message, field) -> default value.
DEFAULTS = {
    ("geometry_msgs/Quaternion", "x"): "0",
    ("geometry_msgs/Quaternion", "y"): "0",
    ("geometry_msgs/Quaternion", "z"): "0",
    ("geometry_msgs/Quaternion", "w"): "1",
    ("rcl_interfaces/ParameterDescriptor", "read_only"): "false",
    ("rcl_interfaces/ParameterDescriptor", "dynamic_typing"): "false",
    ("sensor_msgs/NavSatStatus", "status"): "-2",
}


def text(file: str) -> str:
    """What the file is to hold."""
    release, version, packages, head = FILES[file]
    store = get_typestore(release)
    parts = [head + "# `make definitions` writes this file, from rosbags (Apache-2.0, Ternaris).\n"]
    for name in sorted(store.fielddefs):
        package, _, short = name.split("/")
        if package in packages:
            definition, _ = store.generate_msgdef(name, ros_version=version)
            own, _, _ = definition.partition("=" * 80)  # the nested ones follow
            lines = [line.rstrip() for line in own.splitlines()]
            if version == 2:
                lines = [with_default(f"{package}/{short}", line) for line in lines]
            parts.append("\n".join([f"MSG: {package}/{short}", *filter(None, lines), ""]))
    return ("=" * 80 + "\n").join(parts)


def with_default(message: str, line: str) -> str:
    """A line of a ROS 2 definition, with the default value of its field."""
    default = DEFAULTS.get((message, line.rpartition(" ")[2]))
    return f"{line} {default}" if default else line


if __name__ == "__main__":
    for file in FILES:
        save_whole(FOLDER / file, text(file).encode())
