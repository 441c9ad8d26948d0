"""call() in a callback: the client is of another node, which another executor spins in a thread of its own."""

import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, block, end_after, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    block(0.5)
    response.message = "done"
    return response


def ask():
    mark("asks")
    say(client.call(Trigger.Request()).message)
    mark("answered")


rclpy.init()
node = rclpy.create_node("services_other_executor")
helper = rclpy.create_node("helper")
helper.create_service(Trigger, "work", answer)
client = helper.create_client(Trigger, "work")
executor = SingleThreadedExecutor()
executor.add_node(helper)
begin()
threading.Thread(target=executor.spin, daemon=True).start()
node.create_timer(P, ask)
end_after(3.2)
rclpy.spin(node)
