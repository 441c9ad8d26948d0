"""Condition.wait and wait_for with a timeout: what they answer, and when."""

import threading

from scenario import P, begin, mark, say, until

condition = threading.Condition()
values = []


def produce():
    for number in (2, 4):
        until(number)
        with condition:
            values.append(number)
            condition.notify_all()


begin("threads_condition_timeout")
producer = threading.Thread(target=produce)
producer.start()
with condition:
    say("too short", condition.wait(P))
    mark("too_short")
    say("notified", condition.wait(3 * P))
    mark("notified")
    say("predicate", condition.wait_for(lambda: len(values) >= 2, timeout=P))
    mark("predicate_fails")
    say("predicate", condition.wait_for(lambda: len(values) >= 2 and values, timeout=3 * P))
    mark("predicate_holds")
    say("at once", condition.wait_for(lambda: "true already"))
    mark("at_once")
producer.join()
