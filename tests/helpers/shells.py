"""IPython's shell without a kernel."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest import mock

from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config


@contextmanager
def ipython_shell(folder: Path) -> Iterator[Any]:
    """A shell with rosspin's magics, which writes into a folder only."""
    config = Config()
    config.HistoryManager.enabled = False
    config.InteractiveShell.colors = "nocolor"
    main = sys.modules["__main__"]
    with mock.patch.dict(os.environ, IPYTHONDIR=str(folder)):
        shell = InteractiveShell(config=config)
        try:
            shell.run_cell("%load_ext rosspin")
            yield shell
        finally:
            shell.restore_sys_module_state()
            sys.modules["__main__"] = main  # the shell puts its own there
