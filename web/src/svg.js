// How a page draws a timeline: where rosspin/plots/layout.py has what, which a test compares. Across in percent of the
// width and down in pixels.

export const COLOURS = RULES.timeline.colours
export const MARGIN = RULES.timeline.margin
const KINDS = RULES.timeline.kinds
const TOP = RULES.timeline.top
const ROW = RULES.timeline.row
const TICKS = RULES.timeline.ticks
const REACH = RULES.timeline.reach
const BAR = RULES.timeline.bar
const ABOVE = RULES.timeline.above
const MOST_ABOVE = RULES.timeline.mostAbove
const AXIS = RULES.timeline.axis
const STEPS = RULES.timeline.steps
const MANY = RULES.timeline.many
const COLUMNS = RULES.timeline.columns
const CLOSE = RULES.timeline.close
const TITLE = RULES.timeline.title
const MOST = 1200 // marks in all, as many as a browser draws in a moment
export const INK = { stroke: "currentColor" }
const LINE = { ...INK, "stroke-opacity": 0.55 }

/**
 * An SVG element.
 *
 * @param {string} tag
 * @param {Record<string, string | number>} attributes
 * @param {(Node | string)[]} children
 */
export function draw(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag)
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, /** @type {string} */ (value))
  element.append(...children)
  return element
}

const round = (/** @type {number} */ value) => Math.floor(value * 1e3 + 0.5) / 1e3

export const percent = (/** @type {number} */ share) => `${round(share)}%`

/**
 * What a row shows: its name and words, the times (s) expected and lost, and when (s) and for how long (s) it ticked.
 *
 * @typedef {[name: string, words: string, expected: number[], lost: number[], ticks: When[]]} Row
 * @typedef {[real: number, duration: number]} When
 * @typedef {{first: number, span: number, kinds: number}} Scale when (s) it begins, how long (s) it is; kinds of marks
 */

/**
 * A mark for a tick: a dot in the first row, a square in the second, a ring in the third.
 *
 * @param {number} kind
 * @param {string} x
 * @param {number} y
 */
function mark(kind, x, y) {
  const colour = COLOURS[kind]
  if (kind === 1) return draw("rect", { x, y: y - 4, width: 8, height: 8, transform: "translate(-4)", fill: colour })
  if (kind === 2) return draw("circle", { cx: x, cy: y, r: 3.5, fill: "none", stroke: colour, "stroke-width": 2 })
  return draw("circle", { cx: x, cy: y, r: 4, fill: colour })
}

/**
 * The numbers of the points to draw: of all, or if they are many, of the lowest and the highest in each column.
 *
 * @param {number[]} across
 * @param {number[]} up
 * @param {number} most
 */
export function toDraw(across, up, most) {
  if (across.length <= most) return across.map((_, index) => index)
  const first = Math.min(...across)
  const width = (Math.max(...across) - first) / Math.max(Math.min(COLUMNS, most / 2 - 1), 1) || 1
  /** @type {Map<number, [low: number, high: number]>} */
  const columns = new Map()
  across.forEach((x, index) => {
    const column = Math.floor((x - first) / width)
    const [low, high] = columns.get(column) ?? [index, index]
    columns.set(column, [up[index] < up[low] ? index : low, up[index] > up[high] ? index : high])
  })
  return [...new Set([...columns.values()].flat())].sort((one, other) => one - other)
}

const mostOf = (/** @type {number} */ rows) => Math.min(MANY, Math.floor(MOST / rows))

/** @type {(ticks: When[], most: number) => number[]} */
const drawnOf = (ticks, most) => toDraw(ticks.map(([real]) => real), ticks.map(([, duration]) => duration), most)

/**
 * How many of the ticks in some rows are drawn.
 *
 * @param {Row[]} rows
 */
export const drawn = (rows) => rows.reduce((sum, [, , , , ticks]) => sum + drawnOf(ticks, mostOf(rows.length)).length, 0)

/**
 * The elements of a row.
 *
 * @param {number} number
 * @param {Row} row
 * @param {Scale} scale
 * @param {number} most marks of a kind
 */
function drawRow(number, [, , expected, lost, ticks], { first, span, kinds }, most) {
  const scale = (/** @type {number} */ time) => percent((100 * (time - first)) / span)
  const top = TOP + ROW * number
  const y = top + TICKS
  const kind = number % kinds
  const [lanes, height] = lanesOf(ticks)
  const drawn = []
  const few = drawnOf(ticks, most)
  const some = (/** @type {number[]} */ times) => toDraw(times, times.map(() => 0), most).map((index) => scale(times[index]))
  for (const x of some(expected)) {
    drawn.push(draw("line", { x1: x, x2: x, y1: y - REACH, y2: y + REACH, ...LINE }))
  }
  for (const index of few) {
    const [real, duration] = ticks[index]
    if (!duration) continue
    const place = { x: scale(real), y: round(y + lanes[index] - height / 2) }
    const size = { width: percent((100 * duration) / span), height: round(height) }
    drawn.push(draw("rect", { ...place, ...size, fill: COLOURS[kind], "fill-opacity": 0.45 }))
  }
  for (const x of some(lost)) {
    const cross = { d: "M-5-5 5 5M-5 5 5-5", ...INK, "stroke-width": 2 }
    drawn.push(draw("svg", { x, y }, draw("path", cross)))
  }
  const down = heights(number, ticks)
  for (const index of few) drawn.push(mark(kind, scale(ticks[index][0]), down[index]))
  return drawn
}

/**
 * How far down the calls of a row are, and the height of their bars: calls that overlap get a lane each.
 *
 * @param {When[]} ticks
 * @returns {[lanes: number[], height: number]}
 */
export function lanesOf(ticks) {
  /** @type {number[]} */
  const ends = [] // of the last call in each lane
  const taken = ticks.map(([real, duration]) => {
    const free = ends.findIndex((end) => end < real + CLOSE)
    const lane = free < 0 ? ends.length : free
    ends[lane] = real + duration
    return lane
  })
  const pitch = (2 * REACH) / Math.max(ends.length, 1)
  return [taken.map((lane) => (lane - (ends.length - 1) / 2) * pitch), Math.max(Math.min(BAR, pitch - 1), 0.5)]
}

/**
 * How far down the ticks of a row are. Those at the same time are one above the other, as far as there is room.
 *
 * @param {number} number of the row
 * @param {When[]} ticks
 */
export function heights(number, ticks) {
  const [lanes] = lanesOf(ticks)
  let above = 0
  return ticks.map(([real], index) => {
    const isAbove = index && real - ticks[index - 1][0] < CLOSE && lanes[index] === lanes[index - 1]
    above = isAbove ? Math.min(above + 1, MOST_ABOVE) : 0
    return round(TOP + ROW * number + TICKS + lanes[index] - ABOVE * above)
  })
}

/**
 * The ticks of a run that has come to `end` (s) as a timeline: its rows and its scale, and of each tick where its mark is,
 * across as a share and down in pixels.
 *
 * @param {import("./protocol.js").Tick[]} ticks at least one
 * @param {number} end
 * @param {import("./protocol.js").Lost[]} lost
 */
export function layOut(ticks, end, lost = []) {
  const begin = Math.min(...ticks.map(([, , expected]) => expected))
  const first = ticks[0][1] === 1 ? Math.min(0, begin) : begin
  const last = Math.max(end, ...ticks.map(([, , expected, real, duration]) => Math.max(expected, real + duration)))
  const scale = { first, span: last - first || 1, kinds: KINDS, title: TITLE + (lost.length ? ", cross: lost" : "") }
  /** @type {Map<string, Row>} */
  const found = new Map()
  /** @type {Map<string, Set<number>>} */
  const times = new Map()
  for (const [source, , expected, real, duration] of ticks) {
    const row = found.get(source) ?? /** @type {Row} */ ([source, "", [], [], []])
    const known = times.get(source) ?? new Set()
    found.set(source, row)
    times.set(source, known)
    if (!known.has(expected)) row[2].push(expected)
    known.add(expected)
    row[4].push([real, duration])
  }
  for (const [source, time] of lost) {
    const row = found.get(source)
    row?.[2].push(time)
    row?.[3].push(time)
  }
  const rows = [...found.values()]
  const down = new Map(rows.map(([source, , , , when], number) => [source, heights(number, when)]))
  const places = ticks.map(([source, , , real]) => [(real - first) / scale.span, down.get(source)?.shift()])
  return { rows, scale, places: /** @type {[share: number, down: number][]} */ (places) }
}

/**
 * A timeline with its axis: `title` says what there is to see, `alternative` what is seen.
 *
 * @param {Row[]} rows
 * @param {Scale & {title: string}} scale
 * @param {string} alternative
 */
export function drawTimeline(rows, { title, ...scale }, alternative) {
  const top = TOP + ROW * rows.length
  const axis = []
  for (const number of numbers(scale.first, scale.span)) {
    const x = percent((100 * (number - scale.first)) / scale.span)
    axis.push(draw("line", { x1: x, x2: x, y1: top, y2: top + 3.5, ...INK, "stroke-width": 0.8 }))
    axis.push(draw("text", { x, y: top + 17, "text-anchor": "middle" }, String(Number(number.toPrecision(9)))))
  }
  const drawn = rows.map((row, number) => draw("g", {}, ...drawRow(number, row, scale, mostOf(rows.length))))
  const place = { x: percent(100 * MARGIN), width: percent(100 - 200 * MARGIN) }
  const texts = rows.flatMap(([name, words], number) => [
    draw("text", { x: 2, y: TOP + ROW * number + 10, "font-weight": 700 }, name),
    draw("text", { x: "100%", dx: -2, y: TOP + ROW * number + 10, "text-anchor": "end" }, words),
  ])
  return draw(
    "svg",
    {
      ...{ width: "100%", height: ROW * rows.length + AXIS, role: "img", "aria-label": alternative },
      ...{ fill: "currentColor", "font-size": 13 },
    },
    draw("line", { x1: 0, x2: "100%", y1: top, y2: top, ...INK, "stroke-width": 0.8 }),
    draw("text", { x: "100%", dx: -2, y: top + 34, "text-anchor": "end" }, title),
    ...texts,
    draw("svg", place, ...drawn, ...axis),
  )
}

/**
 * The numbers of an axis: their step is 1, 2 or 5 times a power of ten.
 *
 * @param {number} first
 * @param {number} span
 */
export function numbers(first, span) {
  const power = 10 ** Math.floor(Math.log10(span / STEPS))
  const size = power * ([1, 2, 5].find((factor) => span / (factor * power) <= STEPS) ?? 10)
  const begin = Math.ceil(first / size - 1e-9)
  // They are counted: added to a number that is large enough, 1 changes nothing.
  const found = Array.from({ length: STEPS + 1 }, (_, count) => (begin + count) * size)
  return found.filter((number) => number <= first + span + 1e-9 * size)
}
