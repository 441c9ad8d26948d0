// What a page makes of what the compiler says.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { advice, faults } from "../src/faults.js"

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
