"""What an ending leaves behind: nothing that another thread would wait for."""

from __future__ import annotations

import _imp
import importlib
import sys
import threading

import pytest

from rosspin.clocks.ending import Ended, ending_here


class _EndsWhoImports:
    """An entry of ``sys.meta_path``: whoever asks for the module should end, from the line on that comes next."""

    find_spec = staticmethod(lambda name, path, target=None: name == "there_is_none" and Ended() and None)


def test_the_import_system_lets_go_of_its_locks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "meta_path", [_EndsWhoImports, *sys.meta_path])
    with pytest.raises(Ended), ending_here():
        importlib.import_module("there_is_none")
    assert not _imp.lock_held()
    monkeypatch.undo()
    found: list[str] = []

    def find() -> None:
        try:
            importlib.import_module("there_is_none")
        except ModuleNotFoundError as error:
            found.append(str(error))

    another = threading.Thread(target=find, daemon=True)
    another.start()
    another.join(60)
    assert found == ["No module named 'there_is_none'"]
