"""A node of a student: requests with a queue for the answer, one worker, a caller that gives up."""

import queue
import threading

from scenario import P, begin, block, mark, say

requests = queue.Queue()


def serve():
    while True:
        number, answer = requests.get()
        block(2)
        answer.put(number * number)


def ask(number, timeout):
    answer = queue.SimpleQueue()
    requests.put((number, answer))
    try:
        say(number, answer.get(timeout=timeout))
    except queue.Empty:
        say(number, "gives up")
    mark(f"answer{number}")


begin("threads_node_requests")
threading.Thread(target=serve, daemon=True).start()
askers = [threading.Thread(target=ask, args=(number, timeout * P)) for number, timeout in ((2, 3), (3, 2.75), (4, 9))]
for asker in askers:
    asker.start()
    block(0.4)
for asker in askers:
    asker.join()
mark("all")
