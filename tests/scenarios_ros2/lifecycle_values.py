"""What the return codes are, and what a state, a node and its entities can be asked."""

import rclpy
import rclpy.lifecycle
from rclpy.lifecycle import LifecycleNode, ManagedEntity, SimpleManagedEntity, State, TransitionCallbackReturn
from scenario import attempt

rclpy.init()
node = LifecycleNode("lifecycle_values")
names = {"node": node, "Return": TransitionCallbackReturn, "State": State, "LifecycleNode": LifecycleNode}
names |= {"lifecycle": rclpy.lifecycle, "ManagedEntity": ManagedEntity, "Simple": SimpleManagedEntity}
for text in (
    "Return.__module__, Return.__name__",
    "Return.SUCCESS, str(Return.FAILURE), Return.ERROR.value, Return.ERROR.name, int(Return.FAILURE)",
    "list(Return.__members__)",
    "Return(98)",
    "Return.SUCCESS == 97, Return.SUCCESS == Return.SUCCESS, Return.SUCCESS == Return.ERROR",
    "[code.to_label() for code in Return.__members__.values()]",
    "State(label='a', state_id=7), State('b', 8)[1]",
    "State('unknown')",
    "lifecycle.Node is lifecycle.LifecycleNode, lifecycle.State is lifecycle.LifecycleState",
    "lifecycle.Publisher is lifecycle.LifecyclePublisher, lifecycle.NodeMixin is lifecycle.LifecycleNodeMixin",
    "sorted(lifecycle.__all__)",
    "[kind.__module__ for kind in (LifecycleNode, State, lifecycle.LifecyclePublisher, ManagedEntity)]",
    "[kind.__mro__[1].__name__ for kind in (LifecycleNode, Simple, lifecycle.LifecyclePublisher)]",
    "[getattr(ManagedEntity(), f'on_{word}')(None) for word in ('configure', 'cleanup', 'shutdown', 'error')]",
    "Simple().is_activated",
    "[(service.srv_name, service.service_name) for service in node.services][-5:]",
    "[service.callback_group is node.default_callback_group for service in node.services][-5:]",
    "[publisher.topic for publisher in node.publishers]",
    "node.get_publisher_names_and_types_by_node('lifecycle_values', '/')",
    "[name for name, _ in node.get_service_names_and_types_by_node('lifecycle_values', '/') if 'param' not in name]",
    "node.count_publishers('/lifecycle_values/transition_event')",
    "node._service_get_state.srv_type.__name__",
    "node.add_managed_entity(3)",
    "node.add_managed_entity(ManagedEntity())",
    "node.create_lifecycle_publisher(None, 'x', 1, publisher_class=3)",
    "LifecycleNode('other', enable_communication_interface='yes')",
    "LifecycleNode('other', bogus=1)",
    "LifecycleNode(3)",
    "node._state_machine.get_transition_by_label('configure')",
    "node._state_machine.get_transition_by_label('activate')",
    "node._state_machine.available_transitions",
    "len(node._state_machine.transition_graph)",
):
    attempt(text, names)
rclpy.shutdown()
