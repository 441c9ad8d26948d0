import rosspin


@rosspin.explored(schedules=200, deep=True)
def test_no_part_is_lost(start_node):
    node = start_node("parts_py_node.py")
    node.advance(1.1)
    assert "parts = 20" in node.run.console
