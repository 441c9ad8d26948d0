"""call() where no thread spins: None when the timeout is over, and the request is served by whoever spins later."""

import rclpy
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    return response


rclpy.init()
node = rclpy.create_node("services_call_nobody_spins")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
begin()
say(client.call(Trigger.Request(), timeout_sec=P))
mark("late")
say(client.call(Trigger.Request(), 0))
mark("at_once")
say(client.call(Trigger.Request(), -1.0))
mark("negative")
for _ in range(6):
    rclpy.spin_once(node, timeout_sec=0.1)
mark("end_of_spins")
rclpy.shutdown()
