// How a page draws a timeline: as rosspin/plots.py draws the plots that are made with the site, across in percent of the
// width and down in pixels.

const COLOURS = ["#0072b2", "#d55e00", "#009e73"]
const ROW = 54
const TICKS = 34
const AXIS = 42
export const LEFT = 8
export const RIGHT = 14

/** An SVG element. */
export function draw(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag)
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value)
  element.append(...children)
  return element
}

export const percent = (share) => `${Math.floor(share * 1e3 + 0.5) / 1e3}%`

/** A mark for a tick: a dot in the first row, a square in the second, a ring in the third. */
function mark(row, x, y) {
  const colour = COLOURS[row % COLOURS.length]
  const shape = row % COLOURS.length
  if (shape === 1) return draw("rect", { x, y: y - 4, width: 8, height: 8, transform: "translate(-4)", fill: colour })
  if (shape === 2) return draw("circle", { cx: x, cy: y, r: 3.5, fill: "none", stroke: colour, "stroke-width": 2 })
  return draw("circle", { cx: x, cy: y, r: 4, fill: colour })
}

/** What a row shows: its name and words, the times expected and lost, and [when, how long] for each tick, in seconds. */
export function drawRow(number, [name, words, expected, lost, ticks], { first, span }) {
  const scale = (time) => percent((100 * (time - first)) / span)
  const top = ROW * number
  const y = top + TICKS
  const text = draw("text", { x: -LEFT, y: top + 14 }, draw("tspan", { "font-weight": 600 }, name))
  if (words) text.append(` ${words}`)
  const drawn = [text]
  for (const x of expected.map(scale)) {
    drawn.push(draw("line", { x1: x, x2: x, y1: y - 13, y2: y + 13, stroke: "currentColor", "stroke-opacity": 0.55 }))
  }
  for (const [real, duration] of ticks) {
    if (!duration) continue
    const bar = { x: scale(real), y: y - 5, width: percent((100 * duration) / span), height: 10 }
    drawn.push(draw("rect", { ...bar, fill: COLOURS[number % COLOURS.length], "fill-opacity": 0.45 }))
  }
  for (const x of lost.map(scale)) {
    const cross = { d: "M-5 -5L5 5M-5 5L5 -5", stroke: "currentColor", "stroke-width": 2 }
    drawn.push(draw("svg", { x, y, overflow: "visible" }, draw("path", cross)))
  }
  heights(number, ticks).forEach((height, index) => drawn.push(mark(number, scale(ticks[index][0]), height)))
  return drawn
}

/** How far down the ticks of a row are. Those at the same time are drawn one above the other. */
export function heights(number, ticks) {
  let above = 0
  let before = -Infinity
  return ticks.map(([real]) => {
    above = real - before < 1e-3 ? above + 1 : 0
    before = real
    return ROW * number + TICKS - 10 * above
  })
}

/** A timeline with its axis. */
export function drawTimeline(rows, scale, alternative) {
  const top = ROW * rows.length
  const axis = [draw("line", { x1: 0, x2: "100%", y1: top + 0.5, y2: top + 0.5, stroke: "currentColor" })]
  const size = step(scale.span)
  for (let n = Math.ceil(scale.first / size - 1e-9); n * size <= scale.first + scale.span + 1e-9 * size; n++) {
    const x = percent((100 * (n * size - scale.first)) / scale.span)
    axis.push(draw("line", { x1: x, x2: x, y1: top, y2: top + 4, stroke: "currentColor" }))
    const number = String(Number((n * size).toPrecision(6)))
    axis.push(draw("text", { x, y: top + 18, "text-anchor": "middle" }, number))
  }
  const title = "time (s); line: expected, mark: real"
  axis.push(draw("text", { x: "100%", dx: RIGHT, y: top + 36, "text-anchor": "end" }, title))
  const drawn = rows.map((row, number) => draw("g", {}, ...drawRow(number, row, scale)))
  return draw("svg", { height: top + AXIS, role: "img", "aria-label": alternative }, ...drawn, ...axis)
}

/** The step between the numbers on an axis of that length: 1, 2 or 5 times a power of ten, at most 7 of them. */
function step(length) {
  const power = 10 ** Math.floor(Math.log10(length / 7))
  return [1, 2, 5, 10].map((factor) => factor * power).find((size) => length / size <= 7)
}
