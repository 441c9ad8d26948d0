"""What rosgraph says of names, and of the master."""

# ruff: noqa: F401
import rosgraph
import rosgraph.masterapi
import rosgraph.names
import roslib.names
import rospy
from rosgraph.names import (
    anonymous_name,
    canonicalize_name,
    get_ros_namespace,
    is_global,
    is_legal_base_name,
    is_legal_name,
    is_private,
    load_mappings,
    make_caller_id,
    make_global_ns,
    namespace,
    ns_join,
    resolve_name,
    script_resolve_name,
)
from std_msgs.msg import String


def attempt(text):
    try:
        value = eval(text)
    except Exception as error:
        value = type(error), error
    print(text, "->", value, flush=True)


for text in (
    "get_ros_namespace(), get_ros_namespace({'ROS_NAMESPACE': 'a/b'}, []), get_ros_namespace({}, ['__ns:=c'])",
    "make_caller_id('node'), make_caller_id('/a/node'), make_global_ns('a'), make_global_ns('/a/')",
    "make_global_ns('~a')",
    "is_global('/a'), is_global('a'), is_private('~a'), is_legal_name('a b'), is_legal_base_name('a/b')",
    "namespace('/a/b'), namespace('/a'), namespace(''), ns_join('/a', 'b'), ns_join('/a', '/b'), ns_join('~', 'b')",
    "canonicalize_name('/a//b/'), load_mappings(['a:=b', '_p:=1', 'x'])",
    "resolve_name('a', '/ns/node'), resolve_name('~a', '/ns/node'), resolve_name('', '/ns/node')",
    "resolve_name('a', '/ns/node', {'/ns/a': '/b'}), resolve_name('/a', '/ns/node', {'a': '/b'})",
    "script_resolve_name('me', 'a'), script_resolve_name('me', '~a'), script_resolve_name('me', '/a')",
    "script_resolve_name('me', '')",
    "is_legal_name(anonymous_name('me')), anonymous_name('me')[:3], anonymous_name('') == anonymous_name('')",
    "rosgraph.myargv(['a', 'b:=c', '_d:=1']), rosgraph.names.MSG_EXT, rosgraph.names.ANYTYPE",
    "rosgraph.is_master_online(), rosgraph.get_master_uri().startswith('http://'), rosgraph.ROS_MASTER_URI",
):
    attempt(text)

rospy.init_node("asks")
master = rosgraph.Master("/asks")
rospy.Publisher("~chat", String, queue_size=1)
rospy.Subscriber("/other", String)
rospy.sleep(0.5)
for text in (
    "master.is_online(), master.caller_id, rosgraph.Master('a/b').caller_id",
    "[[topic for topic, nodes in kind if '/asks' in nodes] for kind in master.getSystemState()]",
    "master.getPublishedTopics('/asks'), [each for each in master.getTopicTypes() if each[0] == '/other']",
    "master.lookupNode('/asks') == rospy.get_node_uri()",
    "master.lookupNode('asks') == rospy.get_node_uri()",
    "master.lookupNode('/nobody')",
    "master.lookupService('/nothing')",
    "master.lookupService('/asks/get_loggers').startswith('rosrpc://')",
    "master.setParam('~own', 3), master.getParam('/asks/own'), master.hasParam('~own'), master.getParam('~own')",
    "master.searchParam('own'), '/asks/own' in master.getParamNames()",
    "master.deleteParam('~own'), master.hasParam('~own')",
    "master.getParam('~own')",
    "master.deleteParam('~own')",
    "master.searchParam('nothing')",
    "type(master.getPid()), master.getUri().startswith('http://')",
    "master.getNothing()",
    "issubclass(rosgraph.MasterError, rosgraph.MasterException), rosgraph.masterapi.Error is rosgraph.MasterError",
):
    attempt(text)
attempt("rosgraph.masterapi.Master is rosgraph.Master, roslib.names.resolve_name('~a', '/b')")
