"""Offers a service, asks for another, and destroys both when it is invited."""

import rclpy
from scenario import spin_for, wait_for_invitation
from std_srvs.srv import SetBool, Trigger

rclpy.init()
node = rclpy.create_node("offering", namespace="/ns")
service = node.create_service(SetBool, "switch", print)
client = node.create_client(Trigger, "/nobodys")
wait_for_invitation(node)
node.destroy_service(service)
wait_for_invitation(node)
node.destroy_client(client)
spin_for(node, 2.0)
rclpy.shutdown()
