"""Each step of a transition is published, also by a node without the services."""

import rclpy
from lifecycle_msgs.msg import TransitionEvent
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from scenario import say


class Failing(LifecycleNode):
    def on_activate(self, state):
        return TransitionCallbackReturn.ERROR


rclpy.init()
first = LifecycleNode("first")
second = Failing("second", enable_communication_interface=False)
other = rclpy.create_node("other")
heard = []
for name in ("first", "second"):
    topic = f"/{name}/transition_event"
    other.create_subscription(TransitionEvent, topic, lambda event, name=name: heard.append((name, event)), 100)
    while not other.count_publishers(topic):
        rclpy.spin_once(other, timeout_sec=0.05)
while not all(other.count_subscribers(f"/{name}/transition_event") for name in ("first", "second")):
    rclpy.spin_once(other, timeout_sec=0.05)
for node, words in ((first, ("configure", "activate", "deactivate")), (second, ("configure", "activate", "shutdown"))):
    for word in words:
        say(word, getattr(node, f"trigger_{word}")())
        for _ in range(6):
            rclpy.spin_once(other, timeout_sec=0.05)
        for name, event in heard:
            say(name, event.timestamp, event.transition.id, repr(event.transition.label))
            say("   ", event.start_state, event.goal_state)
        heard.clear()
say([name for name, _ in other.get_service_names_and_types_by_node("second", "/") if "param" not in name])
rclpy.shutdown()
