"""What a node makes has a handle, which can be held; small functions beside."""

import rclpy
from rclpy.exceptions import InvalidHandle
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options, install_signal_handlers
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.type_description_service import START_TYPE_DESCRIPTION_SERVICE_PARAM
from rclpy.utilities import timeout_sec_to_nsec
from scenario import say
from std_msgs.msg import String
from std_srvs.srv import Empty

rclpy.init()
say(get_current_signal_handlers_options())
node = rclpy.create_node("handles")
made = {
    "timer": node.create_timer(1.0, lambda: None),
    "publisher": node.create_publisher(String, "topic", 1),
    "subscription": node.create_subscription(String, "topic", lambda message: None, 1),
    "client": node.create_client(Empty, "service"),
    "service": node.create_service(Empty, "service", lambda request, response: response),
    "guard": node.create_guard_condition(lambda: None),
}
for name, entity in {"node": node, **made}.items():
    with entity.handle:
        say(name, entity.handle is not None)
node.destroy_node()
for name, entity in {"node": node, **made}.items():
    try:
        with entity.handle:
            say(name, "held")
    except InvalidHandle as error:
        say(name, type(error).__name__)
say([timeout_sec_to_nsec(seconds) for seconds in (None, -1, 0, 1.5)])
say([topic_or_service_is_hidden(name) for name in ("/a/b", "/a/_b", "_a", "/a_b")])
say(START_TYPE_DESCRIPTION_SERVICE_PARAM)
rclpy.shutdown()
say(get_current_signal_handlers_options())
install_signal_handlers(SignalHandlerOptions.SIGTERM)
say(get_current_signal_handlers_options())
