"""Looks what is known of another process's services and clients, and when it is gone."""

import rclpy
from scenario import invite, say, spin_for, spin_until

rclpy.init()
node = rclpy.create_node("watcher", start_parameter_services=False)
spin_until(node, lambda: node.count_services("/ns/switch") == node.count_clients("nobodys") == 1)
spin_for(node, 0.5)
for name, types in node.get_service_names_and_types():
    say(name, types)
say("services", node.get_service_names_and_types_by_node("offering", "/ns"))
say("clients", node.get_client_names_and_types_by_node("offering", "/ns"))
say(node.count_services("/ns/offering/get_parameters"))
invite(node)
say(spin_until(node, lambda: node.count_services("/ns/switch") == 0))
invite(node)
say(spin_until(node, lambda: node.count_clients("nobodys") == 0))
spin_for(node, 0.5)
for name, types in node.get_service_names_and_types():
    say(name, types)
rclpy.shutdown()
