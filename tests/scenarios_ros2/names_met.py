"""A node whose class gives another answer where Node is asked for its name, a topic's or a parameter."""

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos_overriding_options import QoSOverridingOptions
from scenario import say
from std_msgs.msg import String
from std_srvs.srv import Trigger

NAMES = """
get_name get_namespace get_fully_qualified_name get_parameter get_parameter_or has_parameter set_parameters_atomically
resolve_topic_name resolve_service_name default_callback_group
""".split()


def uses(node):
    yield "declare", lambda: node.declare_parameter("p", 1).value
    yield "set", lambda: node.set_parameters([Parameter("p", value=2)])[0].successful
    yield "publish", lambda: node.create_publisher(String, "topic", 1).topic_name
    options = {"qos_overriding_options": QoSOverridingOptions.with_default_policies()}
    yield "subscribe", lambda: node.create_subscription(String, "t", print, 1, **options).topic_name
    yield "serve", lambda: node.create_service(Trigger, "service", print).srv_name
    yield "count", lambda: node.count_publishers("topic")
    yield "infos", lambda: len(node.get_publishers_info_by_topic("topic"))
    yield "parameters", lambda: sorted(node._parameters)


def tried(function):
    try:
        return function()
    except Exception as error:
        return f"{type(error).__name__} {error}"


def use(kind):
    made = tried(lambda: kind("used"))
    if isinstance(made, Node):
        for name, function in uses(made):
            say(" ", name, "->", tried(function))
        made.destroy_node()
    else:
        say(" ", made)


rclpy.init()
for name in NAMES:
    for answer in ("own", None):
        say(name, "gives", answer)
        use(type("Own", (Node,), {name: lambda self, *args, _answer=answer: _answer}))


class Called(Node):
    def get_name(self):
        return super().get_name() + "_called"

    def set_parameters_atomically(self, parameters):
        say("set by set_parameters_atomically")
        return super().set_parameters_atomically(parameters)


node = Called("node", allow_undeclared_parameters=True)
watch = rclpy.create_node("watch")


def tell(event):
    lists = (event.new_parameters, event.changed_parameters, event.deleted_parameters)
    say(event.node, *([parameter.name for parameter in each] for each in lists))


watch.create_subscription(ParameterEvent, "/parameter_events", tell, 10)
node.add_on_set_parameters_callback(lambda parameters: say("asked") or rclpy.node.SetParametersResult(successful=True))
node.declare_parameter("speed", 1.0)
node.set_parameters([Parameter("speed", value=2.0), Parameter("new", value=1), Parameter("never")])
node.set_descriptor("speed", ParameterDescriptor(type=3, description="m/s"))
node.set_parameters([Parameter("new")])
for _ in range(6):
    rclpy.spin_once(watch, timeout_sec=0.3)
say([name for name, _ in watch.get_service_names_and_types_by_node("node", "/")])
rclpy.shutdown()
