"""A node of a student: a button that bounces; only what stays pressed for a while counts."""

import threading

from scenario import P, begin, mark, until


class Button:
    def __init__(self):
        self._timer = None

    def press(self):
        if self._timer is not None:
            self._timer.cancel()
        self._timer = threading.Timer(1.2 * P, mark, ("pressed",))
        self._timer.start()


begin("threads_node_debounce")
button = Button()
for time in (0.5, 1.2, 1.9, 4, 6, 6.6):
    until(time)
    button.press()
