"""What is sent is a copy: neither side sees what the other changes afterwards."""

import rclpy
from scenario import say
from test_msgs.srv import BasicTypes


def answer(request, response):
    say(request)
    request.int32_value = 7
    response.float64_value = request.float64_value / 2
    response.float32_value = 0.1
    response.string_value = f"{request.string_value}!"
    response.uint8_value = 255
    kept.append(response)
    return response


rclpy.init()
node = rclpy.create_node("services_values")
kept = []
node.create_service(BasicTypes, "work", answer)
client = node.create_client(BasicTypes, "work")
request = BasicTypes.Request(bool_value=True, int32_value=-5, float64_value=0.1, string_value="a")
future = client.call_async(request)
request.string_value = "changed"
rclpy.spin_until_future_complete(node, future)
kept[0].string_value = "changed, too"
say(future.result())
say(request.int32_value, future.result() is kept[0], type(future.result()) is BasicTypes.Response)
rclpy.shutdown()
