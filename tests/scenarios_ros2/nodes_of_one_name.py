"""Of two nodes of one name, rcl warns: one publisher on /rosout is for both. The end of either takes it away."""

import rclpy
from rclpy.context import Context
from scenario import say

nodes = []


def make(name, **options):
    say("make", name, *options.items())
    nodes.append(rclpy.create_node(name, **options))


rclpy.init()
make("one")
make("one")
make("one", enable_rosout=False)
make("one")
nodes[1].destroy_node()
make("one")
make("one")
make("one", namespace="x")
make("other", namespace="/x", cli_args=["--ros-args", "-r", "__node:=one"])
make("quiet", enable_rosout=False)
make("quiet")
nodes[-2].destroy_node()
make("quiet")
nodes[-1].destroy_node()
nodes[-1].destroy_node()
make("quiet")
rclpy.logging.set_logger_level("rcl", 40)
make("quiet")
rclpy.logging.set_logger_level("rcl", 20)
rclpy.shutdown()

say("another context keeps the names")
own = Context()
own.init(args=[])
rclpy.init()
make("one")
rclpy.shutdown()
rclpy.init()
make("one", context=own)
rclpy.shutdown()
own.shutdown()

for args in (["--disable-rosout-logs"], ["--disable-rosout-logs", "--enable-rosout-logs"], ["--log-level", "error"]):
    say(*args)
    rclpy.init(args=["--ros-args", *args])
    make("one")
    make("one")
    rclpy.shutdown()
