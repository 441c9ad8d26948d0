// How often a page paints what comes without end: see painter.js. Time is simulated.

import assert from "node:assert/strict"
import { test } from "node:test"

import { Painter } from "../src/painter.js"

const FRAME = 16

/** Let something happen every 10 ms for so long (ms), and painting take so long: when (ms) it began. */
function painted(length, takes, act = (painter) => painter.soon()) {
  let now = 0
  const due = []
  const later = (wait) => (call, ms = 0) => due.push({ at: wait(ms), call })
  const cancel = (number) => due[number - 1] && (due[number - 1].call = null)
  globalThis.performance = { now: () => now }
  globalThis.setTimeout = later((ms) => now + ms)
  globalThis.requestAnimationFrame = later(() => (Math.floor(now / FRAME) + 1) * FRAME)
  globalThis.clearTimeout = globalThis.cancelAnimationFrame = cancel
  const times = []
  const painter = new Painter(() => {
    times.push(now)
    now += takes
  })
  for (let time = 0; time <= length; time += 10) {
    now = Math.max(now, time)
    act(painter, time)
    for (;;) {
      const next = due.filter(({ call, at }) => call && at < time + 10).sort((one, other) => one.at - other.at)[0]
      if (!next) break
      now = Math.max(now, next.at)
      const { call } = next
      next.call = null
      call(now)
    }
  }
  return times
}

const own = { performance, setTimeout, clearTimeout }
const each = (takes, length = 10_000) => {
  try {
    return painted(length, takes)
  } finally {
    Object.assign(globalThis, own)
  }
}

test("what is painted quickly is painted with each frame", () => assert.ok(each(0, 1000).length > 1000 / FRAME / 2))

for (const takes of [50, 200, 1000]) {
  test(`to paint for ${takes} ms at a time takes a fifth of the time at most`, () => {
    const times = each(takes)
    assert.ok(times.length > 1)
    const gaps = times.slice(1).map((time, n) => time - times[n])
    assert.ok(Math.min(...gaps) >= 5 * takes, String(gaps))
  })
}

test("what was not asked for is not painted, nor what was taken back; what is wanted now is painted once", () => {
  try {
    const times = painted(1000, 0, (painter, time) => {
      if (time === 100 || time === 200) painter.soon()
      if (time === 100) painter.clear()
      if (time === 0 || time === 200) painter.now()
    })
    assert.deepEqual(times, [200])
  } finally {
    Object.assign(globalThis, own)
  }
})
