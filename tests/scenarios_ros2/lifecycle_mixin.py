"""The mixin together with a node class of one's own, with another group for the services, and a remapped event."""

import rclpy
from lifecycle_msgs.srv import GetState
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.lifecycle import LifecycleNodeMixin
from rclpy.node import Node
from scenario import say


class Base(Node):
    def __init__(self, name):
        super().__init__(
            name, cli_args=["--ros-args", "-r", "~/transition_event:=/events", "-r", "~/get_state:=/state"]
        )
        self.what = "base"


class Managed(LifecycleNodeMixin, Base):
    def __init__(self, name):
        Base.__init__(self, name)
        self.group = ReentrantCallbackGroup()
        LifecycleNodeMixin.__init__(self, callback_group=self.group)


rclpy.init()
node = Managed("lifecycle_mixin")
say(node.what, [service.service_name for service in node.services if service.callback_group is node.group])
say(node.get_publisher_names_and_types_by_node("lifecycle_mixin", "/"))
client = node.create_client(GetState, "/state")
executor = MultiThreadedExecutor(2)
executor.add_node(node)
say(client.wait_for_service(5.0), node.trigger_configure())
future = client.call_async(GetState.Request())
executor.spin_until_future_complete(future)
say(future.result())
rclpy.shutdown()
