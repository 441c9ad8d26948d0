// Where a plot of a run has its ticks, and how much of them is drawn: see svg.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { drawn, drawTimeline, layOut } from "../src/svg.js"

const tick = (source, number, expected, { real = expected, duration = 0 } = {}) => [source, number, expected, real, duration]

test("the axis begins at 0 and goes to the end of the run, though nothing ticks there any more", () => {
  const { scale, places } = layOut([tick("timer", 1, 0.5)], 10)
  assert.deepEqual([scale.first, scale.span], [0, 10])
  assert.deepEqual(places.map(([across]) => across), [0.05])
})

test("where first ticks were left out, it begins at the first that is there, and ends with the last call", () => {
  const { scale, places } = layOut([tick("t", 7, 3), tick("t", 8, 4, { real: 4.5, duration: 0.5 })], 0)
  assert.deepEqual([scale.first, scale.span], [3, 2])
  assert.deepEqual(places.map(([across]) => across), [0, 0.75])
})

test("a run of no length has an axis", () => assert.equal(layOut([tick("t", 1, 0)], 0).scale.span, 1))

test("each source has a row, in the order of the first ticks, with each time that was expected once", () => {
  const { rows } = layOut([tick("a", 1, 1), tick("b", 1, 1), tick("a", 2, 1, { real: 1.2, duration: 0.1 })], 2)
  assert.deepEqual(rows, [
    ["a", "", [1], [], [[1, 0], [1.2, 0.1]]],
    ["b", "", [1], [], [[1, 0]]],
  ])
})

test("a lost tick has its line and its cross in the row of its source, and the title speaks of crosses", () => {
  const { rows, scale } = layOut([tick("a", 1, 1), tick("b", 1, 1)], 3, [["b", 2], ["b", 3]])
  assert.deepEqual(rows.map(([, , expected, lost]) => [expected, lost]), [[[1], []], [[1, 2, 3], [2, 3]]])
  assert.ok(scale.title.endsWith(", cross: lost"))
  assert.ok(!layOut([tick("a", 1, 1)], 3).scale.title.includes("cross"))
})

test("ticks at the same time stand one above the other, at most three, and rows below each other", () => {
  const { places } = layOut([1, 2, 3, 4].map((number) => tick("t", number, 1)).concat([tick("u", 1, 1)]), 2)
  const [first, second, third, fourth, below] = places.map(([, down]) => down)
  assert.ok(first > second && second > third && third === fourth && below > first)
})

test("calls that overlap have a lane each", () => {
  const { places } = layOut([tick("t", 1, 1, { duration: 2 }), tick("t", 2, 2, { duration: 2 }), tick("t", 3, 3.5)], 5)
  const [first, second, third] = places.map(([, down]) => down)
  assert.ok(first < second && third === first)
})

// --- what is drawn ---

/** As much of a document as drawing needs. */
globalThis.document = {
  createElementNS(_, tag) {
    const element = { tag, children: [], setAttribute: (name, value) => (element[name] = value), append: (...more) => element.children.push(...more) }
    return element
  },
}
const all = (element) => [element, ...(element.children ?? []).flatMap(all)]
const picture = (ticks, end = 0, lost = []) => {
  const { rows, scale } = layOut(ticks, end, lost)
  return all(drawTimeline(rows, scale, ""))
}
const numbers = (elements) => elements.filter((element) => element["text-anchor"] === "middle").map(({ children }) => children[0])

test("an axis has at most eight numbers, wherever it is and however long", () => {
  assert.deepEqual(numbers(picture([tick("t", 1, 0.5)], 3)), ["0", "0.5", "1", "1.5", "2", "2.5", "3"])
  for (const first of [0, 1, 1e5, 1e10, 1e17, 3e17, -1e17, 1e300]) {
    for (const span of [5e-324, 1e-9, 1, 7, 1e10, 1e17]) {
      const scale = { first, span, kinds: 3, title: "" }
      assert.ok(numbers(all(drawTimeline([], scale, ""))).length <= 8, `${first} ${span}`)
    }
  }
})

test("of many ticks some are drawn, the first and the last among them, and it can be said how many", () => {
  for (const rows of [1, 3, 7, 100]) {
    const ticks = Array.from({ length: 2000 }, (_, n) => tick(`t${n % rows}`, n + 1, n / 100, { duration: 0.001 * (n % 5) }))
    const laid = layOut(ticks, 20)
    const elements = picture(ticks, 20, ticks.map(([source], n) => [source, n / 100 + 0.005]))
    assert.ok(drawn(laid.rows) <= 1200 && drawn(laid.rows) > 200, `${rows}: ${drawn(laid.rows)}`)
    assert.ok(elements.length < 6000, `${rows}: ${elements.length}`) // marks, bars, lines, crosses
  }
  const few = Array.from({ length: 600 }, (_, n) => tick("t", n + 1, n / 100))
  assert.equal(drawn(layOut(few, 6).rows), 600)
})

test("bars of many calls at the same time have a height", () => {
  const ticks = Array.from({ length: 100 }, (_, n) => tick("t", n + 1, 1, { duration: 5 }))
  assert.ok(picture(ticks, 10).every(({ tag, height }) => tag !== "rect" || height > 0))
})
