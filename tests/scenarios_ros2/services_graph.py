"""What the graph knows of services and clients: every node's are among them."""

import rclpy
from scenario import attempt, say
from std_srvs.srv import SetBool, Trigger

rclpy.init()
node = rclpy.create_node("services_graph")
plain = rclpy.create_node("plain", namespace="ns", start_parameter_services=False)
service = node.create_service(SetBool, "switch", print)
plain.create_service(SetBool, "/switch", print)
plain.create_service(Trigger, "work", print)
client = plain.create_client(Trigger, "/nobodys")


def show(names):
    for name, types in names:
        say("   ", name, types)


def look():
    say("all")
    show(node.get_service_names_and_types())
    for name, namespace in (("services_graph", "/"), ("plain", "/ns")):
        say("services of", name)
        show(node.get_service_names_and_types_by_node(name, namespace))
        say("clients of", name)
        show(node.get_client_names_and_types_by_node(name, namespace))
    say(node.count_services("switch"), node.count_clients("nobodys"), node.count_services("nobodys"))


look()
attempt("node.get_service_names_and_types_by_node('nobody', '/')", {"node": node})
attempt("node.get_client_names_and_types_by_node('nobody', '/')", {"node": node})
say([each.srv_name for each in node.services][:6], [each.srv_name for each in plain.clients])
node.destroy_service(service)
plain.destroy_client(client)
look()
say(node.get_topic_names_and_types())
rclpy.shutdown()
