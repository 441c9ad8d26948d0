"""Requests and responses of nested messages arrive as they were sent; times and headers, too."""

import rospy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from nav_msgs.srv import GetPlan, GetPlanRequest, LoadMap
from scenario import begin, say
from std_msgs.msg import Header


def plan(request):
    say(request)
    path = Path(Header(7, rospy.Time(3, 4), "map"), [request.start, request.goal])
    path.poses[0].pose.position.x = 9.0
    return path


begin("services_values")
rospy.Service("~plan", GetPlan, plan)
rospy.Service("~load", LoadMap, lambda request: {"result": len(request.map_url)})
plan_proxy, load = rospy.ServiceProxy("~plan", GetPlan), rospy.ServiceProxy("~load", LoadMap)
request = GetPlanRequest(tolerance=0.1)
request.start = PoseStamped(header=Header(stamp=rospy.Time(1.5), frame_id="here"))
request.goal.pose.orientation.w = 1.0
say(plan_proxy(request))
say(request.start.pose.position.x, request.start.header.seq)
say(load("four").result, load(map_url="naïve").result)
say(load(None).result)
