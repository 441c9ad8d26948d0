// The file of answers as the page writes it; that Python reads it is in tests/hand_ins.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { isTooLong, write } from "../src/answers.js"

test("a file says who, when and what", () => {
  const { date, ...found } = JSON.parse(write("Ada <Lovelace>/2", "a1", { "ten-hertz": "%%answer ten-hertz\nä" }))
  assert.ok(Math.abs(new Date(date) - new Date()) < 60_000 * 60)
  const answers = { "ten-hertz": "%%answer ten-hertz\nä" }
  assert.deepEqual(found, { format: "rosspin-answers", version: 2, name: "Ada <Lovelace>/2", id: "a1", answers })
  assert.equal(JSON.parse(write("Ada", "a1", {}, "s 1")).student, "s 1")
})

test("an answer is as long as Python counts it", () => {
  assert.deepEqual(["x".repeat(50_001), "x".repeat(50_000), "🤖".repeat(30_000), "🤖".repeat(50_001)].map(isTooLong), [true, false, false, true])
})
