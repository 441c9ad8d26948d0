// What a page makes of what the compiler says.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { advice, faults, shown } from "../src/faults.js"

const SAID = `a.cpp:38:8: error: no member named 'spinn' in namespace 'ros'; did you mean 'spin'?
   38 |   ros::spinn();
      |        ^~~~~
      |        spin
include/ros/ros.h:10:6: note: 'spin' declared here
a.cpp:40:3: fatal error: too many errors
include/ros/ros.h:11:6: error: in a header
2 errors generated.
`

test("the errors in a node have their places; those in headers have none", () => {
  assert.deepEqual(faults(SAID, "a.cpp"), [
    { line: 38, column: 8, text: "no member named 'spinn' in namespace 'ros'; did you mean 'spin'?" },
    { line: 40, column: 3, text: "too many errors" },
  ])
  assert.deepEqual(faults(SAID, "b.cpp"), [])
})

const IN_HEADERS = `include/rclcpp/entities.hpp:193:51: error: no matching function for call to object of type 'element_type' (aka '(lambda at a.cpp:19:35)')
include/rclcpp/entities.hpp:9:49: note: while substituting into a lambda expression here
a.cpp:18:9: note: in instantiation of what is requested here
include/ros/node_handle.h:332:50: error: 'detail::Adapter<int>::Message' (aka 'int') is not a class, namespace, or enumeration
a.cpp:27:35: note: in instantiation of function template specialization 'ros::NodeHandle::subscribe<int>' requested here
`

test("an error in a header has the place of what led there", () => {
  const places = faults(IN_HEADERS, "a.cpp").map(({ line, column }) => [line, column])
  assert.deepEqual(places, [[19, 35], [27, 35]])
  assert.match(advice(IN_HEADERS), /The callback does not fit/)
})

test("the first error alone is explained, if it is one of those that are made most", () => {
  assert.equal(advice(SAID), "")
  assert.match(advice("a.cpp:3:4: error: expected ';' after expression\n"), /A ; is missing/)
  assert.equal(advice(`${SAID}a.cpp:50:4: error: expected ';' after expression\n`), "")
  const captured = "a.cpp:9:40: error: 'this' cannot be implicitly captured in this context\n"
  assert.match(advice(captured), /write \[this\]/)
})

test("more mistakes are explained, unless the compiler says what was meant", () => {
  const cases = [
    ["reference to non-static member function must be called; did you mean to call it with no arguments?", /on an object/],
    [`no matching literal operator for call to 'operator""ms' with argument of type`, /chrono_literals/],
    ["'std_msgs/msg/UInt32.hpp' file not found", /small letters/],
    ["'std_msgs/msg/uint32.hpp' file not found", /small letters/],
    ["no matching function for call to 'spin'", /a shared pointer to the node/],
    ["no matching member function for call to 'publish'", /a message/],
    ["no matching function for call to object of type 'element_type' (aka 'std::__bind<void (Two::*)()>')", /std::bind/],
    ["use of undeclared identifier 'std_msgs'", /a header of its own/],
    ["no member named 'String' in namespace 'std_msgs::msg'", /a header of its own/],
    ["no type named 'String' in namespace 'std_msgs'; did you mean 'std::string'?", /a header of its own/],
    ["invalid operands to binary expression ('const char[40]' and 'const char *')", /_STREAM/],
    ["unterminated function-like macro invocation", /A \) is missing/],
    ["expected '}'", /A } is missing/],
    ["no member named 'creatTimer' in 'ros::NodeHandle'", /its spelling/],
    ["use of undeclared identifier 'counter_'", /its spelling/],
  ]
  for (const [said, meant] of cases) assert.match(advice(`a.cpp:3:4: error: ${said}\n    3 | text\n`), meant)
  assert.equal(advice("a.cpp:3:4: error: use of undeclared identifier 'creat_timer'; did you mean 'create_timer'?\n"), "")
})

test("of a call that fits no candidate, the notes say what it lacks", () => {
  const call = "a.cpp:2:60: error: no matching member function for call to 'createTimer'\n"
  const note = (text) => `ros/node_handle.h:169:3: note: ${text}\n`
  const unlike = note("candidate template ignored: requirement 'std::is_convertible_v<void (Two::*)(), F>' was not satisfied")
  const short = note("candidate function template not viable: requires at least 3 arguments, but 2 were provided")
  const double = note("candidate function not viable: no known conversion from 'double' to 'Duration' for 1st argument")
  assert.match(advice(call + unlike + short), /which is missing here/)
  assert.match(advice(call + unlike), /The callback does not fit/)
  assert.match(advice(call + double + unlike), /ros::Duration\(0\.1\)/)
})

const WARNED = `In file included from a.cpp:1:
own/b.hpp:3:5: warning: unused variable 'left' [-Wunused-variable]
    3 | int left;
own/b.hpp:1:1: note: a note on it
a.cpp:9:30: warning: format specifies type 'char *' but the argument has type 'int' [-Wformat]
    9 |   RCLCPP_INFO(get_logger(), "%s", counter);
/include/rclcpp/logging_macros.hpp:15:87: note: expanded from macro 'RCLCPP_INFO'
   15 | #define RCLCPP_INFO(logger, ...) ROSSPIN_LOG(true, RCUTILS_LOG_SEVERITY_INFO, logger, __VA_ARGS__)
a.cpp:10:30: warning: format specifies type 'long' but the argument has type 'int64_t' (aka 'long long') [-Wformat]
   10 |   RCLCPP_INFO(get_logger(), "%ld", time.nanoseconds());
`

test("warnings are shown of those groups that speak of faults, without a long of another size", () => {
  const said = shown(`${WARNED}3 warnings generated.\n`)
  assert.equal(said.split("\n").slice(1).join("\n"), WARNED.split("\n").slice(4, 6).join("\n") + "\n")
  assert.deepEqual(faults(said, "a.cpp"), [
    { line: 9, column: 30, text: "format specifies type 'char *' but the argument has type 'int'" },
  ])
  assert.match(advice(said), /%d for an int/)
})

test("an error of the linker is shown, whatever is not", () => {
  const hidden = "a.cpp:2:2: warning: unused variable 'text' [-Wunused-variable]\n    2 | text\n"
  const error = "wasm-ld: error: 0.o: undefined symbol: system\n"
  assert.equal(shown(hidden + error), error)
})

test("an error is explained before a warning", () => {
  const error = "a.cpp:12:4: error: expected ';' after expression\n"
  const said = shown(`${WARNED}${error}3 warnings and 1 error generated.\n`)
  assert.match(said, /\n1 error generated\.\n$/)
  assert.match(advice(said), /A ; is missing/)
  assert.deepEqual(faults(said, "a.cpp").map(({ line }) => line), [9, 12])
})
