"""What a done callback raises leaves spin()."""

import rclpy
from scenario import attempt, say
from std_srvs.srv import Trigger


def done(future):
    say("done")
    raise ValueError("in a done callback")


rclpy.init()
node = rclpy.create_node("services_done_callback_raises")
node.create_service(Trigger, "work", lambda request, response: response)
client = node.create_client(Trigger, "work")
future = client.call_async(Trigger.Request())
future.add_done_callback(done)
attempt("rclpy.spin(node)", {"rclpy": rclpy, "node": node})
say(future.done(), future.result())
rclpy.shutdown()
