"""Services in a run: what is recorded of calls; services of nodes that end, or that have one name."""

from __future__ import annotations

import math
import os
import threading
import warnings
from collections.abc import Callable
from typing import Any

import pytest

from rosspin import NotSimulated, rospy, simulate
from rosspin.exercises.advice import advice
from rosspin.results.ticks import Call
from rosspin.rospy.service import FIND
from rosspin.world.world import current_world

FOUND = FIND / 1e9


def server(handle: Callable[[Any], Any], name: str = "server") -> Callable[[], None]:
    """A node with a service ``ask``."""

    def node() -> None:
        from std_srvs.srv import SetBool  # type: ignore[import-not-found]

        rospy.init_node(name)
        rospy.Service("ask", SetBool, handle)
        rospy.spin()

    return node


def client(*data: bool, late: float = 0.0, **options: Any) -> Callable[[], None]:
    """A node that calls it and prints what comes of that."""

    def node() -> None:
        from std_srvs.srv import SetBool

        rospy.init_node("client")
        rospy.sleep(late)
        proxy = rospy.ServiceProxy("ask", SetBool, **options)
        for each in data:
            try:
                print(proxy(each).message)
            except (rospy.ServiceException, rospy.ROSInterruptException) as error:
                print(type(error).__name__, error)

    return node


def takes(seconds: float) -> Callable[[Any], Any]:
    def handle(request: Any) -> Any:
        rospy.sleep(seconds)
        return request.data, f"after {seconds} s"

    return handle


def said(console: str) -> list[str]:
    """The lines of nodes, without roslaunch's."""
    return [line for line in console.splitlines() if not line.startswith("[")]


# --- what a run tells of its calls ------------------------------------------------------------------------------------


def test_a_run_tells_who_asked_whom_and_when() -> None:
    run = simulate([server(takes(0.5)), client(True, False, late=1.0)], 5.0)
    assert [call._replace(request=call.request.data, response=call.response.success) for call in run.calls] == [
        Call("/ask", "/client", 1.0 + FOUND, True, "/server", 1.5 + FOUND, True),
        Call("/ask", "/client", 1.5 + 2 * FOUND, False, "/server", 2.0 + 2 * FOUND, False),
    ]


def test_a_persistent_proxy_looks_for_its_service_once() -> None:
    run = simulate([server(takes(0.5)), client(True, True, late=1.0, persistent=True)], 5.0)
    assert [call.asked for call in run.calls] == [1.0 + FOUND, 1.5 + FOUND]


def test_what_is_recorded_is_a_copy() -> None:
    def node() -> None:
        from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse

        rospy.init_node("n")
        response = SetBoolResponse(True, "then")
        rospy.Service("a", SetBool, lambda request: response)
        request = SetBoolRequest(True)
        rospy.ServiceProxy("a", SetBool)(request)
        request.data, response.message = False, "now"

    (call,) = simulate(node, 1).calls
    assert (call.request.data, call.response.message) == (True, "then")


def test_an_error_is_an_answer_without_a_response() -> None:
    (call,) = simulate([server(lambda request: None), client(True, late=1.0)], 3.0).calls
    assert (call.server, call.answered, call.response) == ("/server", 1.0 + FOUND, None)


def test_a_call_without_an_answer_is_recorded_as_such() -> None:
    (call,) = simulate([server(takes(10)), client(True, late=1.0)], 3.0).calls
    assert (call.server, call.response) == ("", None)
    assert math.isnan(call.answered)


def test_a_call_of_nobody_is_none() -> None:
    assert simulate(client(True), 1).calls == ()


# --- services of several nodes ----------------------------------------------------------------------------------------


def test_nodes_call_each_other_at_once() -> None:
    def ask(request: Any) -> Any:
        from std_srvs.srv import Trigger

        return request.data, rospy.ServiceProxy("name", Trigger)().message

    def asker() -> None:
        from std_srvs.srv import Trigger

        rospy.Service("name", Trigger, lambda request: (True, rospy.get_name()))
        client(True, late=1.0)()

    assert said(simulate([server(ask), asker], 3.0).console) == ["/client"]


def dies(request: Any) -> None:
    os._exit(3)


def test_a_node_that_dies_leaves_its_name_with_the_master() -> None:
    def waits() -> None:
        rospy.init_node("waits")
        rospy.sleep(2)
        rospy.wait_for_service("ask", 0.5)

    run = simulate([server(dies), client(True, True, late=1.0), waits], 5.0)
    lines = [line for line in run.console.splitlines() if "ServiceException" in line or "wait" in line]
    assert lines[:2] == [
        "ServiceException transport error completing service call: "
        "unable to receive data from sender, check sender's logs for details",
        "ServiceException unable to connect to service: [Errno 111] Connection refused",
    ]
    assert "[WARN] [2.003000]: wait_for_service(/ask): failed to contact, will keep trying" in lines
    assert "timeout exceeded while waiting for service /ask" in run.console


def test_a_service_that_starts_again_is_found() -> None:
    def waits() -> None:
        rospy.sleep(1.5)
        rospy.wait_for_service("ask")
        print("found at", rospy.get_time())

    def late() -> None:
        rospy.init_node("late")
        rospy.sleep(2)
        server(takes(0), "late")()

    def node() -> None:
        rospy.init_node("waits")
        waits()

    console = simulate([server(dies), client(True, late=1.0), late, node], 5.0).console
    assert "found at 2.109" in console  # it looks at 1.503, 1.806 and 2.109


def test_a_caller_that_shuts_down_learns_that_the_service_has_died() -> None:
    def handle(request: Any) -> None:
        rospy.sleep(1)
        os._exit(3)

    def caller() -> None:
        threading.Timer(1.5, rospy.signal_shutdown, ["enough"]).start()
        client(True, late=1.0)()

    lines = said(simulate([server(handle), caller], 5.0).console)
    assert lines[0] == "ROSInterruptException node shutdown interrupted service call"


def test_of_two_nodes_the_later_one_answers() -> None:
    def named(request: Any) -> Any:
        return True, rospy.get_name()

    def later() -> None:
        rospy.init_node("second")
        rospy.sleep(0.5)
        server(named, "second")()

    assert said(simulate([server(named, "first"), later, client(True, late=1.0)], 3.0).console) == ["/second"]


# --- the rest ---------------------------------------------------------------------------------------------------------


def test_what_is_not_simulated_ends_the_run_in_a_handler() -> None:
    with pytest.raises(NotSimulated, match="MasterProxy"):
        simulate([server(lambda request: rospy.MasterProxy()), client(True, late=1.0)], 3.0)


def test_a_deadlock_says_where_it_waits(write: Any) -> None:
    path = write(
        """
        import threading
        import rospy
        from std_srvs.srv import Trigger

        lock = threading.Lock()

        def handle(request):
            with lock:
                return True, ""

        rospy.init_node("n")
        rospy.Service("a", Trigger, handle)
        ask = rospy.ServiceProxy("a", Trigger)
        with lock:
            ask()
        """
    )
    run = simulate(path, 1.0)
    assert run.status == 137
    assert f"MainThread was at {path}:16: ask()" in run.console
    assert f"(handle) was at {path}:9: with lock" in run.console


def test_a_name_that_is_not_legal_is_warned_of_and_refused_by_the_master() -> None:
    def node() -> None:
        from std_srvs.srv import Trigger

        rospy.init_node("n")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            rospy.Service("a b", Trigger, print)
        print(*[f"{each.message} in {os.path.basename(each.filename)}" for each in caught])

    expected = "'a b' is not a legal ROS graph resource name. This may cause problems with other ROS tools"
    refused = "unable to register service [/a b] with master: ERROR: parameter [service] contains illegal chars"
    assert simulate(node, 1).console.splitlines() == [
        f"[FATAL] [0.000000]: {refused}",
        f"{expected} in {os.path.basename(__file__)}",
    ]


@pytest.mark.parametrize(
    ("handler", "text"),
    [
        (lambda: None, "A service passes its handler one argument"),
        ("no function", "Pass a service the handler itself"),
    ],
)
def test_advice_on_a_handler(handler: Any, text: str) -> None:
    errors: list[BaseException] = []

    def node() -> None:
        from std_srvs.srv import Empty

        rospy.init_node("n")
        rospy.Service("a", Empty, handler)
        try:
            rospy.ServiceProxy("a", Empty)()
        except rospy.ServiceException:
            pass
        errors.extend(current_world().errors)

    simulate(node, 1)
    (error,) = errors
    assert advice(error).startswith(text)
