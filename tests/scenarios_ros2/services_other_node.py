"""A service in a node that is not spun does not answer; when both are spun, it does."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger

rclpy.init()
server = rclpy.create_node("server")
asker = rclpy.create_node("asker")
server.create_service(Trigger, "work", lambda request, response: response)
client = asker.create_client(Trigger, "work")
begin()
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(asker, future, timeout_sec=P)
mark("spun")
say(future.done(), client.service_is_ready())
rclpy.spin_once(server, timeout_sec=P)
mark("served")
say(future.done())
rclpy.spin_once(asker, timeout_sec=P)
mark("answered")
say(future.done())
executor = SingleThreadedExecutor()
for node in (asker, server):
    executor.add_node(node)
future = client.call_async(Trigger.Request())
executor.spin_until_future_complete(future, timeout_sec=P)
mark("both")
say(future.done())
rclpy.shutdown()
