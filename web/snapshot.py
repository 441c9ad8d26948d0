"""Run in the page's Python before its memory is kept: imports what a node may import, and leaves no traces."""

import gc
import importlib
import os
import sys
from pkgutil import iter_modules

from rosspin import messages
from rosspin.messages.library import Library

# rosspin imports these when it needs them.
LATER = ["yaml", "rosspin.page", "rosspin.rclpy", "rosspin.run.scenes"]

# So do nodes, and this saves them the wait for the standard library.
NODES = ["datetime", "statistics"]

for name in [*LATER, *NODES]:
    importlib.import_module(name)
    gc.collect()  # what an import leaves is room for the next: the memory must not grow
for name in [found.name for found in iter_modules(messages.__path__) if found.name.startswith("ros")]:
    importlib.import_module(f"rosspin.messages.{name}")
for ros in (1, 2):
    Library(ros).names("std_msgs")  # reads all definitions

del os.environ["PYTHONHASHSEED"]
sys.path.remove("")  # the start from a snapshot puts one there, too
for name in [name for name in globals() if not name.startswith("__") and name not in ("gc", "name")]:
    del globals()[name]
gc.collect()
del gc, name
