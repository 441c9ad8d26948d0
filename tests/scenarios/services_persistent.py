"""A persistent proxy keeps its connection: one thread handles all its calls, and close() ends it for good."""

import threading

import rospy
from scenario import attempt, begin, say
from std_srvs.srv import SetBool

threads = set()


def handle(request):
    threads.add(threading.current_thread())
    if not request.data:
        raise ValueError("not true")
    return True, ""


begin("services_persistent")
rospy.Service("~a", SetBool, handle)
keeps, plain = rospy.ServiceProxy("~a", SetBool, persistent=True), rospy.ServiceProxy("~a", SetBool)
names = {"keeps": keeps, "plain": plain}
for text in ("keeps(True)", "keeps(True)", "keeps(False)", "keeps(True)"):
    attempt(text, names)
say(len(threads))
for text in ("plain(True)", "plain(True)", "plain.close()", "plain(True)"):
    attempt(text, names)
say(len(threads))
for text in ("keeps.close()", "keeps(True)", "keeps.close()", "keeps(True)"):
    attempt(text, names)
say(rospy.ServiceProxy("~a", SetBool, persistent=True).close())
