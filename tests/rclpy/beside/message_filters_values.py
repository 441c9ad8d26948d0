"""What message_filters makes of messages and stamps."""

import random

import rclpy
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from rclpy.time import ClockType, Time
from std_msgs.msg import Header, String


class Stamped:
    def __init__(self, name, tenths):
        self.header = Header(stamp=at(tenths).to_msg())
        self.name = name

    def __repr__(self):
        return f"{self.name}{Time.from_msg(self.header.stamp).nanoseconds / 1e9:.1f}"


def at(tenths):
    return Time(nanoseconds=tenths * 10**8, clock_type=ClockType.ROS_TIME)


def show(label):
    return lambda *messages: print(label, *messages)


def feed(filters, steps):
    for number, tenths in steps:
        filters[number].signalMessage(Stamped("abc"[number], tenths))


def attempt(text, names):
    try:
        print(text, "->", eval(text, names))
    except Exception as error:
        print(text, "->", type(error).__name__, error)


rclpy.init()
draw = random.Random(4)
for number, queue_size in ((1, 3), (2, 1), (2, 3), (3, 2), (3, 10)):
    filters = [SimpleFilter() for _ in range(number)]
    exact = TimeSynchronizer(filters, queue_size)
    exact.registerCallback(show(f"exact {number} {queue_size}:"))
    for slop in (0.1, 0.3, 1.5):
        near = ApproximateTimeSynchronizer(filters, queue_size, slop)
        near.registerCallback(show(f"approximate {number} {queue_size} {slop}:"), "and more")
    feed(filters, [(draw.randrange(number), step + draw.randrange(-4, 5) + 10) for step in range(40)])
    print([sorted(queue.values(), key=repr) for queue in near.queues])

source = SimpleFilter()
cache = Cache(source, 3)
print(cache.getLast(), cache.getLastestTime(), cache.getOldestTime())
print(cache.getElemAfterTime(at(10)), cache.getElemBeforeTime(at(10)))
cache.registerCallback(show("cached:"))
print(cache.registerCallback(show("second:"), 1, 2))
for tenths in (10, 30, 20, 40, 25):
    source.signalMessage(Stamped("m", tenths))
print(cache.getLast(), cache.getOldestTime(), cache.getLastestTime())
print(cache.getInterval(at(20), at(40)), cache.getInterval(at(50), at(60)))
for tenths in (19, 20, 26, 41):
    print(tenths, cache.getElemAfterTime(at(tenths)), cache.getElemBeforeTime(at(tenths)))
attempt("cache.getInterval(late, early)", {"cache": cache, "late": at(40), "early": at(20)})
attempt("cache.getInterval(Time(), Time())", {"cache": cache, "Time": Time})
attempt("cache.getLatestTime()", {"cache": cache})

source.signalMessage(String(data="no header"))
anyway = Cache(source, 2, allow_headerless=True)
anyway.registerCallback(lambda message: print("anyway:", message.data))
source.signalMessage(String(data="no header"))
print(anyway.getLastestTime().clock_type.name)

exact = TimeSynchronizer([source], 2)
attempt("source.signalMessage(String())", {"source": source, "String": String})
print(exact.lock.locked())
near = ApproximateTimeSynchronizer([SimpleFilter()], 2, 0.5)
near.add(String(), near.queues[0], 0)
near = ApproximateTimeSynchronizer([SimpleFilter()], 2, 0.5, allow_headerless=True)
near.registerCallback(lambda message: print("near:", type(message).__name__))
near.add(String(), near.queues[0], 0)
near.add(Stamped("late", 10), near.queues[0])
print(near.slop)
attempt("ApproximateTimeSynchronizer([], 2)", {"ApproximateTimeSynchronizer": ApproximateTimeSynchronizer})

node = rclpy.create_node("node")
hears = Subscriber(node, Header, "chatter")
print(hears.getTopic(), hears.topic, hears.topic_name, hears.node is node)
hears.registerCallback(show("heard:"), "more")
attempt("hears.no_such_name", {"hears": hears})
publisher = node.create_publisher(Header, "chatter", 10)
publisher.publish(Header(frame_id="base"))
rclpy.spin_once(node, timeout_sec=1)
rclpy.shutdown()
