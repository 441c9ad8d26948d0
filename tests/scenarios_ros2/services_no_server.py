"""A request for which there was no server is lost, even if a server comes later."""

import rclpy
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    return response


rclpy.init()
node = rclpy.create_node("services_no_server")
client = node.create_client(Trigger, "work")
begin()
lost = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, lost, timeout_sec=P)
mark("nobody")
say(lost.done(), lost.cancelled(), lost.result(), client.service_is_ready())
node.create_service(Trigger, "work", answer)
say(client.service_is_ready(), client.wait_for_service(0))
rclpy.spin_until_future_complete(node, lost, timeout_sec=P)
mark("lost")
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=P)
mark("served")
say(lost.done(), future.done())
rclpy.shutdown()
