"""Services and clients whose quality of service does not match: never ready, never asked, and no word."""

import warnings

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_services_default
from scenario import say
from std_srvs.srv import Trigger

PROFILES = {
    "default": qos_profile_services_default,
    "best_effort": QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT),
    "transient_local": QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    "one": QoSProfile(depth=1),
}


def answer(request, response):
    asked.append(None)
    return response


rclpy.init()
node = rclpy.create_node("services_qos")
for of_service, first in PROFILES.items():
    for of_client, second in PROFILES.items():
        asked = []
        service = node.create_service(Trigger, "work", answer, qos_profile=first)
        client = node.create_client(Trigger, "work", qos_profile=second)
        future = client.call_async(Trigger.Request())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an answer that does not arrive
            rclpy.spin_until_future_complete(node, future, timeout_sec=0.2)
        say(of_service, of_client, client.service_is_ready(), len(asked), future.done())
        node.destroy_service(service)
        node.destroy_client(client)
rclpy.shutdown()
