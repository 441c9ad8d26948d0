// What a page draws of a log, from what Python found in it.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { HEIGHT, WIDTH, chosen, describe, dots, driftOf, nameOf, part, rateOf, rowsIn, say } from "../src/series.js"

const times = Array.from({ length: 100 }, (_, n) => n / 10).filter((time) => time < 5 || time > 5.45)
const TIMER = {
  name: "base: odometry: #", part: 0, count: 95, period: 0.1, chosen: 0.1, drift: 0, usual: 0, lost: 5,
  times, late: times.map(() => 0), missing: [5, 5.1, 5.2, 5.3, 5.4],
}
const EVENTS = { ...TIMER, name: "bumped", period: 0, late: [], missing: [], lost: 0, times: [1, 1.5, 9] }

for (const [seconds, text] of [[0.1, "0.1 s"], [0.0182, "18.2 ms"], [-0.000434, "−0.434 ms"], [0.00002, "20 µs"], [0, "0 s"]]) {
  test(`a time in words: ${text}`, () => assert.equal(say(seconds), text))
}

test("a series in words", () => {
  assert.equal(nameOf({ ...TIMER, part: 2 }), "base: odometry: # (2)")
  assert.equal(nameOf({ ...TIMER, part: 2 }, 6), "base:… (2)")
  assert.equal(rateOf(TIMER), "10 Hz")
  assert.equal(rateOf(EVENTS), "irregular")
  assert.equal(driftOf(TIMER), "none")
  assert.equal(driftOf({ ...TIMER, drift: 0.0607 }), "+6.07% on 0.1 s")
  assert.equal(driftOf({ ...TIMER, drift: 0.4 }), "")
  assert.equal(driftOf(EVENTS), "")
})

test("what a verdict names is drawn first; what has no period only if nothing has one", () => {
  const other = { ...TIMER, name: "battery" }
  assert.deepEqual(chosen({ verdicts: [{ series: ["battery"] }], series: [TIMER, EVENTS, other] }), [other, TIMER])
  assert.deepEqual(chosen({ verdicts: [{ series: [] }], series: [EVENTS] }), [EVENTS])
  assert.equal(chosen({ verdicts: [{ series: [] }], series: Array(9).fill(TIMER) }).length, 4)
})

test("at first the part is shown in which most is missing", () => {
  const [from, span] = part([TIMER], 9.9)
  assert.ok(from < 4.9 && from + span > 5.5 && span < 3, `${from} ${span}`)
  const [row] = rowsIn([TIMER], from, span)
  const [name, words, expected, lost, came] = row
  assert.deepEqual([name, words, lost], ["base: odometry: #", "10 Hz", TIMER.missing])
  assert.equal(expected.length, came.length + lost.length)
  assert.equal(describe([row]), `base: odometry: #: ${came.length} came, 5 missing.`)
})

test("a log of one time, or of irregular lines, has a part, too", () => {
  assert.deepEqual(part([{ ...EVENTS, times: [0] }], 0), [0, 1])
  const [from, span] = part([EVENTS], 9)
  assert.ok(from >= 0 && from + span <= 9)
})

test("how late each came, of a column the ends only", () => {
  const late = [0, 0.08, -0.02]
  const { path, lost, zero, low, high } = dots({ ...TIMER, times: [0, 5, 5], late, missing: [10] }, 10)
  assert.deepEqual([low, high], [-0.02, 0.08])
  assert.equal(path.match(/M/g).length, 3)
  assert.ok(path.startsWith(`M0 ${zero}h0`) && path.includes("M300 6h0") && lost.startsWith(`M${WIDTH} `))
  const many = Array.from({ length: 50_000 }, (_, n) => n / 5000)
  const { path: most } = dots({ ...TIMER, times: many, late: many.map((time) => Math.sin(1e6 * time) / 100) }, 10)
  assert.ok(most.match(/M/g).length <= 2 * (WIDTH + 1))
})

test("what is healthy looks flat", () => {
  const { path } = dots({ ...TIMER, late: times.map((_, n) => (n % 2) * 1e-5) }, 10)
  const heights = [...path.matchAll(/ ([\d.]+)h/g)].map(([, y]) => Number(y))
  assert.ok(Math.max(...heights) - Math.min(...heights) < HEIGHT / 100)
})
