#!/usr/bin/env python3

from concurrent.futures import ProcessPoolExecutor

from rosspin import explore


def counts_all(run):
    assert "parts = 20" in run.console, "a part is lost"


if __name__ == "__main__":
    with ProcessPoolExecutor() as executor:
        print(explore("parts_py_node.py", 1.1, counts_all, deep=True, executor=executor))
