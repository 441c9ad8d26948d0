"""Another node changes the state and asks for it, by the five services."""

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from scenario import say


class Careful(LifecycleNode):
    def on_cleanup(self, state):
        return TransitionCallbackReturn.FAILURE

    def on_deactivate(self, state):
        raise ValueError("stuck")


rclpy.init()
node = Careful("managed", namespace="/mrp")
other = rclpy.create_node("other")
executor = SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(other)
kinds = {
    "change_state": ChangeState,
    "get_state": GetState,
    "get_available_states": GetAvailableStates,
    "get_available_transitions": GetAvailableTransitions,
    "get_transition_graph": GetAvailableTransitions,
}
clients = {name: other.create_client(kind, f"/mrp/managed/{name}") for name, kind in kinds.items()}
say([client.wait_for_service(5.0) for client in clients.values()])


def ask(name, request=None):
    future = clients[name].call_async(request or kinds[name].Request())
    executor.spin_until_future_complete(future)
    return future.result()


def change(number, label=""):
    result = ask("change_state", ChangeState.Request(transition=Transition(id=number, label=label)))
    say("change", number, label, result.success, ask("get_state").current_state)


say(ask("get_state"))
say([(state.id, state.label) for state in ask("get_available_states").available_states])
change(Transition.TRANSITION_CONFIGURE)
for each in ask("get_available_transitions").available_transitions:
    say(each)
change(Transition.TRANSITION_CLEANUP)
change(0, "activate")
change(0, "bogus")
change(Transition.TRANSITION_CLEANUP, "deactivate")
for name in ("get_available_transitions", "get_transition_graph"):
    for each in ask(name).available_transitions:
        start, goal = each.start_state, each.goal_state
        say(name, each.transition.id, each.transition.label, start.id, start.label, goal.id, goal.label)
change(0, "shutdown")
say(ask("get_available_transitions"))
rclpy.shutdown()
