"""get_master() answers for the master: what nodes, topics and services there are; and it holds the parameters."""

import rospy
from scenario import attempt, begin, say
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger

say(rospy.get_node_uri())
master = rospy.get_master()
begin("topics_master")
name = rospy.get_name()
say(rospy.get_node_uri() == "http://{}/".format(rospy.get_node_uri().split("/")[2]), master is rospy.get_master())
rospy.Publisher("~a/chat", String, queue_size=1)
rospy.Publisher("~b", Empty, queue_size=1)
rospy.Subscriber("~a/chat", String)
rospy.Subscriber("~any", rospy.AnyMsg)
rospy.Subscriber("~heard", Empty)
rospy.Service("~go", Trigger, lambda request: (True, ""))
rospy.sleep(0.5)


def own(rows):
    return sorted([each[0], each[1]] for each in rows if each[0].startswith(name))


code, text, state = master.getSystemState()
say(code, repr(text), *map(own, state))
say("in /rosout", [name in nodes for topic, nodes in state[0] if topic == "/rosout"])
code, text, types = master.getTopicTypes()
say(code, repr(text), own(types))
code, text, topics = master.getPublishedTopics("")
say(code, repr(text), own(topics))
say(master.getPublishedTopics("~a"), "under ~a")
code, text, pid = master.getPid()
say(code, repr(text), type(pid).__name__)
code, text, uri = master.getUri()
say(code, repr(text), uri.startswith("http://"))
say([node == rospy.get_node_uri() for node in master.lookupNode(name)])
code, text, uri = master.lookupService("~go")
say(code, text == f"rosrpc URI: [{uri}]", uri.startswith("rosrpc://"))
for call in (
    "lookupNode('nobody')",
    "lookupService('~stop')",
    "getParam('~none')",
    "setParam('~mine', {'b': [1, 2.5]})",
    "getParam('~mine')",
    "getParam('~mine/b')",
    "hasParam('~mine')",
    "hasParam('~none')",
    "searchParam('~mine')",
    "searchParam('~none')",
    "deleteParam('~mine')",
    "deleteParam('~mine')",
    "getPublishedTopics()",
    "getPid(3)",
    "getNothing()",
    "getBusInfo()",
    "setParam('~mine', None)",
    "__getitem__('~mine')",
    "__delitem__('~mine')",
):
    attempt("master." + call, {"master": master})
master["~own"] = {"b": 1}
say(master["~own"], master["~own/b"], "~own" in master, "~none" in master)
say([each for each in master if each.startswith(name + "/own")])
del master["~own"]
say("~own" in master)
