"""A module with something that changes: each process has its own."""

count = 0


def step(by):
    """Count on."""
    global count
    count += by
