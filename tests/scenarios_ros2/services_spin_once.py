"""A loop that spins once and looks whether the answer is there; a timeout that passes; work in between."""

import rclpy
from scenario import P, begin, block, mark, say
from std_srvs.srv import SetBool


def answer(request, response):
    say("asked", request.data)
    return response


rclpy.init()
node = rclpy.create_node("services_spin_once")
node.create_service(SetBool, "switch", answer)
client = node.create_client(SetBool, "switch")
begin()
future = client.call_async(SetBool.Request(data=True))
while not future.done():
    rclpy.spin_once(node, timeout_sec=0.1)
mark("answered")
rclpy.spin_once(node, timeout_sec=P)
mark("nothing")
future = client.call_async(SetBool.Request(data=False))
block(0.5)
say(future.done())
rclpy.spin_once(node, timeout_sec=0)
say(future.done())
block(0.5)
rclpy.spin_once(node, timeout_sec=0)
say(future.done())
mark("end_of_loop")
rclpy.shutdown()
