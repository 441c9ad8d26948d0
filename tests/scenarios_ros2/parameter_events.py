"""Each change of a parameter is told on /parameter_events, another node's, too."""

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent
from rclpy.parameter import Parameter
from rclpy.parameter_event_handler import ParameterEventHandler
from scenario import say


def names(parameters):
    return [(parameter.name, parameter.value.type) for parameter in parameters]


def hear(event):
    kinds = event.new_parameters, event.changed_parameters, event.deleted_parameters
    say(event.node, *map(names, kinds))


def spin():
    for _ in range(8):
        rclpy.spin_once(node, timeout_sec=0.05)


rclpy.init()
node = rclpy.create_node("parameter_events")
subscription = node.create_subscription(ParameterEvent, "/parameter_events", hear, 100)
node.declare_parameter("rate", 10.0)
node.declare_parameter("free", 1, ParameterDescriptor(dynamic_typing=True))
node.declare_parameter("empty", descriptor=ParameterDescriptor(dynamic_typing=True))
spin()
node.set_parameters([Parameter("rate", value=5.0), Parameter("empty", value="full")])
node.set_parameters_atomically([Parameter("rate", value=6.0), Parameter("free", value="text")])
node.set_parameters([Parameter("rate", value="refused")])
spin()
node.set_parameters([Parameter("free")])
node.undeclare_parameter("empty")
spin()
other = rclpy.create_node("other", namespace="/deep")
spin()
other.declare_parameter("count", 3)
spin()
node.destroy_subscription(subscription)

handler = ParameterEventHandler(node)
first = handler.add_parameter_callback("rate", "parameter_events", lambda parameter: say("first", parameter.name))
again = handler.add_parameter_callback("rate", "", lambda parameter: say("again", parameter.value.double_value))
every = handler.add_parameter_event_callback(lambda event: say("event", event.node))
deep = handler.add_parameter_callback("count", "/deep/other", lambda parameter: say(parameter.value.integer_value))
node.set_parameters([Parameter("rate", value=7.0)])
spin()
other.set_parameters([Parameter("count", value=4)])
spin()
handler.remove_parameter_callback(first)
handler.remove_parameter_event_callback(every)
for remove, handle in [
    (handler.remove_parameter_callback, first),
    (handler.remove_parameter_event_callback, every),
]:
    try:
        remove(handle)
    except RuntimeError as error:
        say(error)
node.set_parameters([Parameter("rate", value=8.0)])
spin()
handler.destroy()
node.set_parameters([Parameter("rate", value=9.0)])
spin()
say(node.count_publishers("/parameter_events"), [publisher.topic_name for publisher in node.publishers])
rclpy.shutdown()
