"""A hook that raises; hooks that are functions of objects that are gone."""

import rclpy
from scenario import attempt, say


class Owner:
    def hook(self):
        say("the owner's hook")


def raises():
    say("raising")
    raise ValueError("in a hook")


rclpy.init()
context = rclpy.get_default_context()
kept = Owner()
context.on_shutdown(Owner().hook)
context.on_shutdown(kept.hook)
context.on_shutdown(raises)
context.on_shutdown(lambda: say("last hook"))
attempt("context.on_shutdown(5)", {"context": context})
attempt("rclpy.shutdown()", {"rclpy": rclpy})
say("ok", rclpy.ok())
