"""What message_filters makes of messages and stamps."""

import random

import rospy
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from std_msgs.msg import Header, String


def say(*words):
    print(*words, flush=True)


def attempt(text, names):
    try:
        say(text, "->", eval(text, {"rospy": rospy, **names}))
    except Exception as error:
        say(text, "->", type(error).__name__, error)


rospy.init_node("filters_values")


class Stamped:
    def __init__(self, name, tenths):
        self.header = Header(stamp=rospy.Time(tenths // 10, tenths % 10 * 100000000))
        self.name = name

    def __repr__(self):
        return f"{self.name}{self.header.stamp.to_sec():.1f}"


def show(label):
    return lambda *messages: say(label, *messages)


def feed(filters, steps):
    for number, tenths in steps:
        filters[number].signalMessage(Stamped("abc"[number], tenths))


draw = random.Random(4)
for number, queue_size in ((1, 3), (2, 1), (2, 3), (3, 2), (3, 10)):
    filters = [SimpleFilter() for _ in range(number)]
    exact = TimeSynchronizer(filters, queue_size)
    exact.registerCallback(show(f"exact {number} {queue_size}:"))
    for slop in (0.1, 0.3, 1.5):
        near = ApproximateTimeSynchronizer(filters, queue_size, slop)
        near.registerCallback(show(f"approximate {number} {queue_size} {slop}:"), "and more")
    feed(filters, [(draw.randrange(number), step + draw.randrange(-4, 5) + 10) for step in range(40)])
    say([sorted(queue.values(), key=repr) for queue in near.queues])

source = SimpleFilter()
cache = Cache(source, 3)
say(cache.getLast(), cache.getLastestTime(), cache.getLatestTime(), cache.getOldestTime())
say(cache.getElemAfterTime(rospy.Time(1)), cache.getElemBeforeTime(rospy.Time(1)))
cache.registerCallback(show("cached:"))
say(cache.registerCallback(show("second:"), 1, 2))
for tenths in (10, 30, 20, 40, 25):
    source.signalMessage(Stamped("m", tenths))
say(cache.getLast(), cache.getOldestTime(), cache.getLatestTime())
say(cache.getInterval(rospy.Time(2), rospy.Time(4)), cache.getInterval(rospy.Time(5), rospy.Time(6)))
for tenths in (19, 20, 26, 41):
    time = rospy.Time(tenths // 10, tenths % 10 * 100000000)
    say(tenths, cache.getElemAfterTime(time), cache.getElemBeforeTime(time))
attempt("cache.getInterval(rospy.Time(4), rospy.Time(2))", {"cache": cache})

source.signalMessage(String("no header"))
anyway = Cache(source, 2, allow_headerless=True)
anyway.registerCallback(lambda message: say("anyway:", message.data))
source.signalMessage(String("no header"))
say(type(anyway.getLatestTime()).__name__)

exact = TimeSynchronizer([source], 2)
attempt("source.signalMessage(String('no header'))", {"source": source, "String": String})
say(exact.lock.locked())
near = ApproximateTimeSynchronizer([SimpleFilter()], 2, 0.5)
near.add(String("no header"), near.queues[0], 0)
near = ApproximateTimeSynchronizer([SimpleFilter()], 2, 0.5, allow_headerless=True)
near.registerCallback(lambda message: say("near:", type(message).__name__))
near.add(String("no header"), near.queues[0], 0)
near.add(Stamped("late", 10), near.queues[0])
say(near.slop)
attempt("ApproximateTimeSynchronizer([], 2)", {"ApproximateTimeSynchronizer": ApproximateTimeSynchronizer})


def fails(*messages):
    raise ValueError("no")


def failing():
    filters = [SimpleFilter(), SimpleFilter()]
    exact = TimeSynchronizer(filters, 2)
    exact.registerCallback(fails)
    try:
        feed(filters, [(0, 1), (1, 1)])
    except ValueError as error:
        say(error, exact.lock.locked(), [len(queue) for queue in exact.queues])


failing()

hears = Subscriber("chatter", Header, queue_size=5)
say(hears.getTopic(), hears.topic, hears.name, hears.type)
hears.registerCallback(show("heard:"), "more")
attempt("hears.no_such_name", {"hears": hears})
attempt("Subscriber()", {"Subscriber": Subscriber})
publisher = rospy.Publisher("chatter", Header, queue_size=5)
rospy.sleep(1)
publisher.publish(Header(frame_id="base"))
rospy.sleep(0.5)
hears.unregister()
publisher.publish(Header(frame_id="late"))
rospy.sleep(0.5)
