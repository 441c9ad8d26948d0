"""Two services of one name: both are asked, the first answer counts; when one is destroyed, the other continues."""

import rclpy
from scenario import say
from test_msgs.srv import BasicTypes


def answer(name):
    def call(request, response):
        say(name, "asked", request.int32_value)
        response.string_value = name
        return response

    return call


rclpy.init()
node = rclpy.create_node("services_two_servers")
services = [node.create_service(BasicTypes, "work", answer(name)) for name in ("first", "second")]
client = node.create_client(BasicTypes, "work")
say(node.count_services("work"), client.service_is_ready())
for number in range(2):
    future = client.call_async(BasicTypes.Request(int32_value=number))
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0.1)
    say("answered by", future.result().string_value)
node.destroy_service(services[0])
say(node.count_services("work"), client.service_is_ready())
future = client.call_async(BasicTypes.Request(int32_value=2))
rclpy.spin_until_future_complete(node, future)
say("answered by", future.result().string_value)
rclpy.shutdown()
