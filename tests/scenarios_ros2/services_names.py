"""Names of services, as they are resolved and remapped."""

import rclpy
from scenario import attempt
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("services_names")
names = {"node": node, "Trigger": Trigger}
for text in """
node.create_service(Trigger, 'a', print).service_name
node.create_service(Trigger, 'old', print).service_name
node.create_service(Trigger, '~/private', print).service_name
node.create_service(Trigger, '/b', print).service_name
node.create_service(Trigger, '{node}/c', print).service_name
node.create_client(Trigger, 'a').service_name
node.create_client(Trigger, 'a').service_is_ready()
node.create_client(Trigger, 'old').service_name
node.create_client(Trigger, 'old').srv_name
node.create_client(Trigger, 'new').service_is_ready()
node.resolve_service_name('old'), node.resolve_service_name('old', only_expand=True)
node.resolve_service_name('~/private'), node.resolve_service_name('~')
node.resolve_topic_name('old'), node.resolve_topic_name('~/private')
node.resolve_service_name('a b')
node.resolve_service_name('')
node.resolve_service_name(5)
node.count_services('a'), node.count_clients('a')
node.count_services('old'), node.count_services('new'), node.count_clients('/mrp/new')
node.count_services('nonsuch'), node.count_clients('nonsuch')
node.count_services('a b')
node.count_clients(5)
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
