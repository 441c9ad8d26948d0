"""A client for the parameters of another node."""

import os
import tempfile

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import (
    Parameter,
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from rclpy.parameter_client import AsyncParameterClient
from scenario import say

FILE = """/**:
  ros__parameters:
    everywhere: 1
target:
  ros__parameters:
    rate: 4.5
    deep:
      words: [a, b]
      active: true
other:
  nothing: 3
"""


def ask(future):
    executor.spin_until_future_complete(future, timeout_sec=2)
    say(future.result())


rclpy.init()
node = rclpy.create_node("parameter_client")
target = rclpy.create_node("target", allow_undeclared_parameters=True)
target.declare_parameter("rate", 10.0)
target.declare_parameter("deep.count", 3)
executor = SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(target)
client = AsyncParameterClient(node, "target")
say(client.wait_for_services(timeout_sec=2), client.services_are_ready())
ask(client.list_parameters(["deep"], 2))
ask(client.list_parameters(depth=1))
ask(client.get_parameters(["rate", "deep.count"]))
ask(client.get_parameter_types(["rate"]))
ask(client.describe_parameters(["rate"]))
ask(client.set_parameters([Parameter("rate", value=5.0), Parameter("new", value="x").to_parameter_msg()]))
ask(client.set_parameters_atomically([Parameter("rate", value="refused"), Parameter("new", value="y")]))
ask(client.delete_parameters(["new", "rate"], callback=lambda future: say("called")))
say(target.get_parameters(["rate", "new"]) and [target.get_parameter(name).value for name in ("rate", "new")])

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "params.yaml")
    with open(path, "w") as file:
        file.write(FILE)
    for options in [
        {"target_nodes": ["target"]},
        {"target_nodes": ["target"], "use_wildcard": True, "namespace": "a."},
    ]:
        found = parameter_dict_from_yaml_file(path, **options)
        say({name: parameter_value_to_python(parameter.value) for name, parameter in sorted(found.items())})
    for options in [{}, {"target_nodes": ["nobody"]}]:
        try:
            parameter_dict_from_yaml_file(path, **options)
        except RuntimeError as error:
            say(error)
    with open(path, "w") as file:
        file.write(FILE.partition("other:")[0])
    ask(client.load_parameter_file(path, use_wildcard=True))
    ask(client.load_parameter_file_atomically(path))
say(sorted(target.list_parameters([], 0).names))
for text in ["true", "3", "0.5", "word", "[1, 2]", "[1, a]", "[true, false]", "", "{a: 1", "null", "[a, b]", "[1.5]"]:
    say(repr(text), parameter_value_to_python(get_parameter_value(text)))
rclpy.shutdown()
