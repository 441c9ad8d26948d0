"""Messages with numpy's arrays. What is expected is what the real rospy 1.15.15 gave with numpy 1.24.2."""

from __future__ import annotations

import io
import sys
from textwrap import dedent
from typing import Any

import pytest

from rosspin import simulate
from rosspin.messages import MessageFinder
from rosspin.rospy.numpy_msg import numpy_msg


def trip(kind: Any, message: Any) -> Any:
    """Send a message, and receive it with another class."""
    buffer = io.BytesIO()
    message.serialize(buffer)
    return kind().deserialize(buffer.getvalue())


def said(text: str) -> list[str]:
    """Run a node that has these lines, with ``say``, which prints what a function returns or raises."""
    start = """
        import numpy, rospy
        from rospy.numpy_msg import numpy_msg
        from sensor_msgs.msg import ChannelFloat32, Imu, PointCloud
        from std_msgs.msg import Float32MultiArray, UInt8MultiArray
        def say(function):
            try:
                print(function())
            except Exception as error:
                print(f"{type(error).__name__}: {error}")
        Floats, Bytes = numpy_msg(Float32MultiArray), numpy_msg(UInt8MultiArray)
    """

    def node() -> None:
        exec(dedent(start) + dedent(text), {"trip": trip})

    return simulate(node, 3.0).console.splitlines()


def test_the_class_is_one_of_its_own_for_the_same_topics() -> None:
    assert said("""
        print(Floats, Floats is numpy_msg(Float32MultiArray), issubclass(Floats, Float32MultiArray))
        print(Floats._type, Floats._md5sum == Float32MultiArray._md5sum, Floats().data)
    """) == [
        "<class 'rospy.numpy_msg.Numpy_std_msgs__Float32MultiArray'> True True",
        "std_msgs/Float32MultiArray True []",
    ]


def test_arrays_of_numbers_are_numpy_s_wherever_they_are() -> None:
    assert said("""
        data = trip(Floats, Float32MultiArray(data=[1.5, 2.5])).data
        print(repr(data), data.flags.writeable)
        print(trip(Floats, Float32MultiArray(data=[1.5, 2.5])))
        print(trip(Bytes, UInt8MultiArray(data=[1, 2])).data)
        cloud = trip(numpy_msg(PointCloud), PointCloud(channels=[ChannelFloat32("a", [1, 2])]))
        print(type(cloud.channels[0]) is ChannelFloat32, repr(cloud.channels[0].values))
        print(trip(PointCloud, cloud).channels[0].values)
        imu = trip(numpy_msg(Imu), Imu(orientation_covariance=[float(x) for x in range(9)]))
        print(repr(imu.orientation_covariance))
        say(lambda: trip(Floats, Float32MultiArray(data=[1, 2])) == trip(Floats, Float32MultiArray(data=[1, 2])))
    """) == [
        "array([1.5, 2.5], dtype=float32) False",
        *("layout: ", "  dim: []", "  data_offset: 0", "data: [1.5 2.5]"),
        r"b'\x01\x02'",
        "True array([1., 2.], dtype=float32)",
        "(1.0, 2.0)",
        "array([0., 1., 2., 3., 4., 5., 6., 7., 8.])",
        "ValueError: The truth value of an array with more than one element is ambiguous. Use a.any() or a.all()",
    ]


def test_what_is_sent_is_the_array_s_own_bytes() -> None:
    assert said("""
        def sends(data, kind=Floats, receives=Float32MultiArray):
            say(lambda: trip(receives, kind(data=data)).data)
        sends(numpy.array([1, 2], dtype=numpy.float32))
        sends(numpy.array([1, 2], dtype=numpy.float64))
        sends([1.0, 2.0])
        sends(None)
        sends(numpy.array([1, 2], dtype=numpy.uint8), Bytes, UInt8MultiArray)
    """) == [
        "(1.0, 2.0)",
        "(0.0, 1.875)",
        *["AttributeError: 'list' object has no attribute 'tobytes'"] * 2,
        "SerializationError: field data must be a list or tuple type",
    ]


def test_topics_take_them() -> None:
    assert said("""
        rospy.init_node("arrays")
        rospy.Subscriber("x", Floats, lambda message: print(type(message).__name__, repr(message.data)))
        rospy.Subscriber("x", Float32MultiArray, lambda message: print(message.data))
        publisher = rospy.Publisher("x", Floats, queue_size=3)
        rospy.sleep(0.5)
        publisher.publish(data=numpy.array([3.0], dtype=numpy.float32))
        rospy.sleep(0.5)
    """) == ["Numpy_std_msgs__Float32MultiArray array([3.], dtype=float32)", "[3.]"]


def test_without_numpy_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numpy", None)
    with pytest.raises(ModuleNotFoundError, match="numpy"):
        numpy_msg(MessageFinder(1).messages["std_msgs/Float32MultiArray"])
