"""Entities of one's own go with their node; the first that does not succeed ends the transition."""

import rclpy
from rclpy.lifecycle import LifecycleNode, ManagedEntity, SimpleManagedEntity, TransitionCallbackReturn
from scenario import attempt, say


class Motor(ManagedEntity):
    result = TransitionCallbackReturn.SUCCESS

    def on_configure(self, state):
        say("  motor: configure from", state.label)
        return self.result

    def on_activate(self, state):
        say("  motor: activate from", state.label)
        return self.result

    def on_error(self, state):
        say("  motor: error from", state.label)
        return TransitionCallbackReturn.SUCCESS


class Lamp(SimpleManagedEntity):
    @SimpleManagedEntity.when_enabled
    def shine(self, how):
        say("  shines", how)
        return "never returned"

    @SimpleManagedEntity.when_enabled(when_not_enabled=lambda: say("  is off"))
    def blink(self, *, times=1):
        say("  blinks", times)


rclpy.init()
motor, lamp = Motor(), Lamp()
for name, entity in (("first", motor), ("second", lamp)):
    node = LifecycleNode(name)
    node.add_managed_entity(entity)
    node.add_managed_entity(entity)
    for result in (
        TransitionCallbackReturn.FAILURE,
        TransitionCallbackReturn.ERROR,
        3,
        TransitionCallbackReturn.SUCCESS,
    ):
        Motor.result = result
        say(result)
        if node._state_machine.current_state[1] == "unconfigured":
            attempt("node.trigger_configure()", {"node": node})
    lamp.shine("before")
    lamp.blink()
    attempt("node.trigger_activate()", {"node": node})
    say(lamp.is_activated, lamp.shine("bright"), lamp.blink(times=2), lamp.shine.__name__)
    attempt("node.trigger_deactivate()", {"node": node})
    say(lamp.is_activated, lamp.shine("after"), lamp.blink(times=3))
    node.destroy_node()
rclpy.shutdown()
