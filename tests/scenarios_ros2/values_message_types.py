"""What a message's class says of its fields, its constants and its own class."""

import rclpy
from action_msgs.msg import GoalStatus
from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseWithCovariance
from rcl_interfaces.msg import ParameterDescriptor, ParameterValue
from rosidl_parser import definition
from sensor_msgs.msg import JointState
from std_msgs.msg import Float32MultiArray, Header, String
from std_srvs.srv import SetBool

KINDS = (Time, Header, String, PoseWithCovariance, ParameterDescriptor, ParameterValue, Float32MultiArray, GoalStatus)


def describe(slot):
    found = [type(slot).__name__]
    for name in ("typename", "size", "maximum_size"):
        if hasattr(slot, name):
            found.append(getattr(slot, name))
    if isinstance(slot, definition.NamespacedType):
        found += [slot.namespaces, slot.name, slot.namespaced_name()]
    if isinstance(slot, definition.AbstractNestedType):
        found += [slot.has_maximum_size(), describe(slot.value_type)]
    return found


def attempt(what, call):
    try:
        print(what, call())
    except Exception as error:
        print(what, type(error).__name__, error)


def main():
    print(rclpy.get_rmw_implementation_identifier())
    for kind in (*KINDS, SetBool.Request, SetBool.Response):
        print(kind.__name__, type(kind).__name__, type(kind).__doc__, type(kind).__module__)
        print([name for name in dir(kind()) if not name.startswith("__")])
        print(kind._fields_and_field_types, kind.__slots__)
        for slot in kind.SLOT_TYPES:
            print("   ", describe(slot), type(slot).__module__)
    print(type(SetBool).__name__, type(SetBool).__doc__)
    fields = JointState.get_fields_and_field_types()
    fields.clear()
    print(len(JointState.get_fields_and_field_types()))
    floats, doubles = (definition.UnboundedSequence(definition.BasicType(name)) for name in ("float", "double"))
    print(floats == Float32MultiArray.SLOT_TYPES[1], floats != doubles)
    print(definition.BoundedString(3) == definition.BoundedString(4), definition.UnboundedWString().has_maximum_size())
    attempt("a constant", lambda: setattr(GoalStatus, "STATUS_ABORTED", 1))
    attempt("of an instance", lambda: setattr(GoalStatus(), "STATUS_ABORTED", 1))
    attempt("is still", lambda: (GoalStatus.STATUS_ABORTED, GoalStatus().STATUS_ABORTED))
    attempt("another name", lambda: setattr(String, "mine", 1))
    attempt("of two", lambda: type("Both", (String, Header), {}))
    attempt("my own", lambda: type("Mine", (String,), {})(data="x"))


if __name__ == "__main__":
    main()
