// What a page draws of a log: which series, which part of them, and how late they were. See look.js.

/**
 * @typedef {import("./protocol.js").Series} Series
 * @typedef {import("./protocol.js").LookResult} LookResult
 * @typedef {import("./svg.js").Row} Row
 */

import { sayTime } from "./measures.js"

/** So many series are drawn; all are in the table. */
const MOST_ROWS = 4

/** So many marks are drawn in a row of the timeline. */
const MOST_MARKS = 300

/** So long is a timeline: this many of the shortest periods, if the longest one fits, but not more than that many. */
const PERIODS = 20
const MOST_PERIODS = 60

/** The picture of lateness is drawn in so many units across and down; of each column, the latest and the earliest. */
export const WIDTH = 600
export const HEIGHT = 100
const EDGE = 6

/** So much of a period is seen at least, so that what is healthy looks flat. */
const LEAST = 0.05

/** A length of time in words: s. */
export function say(/** @type {number} */ seconds) {
  return sayTime(seconds).replace("-", "−")
}

/**
 * A series by its name, of which `most` characters are shown; two counts in one line have the same.
 *
 * @param {Series} series
 */
export function nameOf({ name, part }, most = Infinity) {
  const short = name.length > most ? `${name.slice(0, most - 1)}…` : name
  return part ? `${short} (${part})` : short
}

export const rateOf = (/** @type {Series} */ { period }) =>
  period ? `${Number((1 / period).toPrecision(4))} Hz` : "irregular"

/** By how much the period is longer than one that someone may have chosen; "" if there is none near. */
export function driftOf(/** @type {Series} */ { period, chosen, drift }) {
  if (!period || !chosen || Math.abs(drift) >= 0.2) return ""
  const percent = Number((100 * drift).toFixed(2))
  return percent ? `${percent > 0 ? "+" : "−"}${Math.abs(percent)}% on ${say(chosen)}` : "none"
}

/**
 * The series to draw: those that the first verdict is about, then the most frequent ones; the regular ones if any is.
 *
 * @param {LookResult} result
 */
export function chosen({ verdicts, series }) {
  const named = new Set(verdicts[0]?.series)
  const drawn = series.filter(({ times, period }) => times.length && period)
  const sorted = (drawn.length ? drawn : series.filter(({ times }) => times.length)).slice()
  sorted.sort((one, other) => Number(named.has(other.name)) - Number(named.has(one.name)))
  return sorted.slice(0, MOST_ROWS)
}

/**
 * The part of a log that is shown at first: when (s) it begins and how long (s) it is. In it is what sticks out most.
 *
 * @param {Series[]} rows at least one
 * @param {number} seconds how long the log is
 * @returns {[from: number, span: number]}
 */
export function part(rows, seconds) {
  const periods = rows.map(({ period, times }) => period || (seconds || 1) / times.length)
  const shortest = Math.min(...periods)
  const wanted = Math.max(PERIODS * shortest, 1.2 * Math.max(...periods))
  const span = Math.min(wanted, MOST_PERIODS * shortest, seconds || 1)
  let [most, where] = [-1, 0]
  rows.forEach(({ times }, row) => {
    for (let n = 1; n < times.length; n++) {
      const excess = Math.abs(times[n] - times[n - 1] - periods[row])
      if (excess > most) [most, where] = [excess, times[n - 1]]
    }
  })
  return [Math.max(0, Math.min(where - span / 4, seconds - span)), span]
}

/**
 * The rows of a timeline of that part.
 *
 * @param {Series[]} rows
 * @param {number} from
 * @param {number} span
 * @param {number} [most] of a name, in characters
 * @returns {Row[]}
 */
export function rowsIn(rows, from, span, most) {
  const isIn = (/** @type {number} */ time) => time >= from && time <= from + span
  return rows.map((series) => {
    const { times, late, missing } = series
    const due = late.map((each, n) => times[n] - each)
    const lost = missing.filter(isIn).slice(0, MOST_MARKS)
    const expected = [...due.filter(isIn), ...lost].slice(0, MOST_MARKS)
    /** @type {[real: number, duration: number][]} */
    const came = times.filter(isIn).slice(0, MOST_MARKS).map((time) => [time, 0])
    return [nameOf(series, most), rateOf(series), expected, lost, came]
  })
}

/**
 * What such a timeline shows, in words.
 *
 * @param {Row[]} rows
 */
export const describe = (rows) =>
  rows.map(([name, , , lost, came]) => `${name}: ${came.length} came${lost.length ? `, ${lost.length} missing` : ""}.`).join(" ")

/**
 * How late a series was, as the path of a line with round ends: a dot for each that came, and a stroke below for each
 * that is missing; and how far that reaches (s).
 *
 * @param {Series} series
 * @param {number} seconds how long the log is
 */
export function dots({ times, late, missing, period }, seconds) {
  const column = (/** @type {number} */ time) => Math.round((time / (seconds || 1)) * WIDTH)
  /** @type {Map<number, [low: number, high: number]>} */
  const columns = new Map()
  late.forEach((each, n) => {
    const at = column(times[n])
    const [low, high] = columns.get(at) ?? [each, each]
    columns.set(at, [Math.min(low, each), Math.max(high, each)])
  })
  let [low, high] = [0, 0]
  for (const [least, most] of columns.values()) [low, high] = [Math.min(low, least), Math.max(high, most)]
  const scale = (HEIGHT - 2 * EDGE) / Math.max(high - low, LEAST * period)
  const down = (/** @type {number} */ each) => Number((EDGE + (high - each) * scale).toFixed(1))
  const path = [...columns].flatMap(([at, ends]) => [...new Set(ends.map(down))].map((y) => `M${at} ${y}h0`)).join("")
  const lost = [...new Set(missing.map(column))].map((at) => `M${at} ${HEIGHT - EDGE}v${EDGE}`).join("")
  return { path, lost, zero: down(0), low, high }
}
