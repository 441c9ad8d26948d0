"""The way through all states, with what each callback is told and returns."""

import rclpy
from rclpy.lifecycle import LifecycleNode, LifecycleState, State, TransitionCallbackReturn
from scenario import attempt, say


class Talker(LifecycleNode):
    def on_configure(self, state):
        say("configure from", state, state.label, state.state_id, isinstance(state, LifecycleState))
        return super().on_configure(state)

    def on_activate(self, state):
        say("activate from", state)
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state):
        say("deactivate from", state)
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state):
        say("cleanup from", state)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        say("shutdown from", state)
        return TransitionCallbackReturn.SUCCESS


rclpy.init()
node = Talker("lifecycle_states")
machine = node._state_machine
say(State is LifecycleState, machine.initialized, machine.current_state, machine.available_states)
for word in ("configure", "activate", "deactivate", "cleanup", "configure", "activate", "shutdown"):
    say(getattr(node, f"trigger_{word}")(), machine.current_state)
for word in ("shutdown", "configure", "activate"):
    attempt(f"node.trigger_{word}()", {"node": node})
say(machine.current_state)
rclpy.shutdown()
