"""What a node knows of the ends of a topic."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.qos import QoSDurabilityPolicy, QoSLivelinessPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum  # noqa: F401
from rclpy.type_hash import TypeHash  # noqa: F401
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("node", namespace="/ns")
other = rclpy.create_node("other")


def attempt(text):
    try:
        value = eval(text)
    except BaseException as error:
        value = type(error).__name__, str(error)
    print(text, "->", value)


def show(infos):
    for info in infos:
        lines = str(info).splitlines()
        print("\n".join(line for line in lines if not line.startswith("GID")), len(info.endpoint_gid))
    print(len({tuple(info.endpoint_gid) for info in infos}))


attempt("node.get_publishers_info_by_topic('chatter')")
node.create_publisher(String, "chatter", 10)
other.create_publisher(
    String,
    "/ns/chatter",
    QoSProfile(
        depth=3,
        reliability=QoSReliabilityPolicy.BEST_EFFORT,
        durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
        deadline=Duration(seconds=2),
        lifespan=Duration(seconds=3),
        liveliness=QoSLivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=4),
    ),
)
other.create_subscription(String, "/ns/chatter", print, 5)
other.create_publisher(LaserScan, "scan", 1)
time.sleep(1)
show(sorted(node.get_publishers_info_by_topic("chatter"), key=lambda info: info.node_name))
show(other.get_subscriptions_info_by_topic("/ns/chatter"))
attempt("other.get_subscriptions_info_by_topic('chatter')")
attempt("str(node.get_publishers_info_by_topic('/scan')[0].topic_type_hash)")
attempt("other.get_subscriptions_info_by_topic('rt/ns/chatter', no_mangle=True)[0].topic_type")
attempt("other.get_subscriptions_info_by_topic('not a topic')")
attempt("other.get_publishers_info_by_topic('1')")
attempt("TopicEndpointInfo(name='x')")
attempt("TopicEndpointInfo(node_name=1)")
attempt("TopicEndpointInfo(endpoint_type=2).endpoint_type")
attempt("TopicEndpointInfo(endpoint_type=7).endpoint_type")
attempt("TopicEndpointInfo() == TopicEndpointInfo(), TopicEndpointInfo() == 1")
attempt("TopicEndpointInfo(topic_type_hash={'version': 1, 'value': bytes(32)}).topic_type_hash == TypeHash(1)")
attempt("str(TypeHash()), str(TypeHash(1, bytes(range(32)))), str(TypeHash(1, b'1'))")
attempt("TypeHash(value='x')")
attempt("str(TopicEndpointInfo())")
attempt("TopicEndpointTypeEnum.PUBLISHER")
other.destroy_node()
attempt("other.get_publishers_info_by_topic('chatter')")
