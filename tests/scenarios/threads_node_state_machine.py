"""A node of a student: threads wait for a state of their own; whoever has it moves to the next one."""

import threading

from scenario import begin, block, mark, say


class Machine:
    def __init__(self):
        self._changed = threading.Condition()
        self.state = "idle"
        self.history = []

    def go_from(self, old, new, periods):
        with self._changed:
            self._changed.wait_for(lambda: self.state == old)
        block(periods)
        with self._changed:
            self.history.append(f"{old}-{new}")
            mark(new)
            self.state = new
            self._changed.notify_all()


begin("threads_node_state_machine")
machine = Machine()
steps = [("turning", "stopped", 1), ("driving", "turning", 2), ("idle", "driving", 0.5)]
threads = [threading.Thread(target=machine.go_from, args=step) for step in steps]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
say(machine.state, machine.history)
