// What a stepper shows of a step: see scenes.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import { sayRing, scene, wrapped } from "../src/scenes.js"

const scenes = {
  threads: ["MainThread", "Thread-1"],
  groups: ["Default group: one at a time", "Own group 1: one at a time"],
  callbacks: [["slow", 0], ["quick", 0], ["late", 1]],
  steps: [
    [0, "No callback runs until 0.5 s.", [], [[0, -1, 9]], ["due at 0.5 s", "due at 0.5 s"]],
    [0.5, "MainThread calls slow.", [1], [[0, 0, 4], [1, -1, 0]], ["runs", "waits for the thread, which is in slow"]],
  ],
  rings: [],
}

test("each callback stands in its group, a running one in its thread, and the ready ones in their order", () => {
  const { time, said, ready, threads, groups } = scene(scenes, 1)
  assert.deepEqual([time, said], ["0.5 s", "MainThread calls slow."])
  assert.deepEqual(ready.map(({ name }) => name), ["quick"])
  assert.deepEqual(threads.map(({ name, callback, line }) => [name, callback?.name, line]), [
    ["MainThread", "slow", 4],
    ["Thread-1", undefined, 0],
  ])
  assert.deepEqual(groups.map(({ name, callbacks }) => [name, callbacks.map(({ how }) => how)]), [
    ["Default group: one at a time", ["runs", "waits for the thread, which is in slow"]],
  ])
})

test("a group whose callbacks are not there yet is not shown", () => assert.equal(scene(scenes, 0).groups.length, 1))

test("what is seen is said: who is ready, what runs where, what waits and why", () => {
  assert.equal(
    scene(scenes, 1).alternative,
    "Step 2 of 2, at 0.5 s; ready: quick; MainThread, runs slow, line 4; Thread-1, runs no callback; " +
      "quick waits for the thread, which is in slow.",
  )
  assert.match(scene(scenes, 0).alternative, /^Step 1 of 2, at 0 s; nothing is ready; .*slow due at 0.5 s/)
})

test("a ring is said to come back, and a way to end", () => {
  const links = [["a", "waits for b"], ["b", "waits for a"]]
  assert.equal(sayRing({ links, to: 0 }), "A ring of waits. a waits for b. b waits for a. So it comes back to a.")
  assert.equal(sayRing({ links: [["a", "waits"]], to: -1 }), "A way of waits that ends. a waits.")
})

test("a text is broken between words, and no word is cut", () => {
  assert.deepEqual(wrapped("one two three", 7), ["one two", "three"])
  assert.deepEqual(wrapped("extraordinary word", 5), ["extraordinary", "word"])
  assert.deepEqual(wrapped("", 5), [""])
})
