# The notebook is judged as a file: each answer in a process of its own.
import json
import subprocess
import sys

command = [sys.executable, "-m", "rosspin", "judge", "answers.ipynb", "--json"]
done = subprocess.run(command, capture_output=True, text=True)
(student,) = json.loads(done.stdout)["students"]
answer = student["answers"]["slow-timer"]
assert answer["solved"], answer["said"]
