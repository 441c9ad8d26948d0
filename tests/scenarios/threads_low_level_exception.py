"""An exception in a thread without a Thread: a traceback of its own kind; SystemExit ends it in silence."""

import _thread
import sys

from scenario import begin, block, mark


class Failing:
    def __repr__(self):
        return "a failing function"

    def __call__(self, error):
        block(1)
        mark("fails")
        raise error


begin("threads_low_level_exception")
_thread.start_new_thread(Failing(), (RuntimeError("nobody sees to it"),))
block(2)
_thread.start_new_thread(Failing(), (SystemExit(3),))
block(2)
sys.unraisablehook = lambda args: print("hook", args.exc_type.__name__, args.exc_value, args.object)
_thread.start_new_thread(Failing(), (ValueError("seen by a hook"),))
block(2)
mark("goes_on")
