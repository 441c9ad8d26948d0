"""An answer to a client that is gone: 0.1 s and a warning if it went before the callback began, else no word."""

import warnings

import rclpy
from scenario import begin, mark, say
from std_srvs.srv import SetBool


def answer(request, response):
    if request.data:
        node.destroy_client(client)
    return response


rclpy.init()
node = rclpy.create_node("services_answer_lost")
node.create_service(SetBool, "switch", answer)
begin()
for meanwhile in (False, True):
    client = node.create_client(SetBool, "switch")
    client.call_async(SetBool.Request(data=meanwhile))
    if not meanwhile:
        node.destroy_client(client)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        rclpy.spin_once(node)
    mark("served")
    say([f"{each.category.__name__}: {each.message}" for each in caught])
rclpy.shutdown()
