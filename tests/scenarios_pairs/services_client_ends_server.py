"""Lets the client go while its callback runs, in a group of its own; the answer is dropped without a word."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from scenario import begin, invite, mark, say, spin_for, spin_until
from std_srvs.srv import Trigger


async def answer(request, response):
    say("asked")
    invite(node)
    say(spin_until(node, lambda: node.count_clients("slow") == 0))
    spin_for(node, 0.5)
    begin()
    done.append(True)
    return response


rclpy.init()
node = rclpy.create_node("server")
done = []
node.create_service(Trigger, "slow", answer, callback_group=ReentrantCallbackGroup())
spin_until(node, lambda: done)
mark("answered")
rclpy.shutdown()
