"""Done callbacks of a call's future: the executor calls them, after the client's own; added late they come, too."""

import rclpy
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    response.message = "done"
    return response


def done(future):
    mark("done")
    say("answered", future.result().message, future.done())
    future.add_done_callback(lambda late: say("added late", late is future))


def ask():
    timer.cancel()
    future = client.call_async(Trigger.Request())
    future.add_done_callback(done)
    future.add_done_callback(lambda _: say("second"))
    say("asks", future.done())


rclpy.init()
node = rclpy.create_node("services_done_callback")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
begin()
timer = node.create_timer(P, ask)
node.create_timer(2.5 * P, rclpy.shutdown)
rclpy.spin(node)
