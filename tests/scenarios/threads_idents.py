"""Each thread has an ident of its own, which stays the same; the main is the main thread and no other is."""

import threading

import rospy
from scenario import P, begin, say, until


def note(name):
    first = threading.get_ident()
    until(2)
    idents[name] = threading.get_ident()
    own = threading.current_thread()
    facts.append((name, first == idents[name] == own.ident, own is threading.main_thread(), own.native_id is not None))


begin("threads_idents")
idents, facts = {}, []
workers = [threading.Thread(target=note, args=(name,)) for name in ("a", "b")]
for worker in workers:
    worker.start()
rospy.Timer(rospy.Duration(P), lambda event: note("timer"), oneshot=True)
note("main")
until(3)
say(sorted(facts), len(set(idents.values())))
say([worker.ident == idents[name] for worker, name in zip(workers, "ab")])
say(threading.main_thread() is threading.current_thread(), threading.main_thread().ident == idents["main"])
