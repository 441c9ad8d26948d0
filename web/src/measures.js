// What a run's ticks come to, in words and numbers, as rosspin/measures.py has them.

/** @typedef {import("./protocol.js").Tick} Tick */

/** A difference below this part of a period does not count. */
const CLOSE = 0.02

/** The most periods of a run in which lost ticks are worth looking for. */
const MOST_PERIODS = 1_000_000

/** Fewer values have no hundredth part to speak of. */
const MANY = 100

/**
 * The ticks by their sources, in the order of the first ones.
 *
 * @param {Tick[]} ticks
 */
export function bySource(ticks) {
  /** @type {Map<string, Tick[]>} */
  const groups = new Map()
  for (const tick of ticks) {
    const group = groups.get(tick[0])
    if (group) group.push(tick)
    else groups.set(tick[0], [tick])
  }
  return groups
}

/**
 * The times (s) that were lost, of ticks of one source.
 *
 * @param {Tick[]} ticks
 * @param {number} period
 */
export function lost(ticks, period) {
  if (!(period * MOST_PERIODS > ticks.reduce((most, [, , , real]) => Math.max(most, real), 0))) return []
  const origin = ticks[0][2]
  let previous = origin
  let moved = 0
  let last = 0
  const served = new Set()
  for (const [, , expected, real] of ticks) {
    if (expected - previous > 1.5 * period) moved = 0
    const due = expected + moved
    served.add((last = Math.trunc((due - origin) / period + CLOSE)))
    if (real - due > 2 * period) moved = real - expected
    previous = expected
  }
  return [...Array(Math.max(last, 0)).keys()].filter((number) => !served.has(number)).map((number) => origin + number * period)
}

/**
 * The ticks of one source in a few sentences.
 *
 * @param {string} name
 * @param {Tick[]} ticks
 */
export function describe(name, ticks) {
  const [first, last] = [ticks[0][3], ticks[ticks.length - 1][3]]
  const span =
    ticks.length === 1 ? `1 tick at ${fixed(first)} s` : `${ticks.length} ticks from ${fixed(first)} s to ${fixed(last)} s`
  const most = sideBySide(ticks)
  return `${name}: ${span}. ${describeLateness(ticks)}${most > 1 ? ` Up to ${most} calls ran side by side.` : ""}`
}

/** @param {Tick[]} ticks */
function sideBySide(ticks) {
  let most = 0
  /** @type {number[]} */
  let ends = []
  for (const [, , , real, duration] of ticks) {
    ends = [...ends.filter((end) => end >= real + 1e-3), real + duration]
    most = Math.max(most, ends.length)
  }
  return most
}

/** @param {Tick[]} ticks */
function describeLateness(ticks) {
  const late = ticks.map(([, , expected, real]) => real - expected).sort((one, other) => one - other)
  const count = late.length
  const [least, most] = [late[0], late[count - 1]]
  if (Math.max(Math.abs(least), Math.abs(most)) < 0.5e-6) {
    return count === 1 ? "The only tick was on time." : `All ${count} ticks were on time.`
  }
  if (count === 1) return `The only tick was ${sayTime(most)} late.`
  const middle = (late[(count - 1) >> 1] + late[count >> 1]) / 2
  if (middle < 0.5e-6) return `At least half of the ${count} ticks were on time; the latest was ${sayTime(most)} late.`
  const share = count >= MANY ? ` and 99% at most ${sayBeside(late[Math.ceil((99 * count) / 100) - 1], middle)}` : ""
  const latest = `${sayBeside(most, middle)} late`
  return `Half of the ${count} ticks were at most ${sayTime(middle)} late${share}; the latest was ${latest}.`
}

/**
 * A length of time (s) in a suitable unit.
 *
 * @param {number} seconds
 */
export function sayTime(seconds) {
  for (const [unit, size] of /** @type {const} */ ([["s", 1], ["ms", 1e-3]])) {
    if (Math.abs(seconds) >= 0.0995 * size) return `${three(seconds / size)} ${unit}`
  }
  return Math.abs(seconds) >= 0.5e-9 ? `${three(seconds * 1e6)} µs` : "0 s"
}

/**
 * Three digits that count. What is exactly between two is rounded to the even one, as Python does.
 *
 * @param {number} value
 */
function three(value) {
  const even = value.toExponential(99).match(/^(-?\d\.\d[02468])50*(e.*)$/)
  return String(Number(even ? even[1] + even[2] : value.toPrecision(3)))
}

/**
 * @param {number} seconds
 * @param {number} other
 */
function sayBeside(seconds, other) {
  const inMs = 0.5e-6 <= other && other < 0.0995 && 0.0995 <= seconds && seconds < 0.9995
  return inMs ? `${three(seconds * 1e3)} ms` : sayTime(seconds)
}

/**
 * A time with three decimals. What is exactly between two is rounded to the even one, as Python does.
 *
 * @param {number} value
 */
function fixed(value) {
  const isBetween = Number.isInteger(value * 16) && !Number.isInteger(value * 8)
  return isBetween && Math.floor(value * 1000) % 2 === 0 ? (Math.floor(value * 1000) / 1000).toFixed(3) : value.toFixed(3)
}
