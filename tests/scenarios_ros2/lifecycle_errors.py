"""Callbacks that fail, that raise, and that return what is no code; and what on_error then decides."""

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from scenario import attempt, say

SUCCESS, FAILURE, ERROR = TransitionCallbackReturn.__members__.values()


def refuse(state):
    raise ValueError("no")


def node_of(number, on_error=None, **callbacks):
    """Make a node with these results: a code is returned, a function called."""

    def method(name, result):
        def call(self, state):
            say(f"  on_{name} from {state.label}")
            return result(state) if callable(result) else result

        return call

    found = callbacks if on_error is None else {**callbacks, "error": on_error}
    methods = {f"on_{name}": method(name, result) for name, result in found.items()}
    return type("Failing", (LifecycleNode,), methods)(f"failing{number}")


rclpy.init()
for number, callbacks in enumerate(
    (
        {"configure": FAILURE},
        {"configure": ERROR},
        {"configure": refuse},
        {"configure": refuse, "on_error": SUCCESS},
        {"configure": ERROR, "on_error": FAILURE},
        {"configure": ERROR, "on_error": ERROR},
        {"configure": ERROR, "on_error": refuse},
        {"activate": FAILURE},
        {"activate": ERROR, "on_error": SUCCESS},
        {"shutdown": FAILURE},
        {"shutdown": ERROR, "on_error": SUCCESS},
        {"configure": lambda state: None},
        {"configure": 97},
        {"configure": ERROR, "on_error": lambda state: None},
    )
):
    node = node_of(number, **callbacks)
    say(number, sorted(callbacks))
    for word in ("configure", "activate", "shutdown"):
        attempt(f"node.trigger_{word}()", {"node": node})
        say("  now", node._state_machine.current_state)
    node.destroy_node()
rclpy.shutdown()
