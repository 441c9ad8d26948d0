"""``make bench``: what rosspin costs, as ratios of two things measured in the same run, each with its goal."""

import day
import lateness
import live
import orders
import ros1_beside
import ros2
import ros2_beside
import site_build
import threads
import ticks
import topics

print(__doc__, "Times are in brackets: they are this machine's.\n", sep="\n", flush=True)
for part in (ticks, threads, topics, ros2, day, lateness, ros1_beside, ros2_beside, orders, site_build, live):
    for line in part.report():
        print(line, flush=True)
    print()
