"""What introspection is configured with, and what of it is refused."""

import rclpy
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from scenario import attempt, say
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("introspection_errors")
client = node.create_client(BasicTypes, "add")
service = node.create_service(BasicTypes, "add", lambda request, response: response)
names = {"client": client, "service": service, "clock": node.get_clock(), "qos": qos_profile_system_default}
names |= {"State": ServiceIntrospectionState, "node": node}
for text in (
    "State.__module__, State.__name__",
    "list(State.__members__), State.CONTENTS, str(State.METADATA), State.OFF.value, int(State.CONTENTS)",
    "State.METADATA == 1, State.METADATA == State.METADATA, State(2)",
    "client.configure_introspection(1, 2, 3)",
    "service.configure_introspection(clock, 10, State.METADATA)",
    "client.configure_introspection(clock, qos, State.METADATA)",
    "client.configure_introspection(clock, qos, State.CONTENTS)",
    "service.configure_introspection(clock, qos, State.CONTENTS)",
    "node.get_publisher_names_and_types_by_node('introspection_errors', '/')",
    "[publisher.topic for publisher in node.publishers]",
    "node.count_publishers('/add/_service_event')",
    "node.destroy_client(client)",
    "node.count_publishers('/add/_service_event')",
    "client.configure_introspection(clock, qos, State.OFF)",
):
    attempt(text, names)
node.destroy_node()
attempt("service.configure_introspection(clock, qos, State.METADATA)", names)
say(sorted(name for name in dir(client) if "introspection" in name))
rclpy.shutdown()
