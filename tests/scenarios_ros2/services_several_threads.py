"""Several threads call one client at a time: each gets its own answer."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import begin, block, mark, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    block(0.5)
    response.int32_value = 10 * request.int32_value
    return response


def ask(number):
    block(0.1 * number)
    response = client.call(BasicTypes.Request(int32_value=number))
    mark("answered")
    answers[number] = response.int32_value
    if len(answers) == 4:
        rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("services_several_threads")
node.create_service(BasicTypes, "work", answer)
client = node.create_client(BasicTypes, "work")
answers = {}
threads = [threading.Thread(target=ask, args=(number,)) for number in range(4)]
begin()
for thread in threads:
    thread.start()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    say("shut down")
for thread in threads:
    thread.join()
say(answers)
