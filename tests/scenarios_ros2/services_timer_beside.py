"""A slow service holds up a timer, as any callback does in a SingleThreadedExecutor."""

import rclpy
from scenario import P, begin, block, end_after, mark
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    block(2.4)
    return response


def ask():
    timer.cancel()
    client.call_async(Trigger.Request()).add_done_callback(lambda _: mark("answered"))


rclpy.init()
node = rclpy.create_node("services_timer_beside")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
begin()
node.create_timer(P, lambda: mark("tick"))
timer = node.create_timer(1.5 * P, ask)
end_after(6.7)
rclpy.spin(node)
