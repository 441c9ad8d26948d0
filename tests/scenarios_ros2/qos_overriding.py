"""Parameters override the QoS of publishers and subscriptions, if these allow it."""

import rclpy
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.qos import LivelinessPolicy, QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import InvalidQosOverridesError, QosCallbackResult, QoSOverridingOptions
from scenario import say
from std_msgs.msg import UInt32

OVERRIDES = {
    "/chatter.publisher.depth": 3,
    "/chatter.publisher.reliability": "best_effort",
    "/chatter.publisher.lifespan": 5,
    "/chatter.subscription.history": "keep_all",
    "/ns/words.publisher_one.durability": "transient_local",
    "/ns/words.publisher_one.lifespan": 5_000_000_000,
    "/ns/words.publisher_one.liveliness": "manual_by_topic",
    "/ns/words.subscription.deadline": 7_000_000,
    "/ns/words.subscription.lifespan": 7_000_000,
    "/wrong.publisher.reliability": "perhaps",
    "/wrong.publisher.depth": "many",
}


def attempt(word, make):
    try:
        end = make()
    except Exception as error:
        say(word, type(error).__name__, error)
    else:
        say(word, getattr(end, "qos_profile", end))


def judge(qos):
    say("judged", qos)
    return QosCallbackResult(successful=qos.depth < 5, reason="too deep")


def publish(topic, qos, *args, **kwargs):
    return lambda: node.create_publisher(
        UInt32, topic, qos, qos_overriding_options=QoSOverridingOptions(*args, **kwargs)
    )


def subscribe(topic, qos, *args, **kwargs):
    return lambda: node.create_subscription(
        UInt32, topic, print, qos, qos_overriding_options=QoSOverridingOptions(*args, **kwargs)
    )


rclpy.init()
node = rclpy.create_node(
    "qos_overriding",
    parameter_overrides=[Parameter(f"qos_overrides.{name}", value=value) for name, value in OVERRIDES.items()],
)
default = QoSOverridingOptions.with_default_policies()
say(*[kind.name for kind in default.policy_kinds], default.callback, default.entity_id)
attempt("default", lambda: node.create_publisher(UInt32, "chatter", 10, qos_overriding_options=default))
attempt("again", lambda: node.create_publisher(UInt32, "/chatter", 10, qos_overriding_options=default))
attempt("judged", publish("chatter", 10, [QoSPolicyKind.DEPTH], callback=judge))
attempt("too deep", publish("deep", 10, [QoSPolicyKind.DEPTH], callback=judge))
attempt("subscription", lambda: node.create_subscription(UInt32, "chatter", print, 10, qos_overriding_options=default))
profile = QoSProfile(depth=4, deadline=Duration(seconds=1), liveliness=LivelinessPolicy.AUTOMATIC)
kinds = [kind for kind in QoSPolicyKind if kind is not QoSPolicyKind.INVALID]
attempt("all", publish("ns/words", profile, kinds, entity_id="one"))
attempt("all", subscribe("ns/words", profile, kinds))
attempt("none", publish("ns/none", profile, []))
attempt("wrong", publish("wrong", 10, [QoSPolicyKind.RELIABILITY]))
attempt("wrong type", publish("wrong", 10, [QoSPolicyKind.DEPTH]))
attempt("invalid", publish("invalid", 10, [QoSPolicyKind.INVALID]))
attempt("unknown", publish("unknown", QoSProfile(depth=1, reliability=3), [QoSPolicyKind.RELIABILITY]))
attempt("no options", lambda: node.create_publisher(UInt32, "other", 10, qos_overriding_options=5))
say(profile)
for name in sorted(node.list_parameters(["qos_overrides"], 0).names):
    say(name, repr(node.get_parameter(name).value), node.describe_parameter(name).description)
set_again = Parameter("qos_overrides./chatter.publisher.depth", value=5)
say(node.set_parameters([set_again])[0].reason, issubclass(InvalidQosOverridesError, ValueError))
rclpy.shutdown()
