"""With disable_signals a KeyboardInterrupt ends Condition.wait: the condition's lock is held again in the handler."""

import threading

from scenario import attempt, begin, mark, say

condition = threading.Condition()
begin("ctrl_c_threads_no_signals_condition", disable_signals=True)
with condition:
    try:
        condition.wait()
    except KeyboardInterrupt:
        mark("caught")
        attempt("condition.notify_all()", {"condition": condition})
say("left")
