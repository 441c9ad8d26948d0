"""Each thread has attributes of its own on a threading.local, each timer too."""

import threading

import rospy
from scenario import P, begin, block, end_after, say, until


class Settings(threading.local):
    color = "white"

    def __init__(self, gain):
        self.gain = gain
        self.calls = 0


own = threading.local()
settings = Settings(3)


def work(name):
    before = hasattr(own, "name")
    own.name = name
    settings.gain += len(name)
    until(2)
    results[name] = (before, own.name, settings.gain, settings.color)


def callback(event):
    settings.calls += 1
    calls.append(settings.calls)


begin("threads_local")
results, calls = {}, []
own.name = "main"
settings.gain = 100
workers = [threading.Thread(target=work, args=(name,)) for name in ("one", "three")]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
say(sorted(results.items()), own.name, settings.gain, settings.calls)
rospy.Timer(rospy.Duration(2 * P), callback)
until(2.5)
rospy.Timer(rospy.Duration(2 * P), callback)
block(4.75)
say(calls, settings.calls)
end_after(0)
