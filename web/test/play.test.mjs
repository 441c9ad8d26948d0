// How something that plays keeps its time: see play.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import { Play } from "../src/play.js"

test("it plays when it is told to, and stands still when it is paused", () => {
  const play = new Play(12)
  assert.deepEqual([play.plays, play.at(100)], [false, 0])
  play.toggle(100)
  assert.deepEqual([play.plays, play.at(103)], [true, 3])
  play.toggle(104)
  assert.deepEqual([play.plays, play.at(200)], [false, 4])
  play.toggle(200)
  assert.equal(play.at(201), 5)
})

test("it pauses at its end, and begins again from there", () => {
  const play = new Play(12)
  play.toggle(0)
  assert.deepEqual([play.at(13), play.plays], [12, false])
  play.toggle(20)
  assert.equal(play.at(21), 1)
})

test("told to play at its end, before it was looked at, it begins again", () => {
  const play = new Play(12)
  play.toggle(0)
  play.toggle(50)
  assert.deepEqual([play.plays, play.at(51)], [true, 1])
})

test("stopped, it is back at its beginning", () => {
  const play = new Play(12)
  play.toggle(0)
  play.stop()
  assert.deepEqual([play.plays, play.at(5)], [false, 0])
})
