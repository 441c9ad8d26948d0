"""What the compiler says of a node, as places in it; the first of these explained, where it is a common mistake.

A warning is shown if it is of a group in which each is of a fault.

``web/src/faults.js`` does the same in a page, with the same table.
"""

from __future__ import annotations

import re

__all__ = ["ADVICE", "LENGTHS", "NOTES", "OF_NO_PLACE", "WARNINGS", "advice", "first", "shown"]

ADVICE = (
    (
        r"could not match '(std::chrono::)?duration<.*>' against",
        "A period has a unit, as in 500ms, or std::chrono::duration<double>(0.5) for a number of seconds.",
    ),
    ("expected ';'", "A ; is missing: at the end of this line, or of the one before it."),
    (
        "'this' cannot be implicitly captured",
        "A lambda knows the object that it is made in only if you give it that: write [this] in place of [].",
    ),
    (
        "no known conversion from '(double|int)' to 'Duration'",
        "In ROS 1 a period is a duration: write ros::Duration(0.1) in place of 0.1.",
    ),
    (
        r"to object of type '.*__bind<.*\(\w+::\*\)\(.*\w+ \*>'",
        "The method takes other parameters than it is given: a timer of ROS 2 gives none, a subscription the message, "
        "in the place of std::placeholders::_1.",
    ),
    (
        r"is_convertible_v<void \(\w+::[\s\S]*requires at least 3 arguments, but 2 were"
        r"|'void \(\*\)\(P\)' against 'void \(\w+::|to object of type '.*__bind<",
        "A method is called on an object, which is missing here: write &SpinnerCppNode::timerCallback, this in ROS 1, "
        "and std::bind(&SpinnerCppNode::timerCallback, this) in ROS 2, with a placeholder for each argument.",
    ),
    (
        "no matching function for call to 'spin",
        "rclcpp::spin takes a shared pointer to the node, as std::make_shared<SpinnerCppNode>() gives.",
    ),
    (
        "no matching member function for call to 'publish'",
        "publish() takes a message: set the field of one, as in message.data = 5, and publish that.",
    ),
    (
        r"no matching (member )?function for call to '(create\w*|subscribe)'|to object of type '.*lambda"
        r"|a callback of a subscription takes|'detail::Adapter<.*' is not a class",
        "The callback does not fit what calls it: compare its parameters. A timer of ROS 1 calls it with a const "
        "ros::TimerEvent&, one of ROS 2 with nothing, and a subscription with the message, as a const reference to "
        "its type.",
    ),
    (
        "reference to non-static member function must be called",
        "A member function is called on an object. In place of its name alone, write [this] { timerCallback(); } in "
        "ROS 2, or &SpinnerCppNode::timerCallback, this in ROS 1.",
    ),
    (
        "literal operator for call to 'operator\"\"(h|min|s|ms|us|ns)'",
        "For 500ms, a line at the top is missing: using namespace std::chrono_literals;",
    ),
    (
        r"'\w+/(msg|srv)/\w+\.h(pp)?' file not found",
        "In ROS 2, the header of a message has its name in small letters, with _ between its words, and ends in .hpp: "
        "UInt32 is in std_msgs/msg/u_int32.hpp.",
    ),
    (
        r"undeclared identifier '\w+_(msgs|srvs)'|no (type|member) named '\w+' in namespace '\w+_(msgs|srvs)",
        "Each type of message has a header of its own: std_msgs/UInt32.h in ROS 1, std_msgs/msg/u_int32.hpp in ROS 2. "
        "Here it is not included, or the type is misspelt.",
    ),
    (
        r"invalid operands to binary expression \('const char",
        "Only macros with _STREAM in their names take <<. Is this one misspelt?",
    ),
    ("unterminated function-like macro", "A ) is missing: this macro has more ( than )."),
    ("expected '}'", "A } is missing: find the { that has none."),
    (
        r"(undeclared identifier '\w+'|no member named '\w+' in [^\n;]*)(\n|$)",
        "There is nothing of this name: compare its spelling, capitals too, with where it is declared.",
    ),
    (
        r"format specifies type|'%' conversions than data arguments|argument not used by format string",
        "A format has one value for each %, of its type: %d for an int, %f for a double, %zu for a size, and %s for a "
        "text of C, as c_str() of a std::string gives it. What does not fit is printed as garbage.",
    ),
    (
        "does not append to the string",
        "To add a number to a text, write std::to_string(number), or use << in a macro with _STREAM in its name.",
    ),
    (
        "non-void (function|lambda) does not return a value",
        "Each way through this function has to end in return and a value; without one, it gives garbage.",
    ),
    ("result of an assignment as a condition", "To compare, write ==; a single = assigns."),
    (
        "address of function '.*' will always evaluate to 'true'",
        "A function is called with parentheses, as in ros::ok(); its name alone is always true.",
    ),
    (
        "is (used )?uninitialized",
        "Give a variable its first value where you declare it, as in int counter = 0; otherwise it begins as garbage.",
    ),
)
"""What the compiler says of an error, or a warning, in a line of its own, and what it means, for JavaScript, too."""

WARNINGS = (
    *("array-bounds", "constant-conversion", "dangling-gsl", "division-by-zero", "empty-body", "exceptions", "format"),
    *("format-extra-args", "format-insufficient-args", "format-invalid-specifier", "infinite-recursion"),
    *("literal-conversion", "logical-not-parentheses", "null-dereference", "parentheses", "pointer-bool-conversion"),
    *("return-stack-address", "return-type", "self-assign", "sometimes-uninitialized", "string-compare"),
    *("string-plus-int", "uninitialized", "unused-comparison", "unused-value", "vexing-parse"),
)
"""The groups of clang's warnings that are shown."""

LENGTHS = (
    r"specifies type (?:'\w+' \(aka )?'(?:unsigned )?long(?: long)?'\)? but the argument has (?:underlying )?type "
    r"(?:'[^']*' \(aka )?'(?:unsigned )?long(?: long)?'"
    r"|specifies type '(?:unsigned )?int' but the argument has (?:underlying )?type "
    r"(?:'[^']*' \(aka )?'(?:bool|(?:(?:un)?signed )?char|(?:unsigned )?short)'"
)
"""A warning that is not shown: int64_t is a long on a computer, and a long long here. What is shorter than an int is
passed as one."""

OF_NO_PLACE = r"\S+: error: "
"""An error of no place in a text, as the linker has them."""

NOTES = "expanded from macro|to silence this warning"
"""A note that is not shown."""

_SAID = re.compile(r"(.*?):(\d+):(\d+): (?:fatal )?(error|warning|note): (.*?)(?: \[-W([\w+-]+)\])?")
_COUNT = re.compile(r"^\d+ warnings? (?:generated\.\n|and )", re.MULTILINE)
_LAMBDA = re.compile(r"\(lambda at (.*?):(\d+):(\d+)\)")


def first(said: str, file: str) -> tuple[int, int, str]:
    """Return the line, the column and the text of the first error in a file; line 0 if there is no place in it.

    An error in a header counts where the file is named with it.
    """
    text = ""
    for line in said.splitlines():
        if not (found := _SAID.fullmatch(line)):
            continue
        if found[4] == "error":
            text = text or found[5]
        place = found if found[1] == file else _LAMBDA.search(found[5])
        if text and place and place[1] == file:
            return int(place[2]), int(place[3]), text
    return 0, 0, text or said.strip().partition("\n")[0]


def advice(said: str) -> str:
    """Return what the first error means, if there is none the first warning; empty if that is none of the table's."""
    found = [match for line in said.splitlines() if (match := _SAID.fullmatch(line))]
    starts = [number for number, match in enumerate(found) if match[4] != "note"]
    begin = next((number for number in starts if found[number][4] == "error"), 0)
    end = next((number for number in starts if number > begin), None)
    first = "\n".join(match[5] for match in found[begin:end])  # with the notes on it
    return next((meaning for pattern, meaning in ADVICE if re.search(pattern, first)), "")


def shown(said: str) -> str:
    """Return what is shown of it: no warning that need not be of a fault, and no note that does not help."""
    lines = []
    whole = part = True  # whether what is said of a place is shown, and this part of it
    for line in _COUNT.sub("", said).splitlines(keepends=True):
        if match := _SAID.fullmatch(line.rstrip("\n")):
            if match[4] != "note":
                whole = match[4] == "error" or (match[6] in WARNINGS and not re.search(LENGTHS, match[5]))
            part = whole and not (match[4] == "note" and re.search(NOTES, match[5]))
        elif re.match(OF_NO_PLACE, line):
            whole = part = True
        if part:
            lines.append(line)
    return "".join(lines)
