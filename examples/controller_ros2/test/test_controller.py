import pytest


def test_it_sends_50_commands_a_second(start_node):
    node = start_node("../controller/controller_py_node.py")
    for _ in range(10):
        node.publish("/range", range=2.0)
        node.advance(0.1)
    commands = node.messages("/cmd_vel")
    assert len(commands) == 50
    assert {command.message.linear.x for command in commands} == {0.5}


def test_it_stops_when_the_sensor_is_silent(start_node):
    node = start_node("../controller/controller_py_node.py")
    node.publish("/range", range=2.0)
    run = node.advance(1.0)
    driving = [sent.time for sent in run.messages if sent.message.linear.x > 0.0]
    assert max(driving) == pytest.approx(0.18)
