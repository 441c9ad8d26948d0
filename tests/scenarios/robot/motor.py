"""A motor that takes its commands from a queue, in a thread of its own."""

import queue
import threading

import scenario

commands = queue.Queue()
done = []


def command(value):
    """Let the motor do something, when it has time."""
    commands.put(value)


def stop():
    """Let the motor do what it was told, and stop."""
    commands.put(None)
    worker.join()
    scenario.mark("stopped")


def _run():
    while (value := commands.get()) is not None:
        scenario.block(1.25)
        done.append(value)
        scenario.mark("done")


worker = threading.Thread(target=_run, name="motor", daemon=True)
worker.start()
