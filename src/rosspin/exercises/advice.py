"""Explain errors to people who are learning rospy or rclpy."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Mapping
from difflib import get_close_matches
from types import FrameType, ModuleType, TracebackType

from ..clocks.frames import node_frames
from ..rospy.exceptions import ROSInitException

__all__ = ["advice", "lacking", "not_called", "not_found"]

# What each module of rospy passes to its callbacks, and what it should be given.
_PASSED = {
    "timer": "A timer passes its callback one argument, the event: def callback(event), or (self, event) in a class.",
    "topics": "A subscriber passes its callback one argument: def callback(message), or (self, message) in a class.",
    "service": "A service passes its handler one argument: def handle(request), or (self, request) in a class.",
}
_PASSED_2 = {
    "Timer": "A timer passes its callback no argument: def timer_callback(), or (self) in a class. Is it the one that "
    "should be called?",
    "Subscription": "A subscription passes its callback the message: def callback(message), or (self, message) in a "
    "class.",
    "Service": "A service passes its callback two arguments: def callback(request, response), or (self, request, "
    "response) in a class. It returns the response.",
}
_ITSELF = {
    "timer": "Pass a timer the callback itself, without calling it: self.timerCallback, not self.timerCallback().",
    "topics": "Pass a subscriber the callback itself, without calling it: self.callback, not self.callback().",
    "service": "Pass a service the handler itself, without calling it: self.handle, not self.handle().",
}


def advice(error: BaseException) -> str:
    """Advise on an error in a node, in a sentence; an empty text stands for no advice."""
    if isinstance(error, TypeError) and "'Parameter'" in str(error):
        return (
            "A parameter is not yet its number, which is its `.value`: `self.declare_parameter(name, default).value`."
        )
    if said := _form(error) or _on_messages(error):
        return said
    frame = _innermost(error)
    if frame is None:
        return ""
    module = str(frame.f_globals["__name__"])
    said = _on_rclpy(error, module, frame) if ".rclpy." in module else _on_rospy(error, module)
    return said or _form_within(error)


def lacking(error: ModuleNotFoundError) -> str:
    """Say why there is no such module in a page, whose Python has no packages, in a sentence."""
    if (error.name or "").partition(".")[0] in sys.stdlib_module_names:
        return f"Python has no {error.name} in a page."
    return f"This page has stand-ins for rospy and rclpy, and Python's standard library, but no {error.name}."


_NOT_FOUND = (
    "Python names what it did not find. Is it spelt as where you defined it, with its `self.`, and is it there before "
    "this line runs?"
)


def not_found(error: BaseException, text: str) -> str:
    """Say where to look for what Python did not find in an answer, a text; empty for other errors."""
    if isinstance(error, ModuleNotFoundError):
        if sys.platform == "emscripten":
            return f"{lacking(error)} No exercise needs it."
        return "Is the module spelt right? No exercise needs others than ROS's and Python's own."
    if isinstance(error, ImportError):
        return _home(error) or f"Is the name spelt right, and is it in that module? `{error.name}` is there."
    if isinstance(error, NameError):
        if error.name in _CONSTANTS:
            return f"In Python this is written `{_CONSTANTS[error.name]}`."
        if error.name in sys.stdlib_module_names:
            return f"Import it at the top: `import {error.name}`."
        if re.fullmatch("[A-Z]", error.name or ""):
            return f'A letter is a text. Write it in quotes: `"{error.name}"`.'
        if re.match(r"[A-Z]\w*[a-z]", error.name or ""):
            if home := _module_of(error.name or "", _modules("rclpy") if "import rclpy" in text else {}):
                return f"Import it at the top: `from {home} import {error.name}`."
            return "A class is imported from its module, or defined, before it is used. Is it spelt as it is there?"
        if error.name and re.search(
            rf"create_(publisher|subscription|client|service)\([^)]*,\s*{error.name}\s*,", text
        ):
            return f'A name of ROS is a text. Write it in quotes: `"{error.name}"`.'
        if error.name in _OF_NODES:
            return f"In a method of the class it is `self.{error.name}`."
        if error.name and re.search(rf"\bself\.{re.escape(error.name)}\b|\bdef {re.escape(error.name)}\(self\b", text):
            return f"In a method of the class it is `self.{error.name}`."
        return _local(error.name or "", text) or _NOT_FOUND
    if isinstance(error, AttributeError):
        if error.name and re.search(rf"^def {re.escape(error.name)}\(self\b", text, re.MULTILINE):
            return f"`{error.name}` is defined outside of the class. Indent it, and it is a method."
        # What could not be set is told in words alone.
        found = re.match(r"'(\w+)' object has no attribute '(\w*[A-Z]\w*)'$", str(error))
        if found and error.obj is None:
            return f"A `{found[1]}` has no field `{found[2]}`. Fields are written in small letters, as `data` is."
        if str(error).startswith("'property' object"):
            return "This belongs to a class. Make an object of it, with `()`, as in `Twist()`."
        if isinstance(error.obj, type) and hasattr(error.obj, "get_fields_and_field_types"):
            return f"This is the class. Make an object of it, with `()`: `{error.obj.__name__}()`."
        return _local(error.name or "", text) or _lacks(error) or _meant(error) or _NOT_FOUND
    if isinstance(error, ZeroDivisionError):
        return "This line divides by 0. In Python `1 // 10` and `int(0.5)` are 0, and False counts as 0, too."
    return ""


def _local(name: str, text: str) -> str:
    """Say where a name is known that one function of an answer, a text, assigns; empty for other names."""
    if not name or not re.search(rf"(?<![.\w]){re.escape(name)} = ", text):
        return ""
    return f"`{name}` is a variable of one function. Others find it if it is kept as `self.{name}`."


def _modules(package: str) -> Mapping[str, ModuleType]:
    """Return the modules of a stand-in that an answer has imported, by their names on a real ROS."""
    return getattr(sys.modules.get(f"rosspin.{package}"), "MODULES", {})


def _module_of(name: str, modules: Mapping[str, ModuleType]) -> str:
    """Return which of these modules has a class of this name; empty if none does."""
    return next(
        (each for each, module in modules.items() if getattr(vars(module).get(name), "__module__", "") == each), ""
    )


def _home(error: ImportError) -> str:
    """Say from where of ROS a name is imported that another module lacks, or which it has instead; else empty."""
    found = re.match(r"cannot import name '(\w+)' from '([\w.]+)'", str(error))
    if not found:
        return ""
    modules = _modules(found[2].partition(".")[0])
    if home := _module_of(found[1], modules):
        return f"It is in another module: `from {home} import {found[1]}`."
    near = get_close_matches(found[1], vars(modules[found[2]]) if found[2] in modules else (), 1, 0.8)
    return f"`{found[2]}` has {_a(near[0])}. Is it that?" if near else ""


def _a(name: str) -> str:
    """Write a name with its article."""
    return f"{'an' if name[0].lower() in 'aeiou' else 'a'} `{name}`"


def _lacks(error: AttributeError) -> str:
    """Say what an object of ROS has instead; empty for an object of the answer's own."""
    if found := re.match(r"module '([\w.]+)' has no attribute", str(error)):
        module = found[1]
        if module == "rclpy" and error.name in _IN_ROS_2:
            return f"`{error.name}` is one of rospy. In ROS 2 it is {_IN_ROS_2[error.name]}."
        if f"rosspin.{module}.{error.name}" in sys.modules:
            return f"Import it at the top: `import {module}.{error.name}`."
        return f"`{module}` has no `{error.name}`. Is it spelt as in the lesson?" if _is_of_ros(module) else ""
    kind = type(error.obj)
    if "object has no attribute" not in str(error) or error.obj is None:
        return ""
    if kind.__name__ in ("function", "method") and error.name in _MAKERS:
        return f"`{_MAKERS[error.name]}` returns what has `{error.name}`. Keep that in a variable, with its `self.`."
    if kind.__name__ in ("function", "method"):
        return f"This is a function, which should be called first, with `()`: what it returns has `{error.name}`."
    if hasattr(kind, "get_fields_and_field_types"):
        fields = ", ".join(f"`{name}`" for name in kind.get_fields_and_field_types())
        return f"A `{kind.__name__}` has no field `{error.name}`. It has {fields}."
    if kind.__name__ == "TimerEvent":
        return "It has `current_expected`, `current_real`, `last_expected`, `last_real` and `last_duration`."
    if not _is_of_ros(kind.__module__):
        return ""
    own = {name: value for name, value in vars(kind).items() if name[:1] != "_"}
    has = [f"`{name}`" for name, value in own.items() if isinstance(value, property)]
    has += [f"`{name}()`" for name, value in own.items() if inspect.isfunction(value)]
    return f"A `{kind.__name__}` has no `{error.name}`. It has {', '.join(has[:8])}." if has else ""


def _meant(error: AttributeError) -> str:
    """Return what an object has that is spelt almost like an attribute that it lacks; empty if there is nothing."""
    if error.obj is None or not error.name:
        return ""
    names = {name.lower().replace("_", ""): name for name in dir(error.obj) if name[:1] != "_"}
    if error.name == "publish":
        return "A publisher publishes: `self.publisher.publish(...)`, if that is where you keep it."
    near = get_close_matches(error.name.lower().replace("_", ""), names, 1, 0.85)
    if near and names[near[0]] != f"{error.name}s":
        return f"There is {_a(names[near[0]])}. Is it that?"
    if error.name in _OF_NODES:
        return f"A `Node` has `{error.name}`. Is the class one of these, `class {type(error.obj).__name__}(Node)`?"
    return ""


def not_called(error: BaseException, text: str, line: int) -> str:
    """Advise on what was called in a ``line`` of the answer, and should not have been; empty for other errors."""
    if found := re.match(r"'(Publisher|Client|Timer|RcutilsLogger|Rate)' object is not callable", str(error)):
        return f"It is no function. Call what it has, such as `{_METHODS[found[1]]}`."
    if "'QoSProfile' object is not callable" in str(error):
        return "It is a profile already: give it as it is, without `()`."
    lines = text.splitlines()
    found = re.match(r"(?:\w+\.)*(\w+)\(\) missing \d+ required positional argument", str(error))
    if not (isinstance(error, TypeError) and found and 0 < line <= len(lines)):
        return ""
    called = re.search(rf"((?:\w+\.)*{found[1]})\(\)", lines[line - 1]) if f"def {found[1]}(" in text else None
    return f"Pass the function on without calling it: `{called[1]}`, not `{called[1]}()`." if called else ""


# What a class has that is one of Node.
_OF_NODES = {
    *("create_timer", "create_rate", "create_publisher", "create_subscription", "create_client", "create_service"),
    *("declare_parameter", "get_parameter", "get_logger", "get_clock"),
}

# What nodes take from rospy, and what there is in ROS 2.
_IN_ROS_2 = {
    "init_node": "`rclpy.init()`, and a `Node` with that name",
    "Timer": "`self.create_timer`",
    "Rate": "`self.create_rate`",
    "Publisher": "`self.create_publisher`",
    "Subscriber": "`self.create_subscription`",
    "get_param": "`self.declare_parameter(name, default).value`",
    "is_shutdown": "`not rclpy.ok()`",
    "sleep": "`time.sleep`",
    **dict.fromkeys(("logdebug", "loginfo"), "`self.get_logger().info`"),
    **dict.fromkeys(("logwarn", "logerr"), "`self.get_logger().error`"),
}

# Names of other languages.
_CONSTANTS = {"true": "True", "false": "False", "null": "None", "nil": "None"}

# How what makes something is called, for whoever gives it the wrong arguments.
_FORMS = {
    "create_timer": "`self.create_timer(0.5, self.timer_callback)`: the period in seconds, then the callback.",
    "create_publisher": '`self.create_publisher(UInt32, "topic", 10)`: the type, the topic, how many may wait.',
    "create_subscription": '`self.create_subscription(UInt32, "topic", self.callback, 10)`: the type, the topic, the '
    "callback, how many may wait.",
    "create_client": '`self.create_client(Trigger, "name")`: the type, then the name of the service.',
    "create_service": '`self.create_service(Trigger, "name", self.callback)`: the type, the name, the callback.',
    "spin": "`rclpy.spin(node)`: the node whose callbacks should be called.",
    "declare_parameter": "`self.declare_parameter(name, default).value`: the name, then the default.",
    "get_parameter": "`self.get_parameter(name).value`, after the parameter was declared.",
    "Duration": "`Duration(seconds=0.5)`, or `Duration(nanoseconds=500_000_000)`.",
    "Publisher": '`rospy.Publisher("topic", UInt32, queue_size=10)`: the topic, then the type.',
    "Subscriber": '`rospy.Subscriber("topic", UInt32, self.callback)`: the topic, the type, the callback.',
    "Timer": "`rospy.Timer(rospy.Duration(0.5), self.callback)`: the period, a Duration, then the callback.",
}


_LACKING = {
    (
        "create_timer",
        "oneshot",
    ): "In ROS 2 a timer has no `oneshot`. Keep it in `self.timer`, and cancel it when it has "
    "called back: `self.timer.cancel()`.",
    ("Subscriber", "latch"): "It is the publisher that latches: `rospy.Publisher` has a parameter `latch`.",
}


def _form(error: BaseException) -> str:
    """Return how to call what was given too few arguments, or some that it does not have."""
    message = r"(?:Node\.)?(\w+)(?:\.__init__)?\(\) (?:missing|got an unexpected keyword argument '(\w+)'|takes)"
    found = re.match(message, str(error))
    if isinstance(error, TypeError) and re.match(r"Executor\.\w+\(\) missing", str(error)):
        return "An executor is made with `()`, as in `MultiThreadedExecutor()`."
    if not isinstance(error, TypeError) or not found:
        return ""
    if "group" in (found[2] or ""):
        return "That argument is called `callback_group`."
    return _LACKING.get((found[1], found[2])) or _FORMS.get(found[1], "")


def _form_within(error: BaseException) -> str:
    """Return how to call what refused its arguments itself."""
    trace = error.__traceback__
    while trace and isinstance(error, (TypeError, ValueError)):
        code, names = trace.tb_frame.f_code, trace.tb_frame.f_locals
        if _is_of_ros(str(trace.tb_frame.f_globals.get("__name__", ""))):
            name = type(names.get("self")).__name__ if code.co_name == "__init__" else code.co_name
            if name in _FORMS:
                return _FORMS[name]
        trace = trace.tb_next
    return ""


def _on_messages(error: BaseException) -> str:
    """Advise on a message that was not made, or not filled, as it should be."""
    said = str(error)
    if isinstance(error, TypeError) and said.startswith("Expected <class") and ".msg." in said:
        if "Metaclass_" in said:
            return "This is the class of the messages: make one, with `()`, and fill it."
        return "A number is not yet a message: give `publish` one that holds it, as in `UInt32(data=5)`."
    if isinstance(error, TypeError) and "__init__() takes 1 positional argument" in said:
        return "The fields of a message are given by their names, as in `UInt32(data=5)`."
    if isinstance(error, AssertionError) and said.startswith("The 'result' field must be"):
        return "The callback that executes a goal has to return a result: `return Fibonacci.Result(sequence=numbers)`."
    if isinstance(error, TypeError) and re.search("not supported between instances of .*'Duration'", said):
        if said.count("'Duration'") > 1:
            return "There are two classes of that name. Times need the other: `from rclpy.duration import Duration`."
        return "A difference of two times is a `Duration`, and is compared with one: 0.5 s is `Duration(seconds=0.5)`."
    if isinstance(error, TypeError) and re.search("unsupported .* -: .*'Time'", said) and _names_rclpy(error):
        return "Both have to be times, from the beginning: `self.get_clock().now()`, with its `()`."
    if isinstance(error, AssertionError) and said.startswith("Invalid arguments passed to constructor"):
        if said.endswith("seconds"):
            return "This is a message. What times are compared with is another: `from rclpy.duration import Duration`."
        return "The fields of a message are given by their own names, as in `UInt32(data=5)`."
    if (isinstance(error, AssertionError) and "field must be" in said) or "SerializationE" in type(error).__name__:
        if found := re.search("must be of type '(float|int|str)'", said):
            return f"A field takes values of its own type only: {_OF_TYPE[found[1]]}."
        return "A field of a message takes values of its own type only. One for whole numbers takes no text."
    return ""


# What makes the object that has a method.
_MAKERS = {"cancel": "create_timer", "reset": "create_timer", "publish": "create_publisher"}

_OF_TYPE = {
    "float": "this one a number with a point, `2.0` and not `2`",
    "int": "this one a whole number, `5` and neither `5.0` nor a text",
    "str": 'this one a text, `"5"` or `str(5)`',
}
_METHODS = {"Publisher": "publish", "Client": "call_async", "Timer": "cancel", "RcutilsLogger": "info", "Rate": "sleep"}


def _is_of_ros(module: str) -> bool:
    """Whether a module, by its name, is one of ROS."""
    return module.removeprefix("rosspin.").partition(".")[0] in ("rospy", "rclpy", "genpy")


def _on_rospy(error: BaseException, module: str) -> str:
    if isinstance(error, ROSInitException) and "init_node()" in str(error):
        return 'Call rospy.init_node("a_name") before you use anything else from rospy.'
    if isinstance(error, ZeroDivisionError):
        return "Nothing can have a frequency of 0 Hz or a period of 0 s: give rospy.Rate and rospy.Timer more than 0."
    if isinstance(error, AttributeError) and error.name == "to_sec":
        return "The period of a rospy.Timer is a Duration: rospy.Timer(rospy.Duration(0.5), callback)"
    if isinstance(error, TypeError) and "positional argument" in str(error):
        return _PASSED.get(module.rpartition(".")[2], "")
    if isinstance(error, TypeError) and "not callable" in str(error):
        return _ITSELF.get(module.rpartition(".")[2], "")
    return ""


def _on_rclpy(error: BaseException, module: str, frame: FrameType) -> str:
    from ..rclpy.exceptions import (  # where an error comes from rclpy, it is there
        InvalidParameterTypeException,
        NotInitializedException,
        ParameterNotDeclaredException,
        RCLError,
    )

    if isinstance(error, NotInitializedException) or (isinstance(error, RCLError) and "rcl_init()" in str(error)):
        return "Call rclpy.init() before you make a node, and rclpy.shutdown() only at the end."
    if isinstance(error, AttributeError) and (error.name or "").startswith("_") and "'_rosspin" not in str(error):
        return 'A class of Node begins its __init__ with super().__init__("a_name").'
    if isinstance(error, ZeroDivisionError):
        return "Nothing can have a frequency of 0 Hz."
    if isinstance(error, ParameterNotDeclaredException):
        name = str(error).rpartition(": ")[2]
        return f'Declare a parameter before you read it: self.declare_parameter("{name}", ...), with its default.'
    if isinstance(error, InvalidParameterTypeException):
        return "A parameter keeps the type with which it was declared. 5 is an integer, 5.0 is not."
    if isinstance(error, RCLError) and "timer period" in str(error):
        return "The period of a timer cannot be negative: give create_timer the seconds from one call to the next."
    if isinstance(error, TypeError) and "float()" in str(error) and frame.f_code.co_name == "create_timer":
        return "The period of a timer comes first and is a number of seconds: create_timer(0.5, self.timer_callback)"
    if "add_entity" in str(error):
        if "missing" in str(error):
            return "A callback group is made with `()`: `MutuallyExclusiveCallbackGroup()`."
        if "'str'" in str(error):
            return "A callback group is an object: `callback_group=MutuallyExclusiveCallbackGroup()`."
        return "A callback group comes after the callback. Has a number a comma in it? `0,1` is two numbers: write 0.1."
    if isinstance(error, TypeError) and module.endswith(".executors"):
        if "not callable" in str(error):
            return "Pass the callback itself, without calling it: self.timer_callback, not self.timer_callback()."
        if re.search(r"\w\.\w+\(\) takes 0 positional arguments", str(error)):
            return "Its first parameter is the node, since it is a method: def timer_callback(self)."
        if "positional argument" in str(error):
            return _PASSED_2.get(type(frame.f_locals.get("entity")).__name__, "")
    if isinstance(error, RuntimeError) and "callback should be either" in str(error):
        return _PASSED_2["Subscription"]
    if isinstance(error, RCLError) and "invalid allocator" in str(error):
        return "The node uses this topic with another type already. Both ends of a topic have to name the same type."
    if "Expected QoSProfile or int, but received <class 'str'>" in str(error):
        return "A profile is an object: write its name without quotation marks, and import it from rclpy.qos."
    if "History and/or depth settings are required" in str(error):
        return "A QoSProfile needs a depth, too: QoSProfile(depth=10, ...)."
    if isinstance(error, TypeError) and not str(error):
        return "A service's callback returns the response, an action's its result: `return response`."
    return ""


def _last(error: BaseException) -> TracebackType | None:
    """Return where in its traceback an error was raised."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace


def _names_rclpy(error: BaseException) -> bool:
    """Whether an error was raised in code that has imported rclpy."""
    trace = _last(error)
    return bool(trace and "rclpy" in trace.tb_frame.f_globals)


def _innermost(error: BaseException) -> FrameType | None:
    """Return the frame in which an error was raised, if that was in a stand-in and not in a line of the node."""
    trace = _last(error)
    return trace.tb_frame if trace and node_frames(trace) is None else None
