"""With disable_signals Ctrl-C ends the main with a traceback; Python still waits for the other threads."""

import threading

from scenario import begin, block, mark


def work():
    block(7)
    mark("work")


begin("ctrl_c_threads_no_signals_outlive", disable_signals=True)
threading.Thread(target=work).start()
block(20)
mark("never")
