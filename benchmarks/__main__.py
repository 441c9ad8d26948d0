"""``make bench``: what rosspin costs, as ratios of two things measured in the same run, each with its goal."""

import importlib
import sys

from .limited import run

PARTS = ["ticks", "threads", "topics", "ros2", "day", "lateness", "ros1_beside", "ros2_beside", "orders", "site_build"]
PARTS += ["live", "cpp_ticks"]

# None takes a third of it on a slow machine.
LIMIT = 900.0  # s


def main() -> int:
    if len(sys.argv) > 1:
        for line in importlib.import_module(f"{__package__}.{sys.argv[1]}").report():
            print(line, flush=True)
        return 0
    print(__doc__, "Times are in brackets: they are this machine's.\n", sep="\n", flush=True)
    failed = 0
    for part in PARTS:
        if why := run([sys.executable, "-m", __package__, part], LIMIT):
            print(f"  {part}: not measured to the end: {why}", flush=True)
            failed = 1
        print(flush=True)
    return failed


if __name__ == "__main__":  # a part may spawn processes, which import this
    sys.exit(main())
