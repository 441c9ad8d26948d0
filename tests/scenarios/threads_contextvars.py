"""A thread begins with an empty context, a copied one can be taken along, and a timer's calls share their thread's."""

import contextvars
import threading

import rospy
from scenario import P, begin, block, end_after, say, until

name = contextvars.ContextVar("name", default="nobody")


def note(key):
    before = name.get()
    name.set(key)
    until(1)
    results[key] = (before, name.get())


begin("threads_contextvars")
results = {}
name.set("main")
workers = [threading.Thread(target=note, args=("bare",))]
workers.append(threading.Thread(target=contextvars.copy_context().run, args=(note, "copied")))
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
say(sorted(results.items()), name.get())


def callback(event):
    seen.append(name.get())
    name.set(f"call {len(seen)}")


seen = []
rospy.Timer(rospy.Duration(P), callback)
block(3.5)
say(seen, name.get())
end_after(0)
