"""Waits for its end, and says what comes; it ignores the signals that it is given by name."""

import signal
import sys
import time

import rclpy
from rclpy.executors import ExternalShutdownException


def main():
    rclpy.init(args=sys.argv, signal_handler_options=rclpy.signals.SignalHandlerOptions.ALL)
    node = rclpy.create_node("waits")
    for name in sys.argv[1:]:
        if name == "--ros-args":
            break
        signal.signal(signal.Signals[name], signal.SIG_IGN)
    print("waiting", flush=True)
    if len(sys.argv) > 1 and sys.argv[1].startswith("SIG"):
        while True:
            time.sleep(1)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException) as error:
        print("caught", type(error).__name__, flush=True)
