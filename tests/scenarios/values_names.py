"""Names as the node sees them, for the command line that it was given."""

import sys

import rospy
from scenario import attempt

rospy.init_node("values_names")
for text in """
rospy.get_name()
rospy.get_namespace()
rospy.get_caller_id()
rospy.resolve_name('a')
rospy.resolve_name('/a')
rospy.resolve_name('~a')
rospy.resolve_name('~')
rospy.resolve_name('')
rospy.resolve_name('a/')
rospy.resolve_name('a//b')
rospy.resolve_name('/')
rospy.resolve_name('chatter')
rospy.resolve_name('/chatter')
rospy.resolve_name('a', '/other/node')
rospy.resolve_name('~a', '/other/node')
rospy.remap_name('chatter')
rospy.remap_name('nothing')
""".strip().splitlines():
    attempt(text)
print(rospy.myargv()[1:])
print(rospy.myargv(["x", "a:=b", "c", "__ns:=/d", "_e:=f"]))
print(sys.argv[1:])
