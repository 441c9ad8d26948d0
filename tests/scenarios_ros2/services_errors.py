"""Types and names that are wrong, and what is said of them."""

import rclpy
from rclpy.qos import QoSProfile
from scenario import attempt
from std_msgs.msg import String
from std_srvs.srv import Empty, SetBool, Trigger

rclpy.init()
node = rclpy.create_node("services_errors")
names = {
    "node": node,
    "client": node.create_client(SetBool, "switch"),
    "service": node.create_service(SetBool, "switch", print),
    **{"QoSProfile": QoSProfile, "String": String, "SetBool": SetBool, "Trigger": Trigger, "Empty": Empty},
}
for text in """
node.create_client(String, 'x')
node.create_client(SetBool.Request, 'x')
node.create_client(int, 'x')
node.create_client('SetBool', 'x')
node.create_client(None, 'x')
node.create_client(SetBool, '1x')
node.create_client(SetBool, '')
node.create_client(SetBool, 'a b')
node.create_client(SetBool, 'a//b')
node.create_client(SetBool, '{x}/a')
node.create_client(SetBool, 'x', QoSProfile(depth=1))
node.create_client(SetBool, 'x', qos_profile=10)
node.create_client(SetBool)
node.create_client(SetBool, 5)
node.create_service(String, 'x', print)
node.create_service(SetBool.Response, 'x', print)
node.create_service(int, 'x', print)
node.create_service(SetBool, '1x', print)
node.create_service(SetBool, '/', print)
node.create_service(SetBool, '~', print)
node.create_service(SetBool, 'x', print, qos_profile=10)
node.create_service(SetBool, 'x')
node.create_service(SetBool, 5, print)
node.create_service(Trigger, 'switch', print)
node.create_client(Trigger, 'switch')
node.create_service(SetBool, 'none', None) is not None
client.call_async(True)
client.call_async(SetBool)
client.call_async(SetBool.Response())
client.call_async(Trigger.Request())
client.call_async()
client.call(True)
client.call(SetBool.Response(), 1)
client.get_pending_request(7)
client.remove_pending_request(None)
client.wait_for_service('x')
client.srv_name, client.service_name, client.srv_type is SetBool, client.logger_name
client.qos_profile.depth, client.context is node.context
service.srv_name, service.service_name, service.srv_type is SetBool, service.logger_name
service.qos_profile.depth, service.callback is print
service.callback_group is node.default_callback_group, client.callback_group is node.default_callback_group
service.send_response(SetBool.Request(), None)
service.send_response(SetBool.Response(), None)
node.destroy_client(service), node.destroy_service(client), node.destroy_service(None)
SetBool()
SetBool.Request(data=True), SetBool.Response()
Empty.Request(), Empty.Response()
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
