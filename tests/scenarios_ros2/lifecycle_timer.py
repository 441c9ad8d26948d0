"""A managed talker: its timer is made when it is configured, and its publisher sends while it is active."""

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from scenario import say
from std_msgs.msg import UInt32

AFTER = {3: "activate", 6: "deactivate", 9: "activate", 12: "shutdown"}


class Talker(LifecycleNode):
    count = 0

    def on_configure(self, state):
        self.publisher = self.create_lifecycle_publisher(UInt32, "numbers", 10)
        self.timer = self.create_timer(0.05, self.publish)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        self.destroy_timer(self.timer)
        self.destroy_publisher(self.publisher)
        return TransitionCallbackReturn.SUCCESS

    def publish(self):
        self.count += 1
        say("tick", self.count, self.publisher.is_activated)
        self.publisher.publish(UInt32(data=self.count))
        if self.count in AFTER:
            say(AFTER[self.count], getattr(self, f"trigger_{AFTER[self.count]}")())


rclpy.init()
node = Talker("talker")
node.create_subscription(UInt32, "numbers", lambda message: say("heard", message.data), 10)
node.trigger_configure()
while not node.publisher.get_subscription_count():
    pass
while node._state_machine.current_state[1] != "finalized":
    rclpy.spin_once(node)
for _ in range(5):
    rclpy.spin_once(node, timeout_sec=0.1)
rclpy.shutdown()
