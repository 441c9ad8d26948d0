// The steps of a C++ node: see called.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import { called } from "../src/called.js"
import { scene } from "../src/scenes.js"

const said = (...given) => called(...given).steps.map(([time, words]) => `${time}: ${words}`)

test("each call begins and ends, and the time between is passed", () => {
  assert.deepEqual(said([["lambda", 1, 0.5, 0.5, 0]], 1, 0), [
    "0: No callback runs until 0.5 s.",
    "0.5: main calls lambda.",
    "0.5: lambda ends.",
    "0.5: No callback runs until 1 s.",
    "1: The node has ended, with status 0.",
  ])
})

const LATE = [
  ["slow", 1, 1, 1, 0.7],
  ["quick", 1, 1.2, 1.7, 0],
  ["slow", 2, 2, 2, -1],
]

test("what is due while another runs waits, and is late", () => {
  assert.deepEqual(said(LATE, 2.5, 0).slice(1, 8), [
    "1: main calls slow.",
    "1: slow is at work until 1.2 s.",
    "1.2: quick is due, and waits: slow is at work.",
    "1.2: slow is at work until 1.7 s.",
    "1.7: slow ends.",
    "1.7: main calls quick, 0.5 s late.",
    "1.7: quick ends.",
  ])
  const scenes = called(LATE, 2.5, 0)
  assert.equal(scene(scenes, 3).alternative, "Step 4 of 12, at 1.2 s; main, runs slow; quick due since 1.2 s.")
})

test("a callback that has not ended runs to the end", () => {
  assert.deepEqual(said(LATE, 2.5, 137).slice(-3), [
    "2: main calls slow.",
    "2: slow is at work until 2.5 s.",
    "2.5: The node has ended, with status 137.",
  ])
})

test("a loop calls nothing", () => {
  assert.equal(called([["Rate", 1, 0, 0, 0.1], ["WallRate 2", 1, 0, 0, 0.1]], 1, 0), null)
  assert.equal(called([], 1, 0), null)
})

test("of very many calls the first are shown, and of a node with very many callbacks none", () => {
  const many = Array.from({ length: 1000 }, (_, number) => ["tick", number, number, number, 0])
  const { steps } = called(many, 1000, 0)
  assert.equal(steps.length, 301)
  assert.deepEqual(steps[300].slice(0, 2), [steps[299][0], "The rest is not shown."])
  assert.equal(called(many.map(([, ...rest]) => [`tick ${rest[0]}`, ...rest]).slice(0, 31), 1000, 0), null)
})
