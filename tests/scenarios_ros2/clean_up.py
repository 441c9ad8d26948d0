"""What a node and its parts say after destroy_node() and after shutdown, and when they are destroyed twice."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci


def attempt(what, call):
    try:
        print(what, "->", str(call())[:60])
    except Exception as error:
        print(what, "->", type(error).__name__, str(error).partition(", at /")[0])


def all_of(node, shut):
    attempt("name", node.get_name)
    attempt("ns", node.get_namespace)
    attempt("fqn", node.get_fully_qualified_name)
    attempt("names", node.get_node_names)
    attempt("namesns", node.get_node_names_and_namespaces)
    attempt("fq names", node.get_fully_qualified_node_names)
    attempt("topics", lambda: len(node.get_topic_names_and_types()) > 0)
    attempt("services", lambda: len(node.get_service_names_and_types()) > 0)
    attempt("pubs by", lambda: node.get_publisher_names_and_types_by_node("n", "/"))
    attempt("subs by", lambda: node.get_subscriber_names_and_types_by_node("n", "/"))
    attempt("srvs by", lambda: node.get_service_names_and_types_by_node("n", "/"))
    attempt("clis by", lambda: node.get_client_names_and_types_by_node("n", "/"))
    for kind in "publishers", "subscribers", "clients", "services":
        attempt("count " + kind, lambda: getattr(node, "count_" + kind)("a"))
    attempt("wait_for_node", lambda: node.wait_for_node("x", 0.05))
    attempt("declare", lambda: node.declare_parameter(f"p{shut}", 1).value)
    attempt("has", lambda: node.has_parameter("p"))
    attempt("get", lambda: node.get_parameter("p").value)
    attempt("set", lambda: node.set_parameters([Parameter("p", value=2)]))
    attempt("set atom", lambda: node.set_parameters_atomically([Parameter("p", value=2)]))
    attempt("get", lambda: node.get_parameter("p").value)
    attempt("undeclare", lambda: node.undeclare_parameter("p"))
    attempt("resolve", lambda: node.resolve_topic_name("a"))
    attempt("resolve", lambda: node.resolve_service_name("a"))
    attempt("sub", lambda: node.create_subscription(String, "b", lambda m: None, 1))
    attempt("pub", lambda: node.create_publisher(String, "b", 1))
    attempt("client", lambda: node.create_client(Trigger, "b"))
    attempt("service", lambda: node.create_service(Trigger, "b", lambda a, b: b))
    attempt("timer", lambda: node.create_timer(1.0, lambda: None) is not None)
    attempt("rate", lambda: node.create_rate(1.0) is not None)
    attempt("guard", lambda: node.create_guard_condition(lambda: None) is not None)
    attempt("destroy", node.destroy_node)
    attempt("destroy", node.destroy_node)
    attempt("logger", lambda: node.get_logger().info("x"))
    attempt("clock", lambda: node.get_clock().now() is not None)
    attempt("executor", lambda: node.executor)


def ends(e):
    for n in e:
        o = e[n]
        for m in ("topic_name", "service_name", "logger_name", "handle"):
            if hasattr(type(o), m):
                attempt(n + " " + m, lambda: getattr(o, m) if m != "handle" else o.handle.__enter__())
        attempt(n + " destroy", lambda: o.destroy())
        attempt(n + " destroy", lambda: o.destroy())


def make(name):
    node = Node(name)
    node.declare_parameter("p", 1)
    e = dict(
        pub=node.create_publisher(String, "a", 1),
        sub=node.create_subscription(String, "a", lambda m: None, 1),
        cli=node.create_client(Trigger, "t"),
        srv=node.create_service(Trigger, "t", lambda a, b: b),
        tim=node.create_timer(1.0, lambda: None),
        guard=node.create_guard_condition(lambda: None),
        rate=node.create_rate(1.0),
    )
    return node, e


for shut in (0, 1):
    print(["destroyed", "shut down"][shut])
    rclpy.init()
    node, e = make(f"n{shut}")
    if shut == 0:
        node.destroy_node()
    else:
        rclpy.shutdown()
    if shut:
        attempt("cli ready", e["cli"].service_is_ready)
        attempt("cli call", lambda: e["cli"].call_async(Trigger.Request()).done())
        attempt("pubcount", e["pub"].get_subscription_count)
        attempt("liv", e["pub"].assert_liveliness)
        attempt("ack", e["pub"].wait_for_all_acked)
        attempt("subcount", e["sub"].get_publisher_count)
        attempt("trig", e["guard"].trigger)
        attempt("timer", e["tim"].is_ready)
    else:
        for n, f in dict(
            ready=e["cli"].service_is_ready,
            call=lambda: e["cli"].call_async(Trigger.Request()).done(),
            pub=lambda: e["pub"].publish(String()),
            cnt=e["pub"].get_subscription_count,
            scnt=e["sub"].get_publisher_count,
            trig=e["guard"].trigger,
            tr=e["tim"].is_ready,
            c=e["tim"].cancel,
            per=lambda: e["tim"].timer_period_ns,
            wait=lambda: e["cli"].wait_for_service(0.1),
        ).items():
            attempt(n, f)
    all_of(node, shut)
    ends(e)
    for k in ("publisher", "subscription", "client", "service", "timer", "guard_condition", "rate"):
        attempt(
            "destroy_" + k,
            lambda: getattr(node, "destroy_" + k)(
                e[
                    {
                        "publisher": "pub",
                        "subscription": "sub",
                        "client": "cli",
                        "service": "srv",
                        "timer": "tim",
                        "guard_condition": "guard",
                        "rate": "rate",
                    }[k]
                ]
            ),
        )
    if shut == 0:
        rclpy.shutdown()
rclpy.shutdown()
print("--- kept")
rclpy.init()
node, e = make("kept")
ends(e)
for k in ("publisher", "subscription", "client", "service", "timer", "guard_condition", "rate"):
    attempt(
        "destroy_" + k,
        lambda: getattr(node, "destroy_" + k)(
            e[
                {
                    "publisher": "pub",
                    "subscription": "sub",
                    "client": "cli",
                    "service": "srv",
                    "timer": "tim",
                    "guard_condition": "guard",
                    "rate": "rate",
                }[k]
            ]
        ),
    )
s = ActionServer(node, Fibonacci, "fib", lambda h: None)
c = ActionClient(node, Fibonacci, "fib")
for x in (s, c):
    attempt("action destroy", x.destroy)
    attempt("action destroy", x.destroy)
attempt("ready", c.server_is_ready)
attempt("send", lambda: c.send_goal_async(Fibonacci.Goal()))
s = ActionServer(node, Fibonacci, "fib", lambda h: None)
c = ActionClient(node, Fibonacci, "fib")
node.destroy_node()
for x in (c, s):
    attempt("action destroy", x.destroy)
    attempt("action destroy", x.destroy)
rclpy.shutdown()
