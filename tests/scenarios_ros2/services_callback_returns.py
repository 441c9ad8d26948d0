"""What a service's callback returns must be a response of its type; a new one will do; a coroutine is awaited."""

import rclpy
from scenario import attempt, say
from std_srvs.srv import SetBool, Trigger


async def coroutine(request, response):
    response.message = "from a coroutine"
    return response


answers = {
    "nothing": lambda request, response: None,
    "other": lambda request, response: Trigger.Response(),
    "request": lambda request, response: request,
    "klass": lambda request, response: SetBool.Response,
    "new": lambda request, response: SetBool.Response(message="a new one"),
    "coroutine": coroutine,
    "no_arguments": lambda: None,
    "one_argument": lambda request: request,
    "three": lambda request, response, third="default": SetBool.Response(message=third),
    "none": None,
}
rclpy.init()
node = rclpy.create_node("services_callback_returns")
for name, callback in answers.items():
    service = node.create_service(SetBool, name, callback)
    client = node.create_client(SetBool, name)
    future = client.call_async(SetBool.Request())
    say(name)
    attempt("spin_until_future_complete(node, future, None, 0.2)", {**vars(rclpy), "node": node, "future": future})
    say(future.done() and future.result())
    node.destroy_service(service)
rclpy.shutdown()
