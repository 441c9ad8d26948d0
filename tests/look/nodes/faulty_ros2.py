"""A node of ROS 2 with the faults that its command line asks for: NAME ACTIVITY..."""

import sys
import time
from threading import Thread

import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int64

sys.path.insert(0, __file__.rpartition("/")[0])
from activities import Activity  # noqa: E402


class FaultyNode(Node):
    def __init__(self, name, words):
        super().__init__(name)
        for word in words:
            if word.startswith("stop="):  # as a machine that stalls, to a node of one thread
                self.stall(*map(float, word[5:].split(":")))
                continue
            self.add(Activity(word, lambda text: self.get_logger().info(text)))

    def stall(self, at, seconds):
        def stop():
            timer.cancel()
            time.sleep(seconds)

        timer = self.create_timer(at, stop)

    def add(self, activity):
        if activity.kind == "timer":
            self.create_timer(1 / activity.rate, activity)
        elif activity.kind == "burst":
            self.create_timer(1 / activity.rate, activity.burst)
        elif activity.kind == "sleep":
            Thread(target=activity.loop, args=[lambda: time.sleep(1 / activity.rate)], daemon=True).start()
        elif activity.kind == "rate":
            rate = self.create_rate(activity.rate)
            Thread(target=self.until_the_end, args=[activity, rate.sleep], daemon=True).start()
        elif activity.kind == "event":
            wait = lambda: time.sleep(activity.random.expovariate(activity.rate))  # noqa: E731
            Thread(target=activity.loop, args=[wait], daemon=True).start()
        elif activity.kind == "gc":
            Thread(target=activity.collect_garbage, daemon=True).start()
        elif activity.kind == "pub":
            publisher = self.create_publisher(Int64, "heading", 10)
            start = int(activity.get("first"))

            def publish():
                publisher.publish(Int64(data=start + activity.count + 1))
                activity()

            self.create_timer(1 / activity.rate, publish)
        elif activity.kind == "sub":
            depth = int(activity.get("queue") or 10)
            self.create_subscription(Int64, "heading", lambda message: activity(message.data), depth)

    def until_the_end(self, activity, sleep):
        try:
            activity.loop(sleep)
        except Exception:
            pass  # the Rate ends with the node


def main():
    words = [word for word in sys.argv[1:] if word != "--threads"]
    if words[-1].startswith("after="):
        time.sleep(float(words.pop().partition("=")[2]))
    rclpy.init()
    node = FaultyNode(words[0], words[1:])
    executor = MultiThreadedExecutor(4) if "--threads" in sys.argv else None
    try:
        rclpy.spin(node, executor)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


main()
