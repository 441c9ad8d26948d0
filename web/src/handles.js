// Figures with a handle. The page carries the ticks of all its positions; the one chosen is drawn as rosspin/plots.py
// draws the first, so that moving there and back changes nothing.

import { COLOURS, draw } from "./svg.js"

const ROW = 54
const TICKS = 34
const LEFT = 8

const percent = (share) => `${Math.floor(share * 1e3 + 0.5) / 1e3}%`

/** A mark for a tick: a dot in the first row, a square in the second, a ring in the third. */
function mark(row, x, y) {
  const colour = COLOURS[row % COLOURS.length]
  const shape = row % COLOURS.length
  if (shape === 1) return draw("rect", { x, y: y - 4, width: 8, height: 8, transform: "translate(-4)", fill: colour })
  if (shape === 2) return draw("circle", { cx: x, cy: y, r: 3.5, fill: "none", stroke: colour, "stroke-width": 2 })
  return draw("circle", { cx: x, cy: y, r: 4, fill: colour })
}

/** What a row shows: its name and words, the times expected and lost, and [when, how long] for each tick, in seconds. */
function drawRow(number, [name, words, expected, lost, ticks], { first, span }) {
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
  // Ticks at the same time are drawn one above the other.
  let above = 0
  let before = -Infinity
  for (const [real] of ticks) {
    above = real - before < 1e-3 ? above + 1 : 0
    before = real
    drawn.push(mark(number, scale(real), y - 10 * above))
  }
  return drawn
}

/** The number that code beside a figure assigns to a variable; undefined where there is none. */
function assigned(figure, name) {
  const tokens = [...(figure.closest(".rosspin-beside")?.querySelectorAll("pre span") ?? [])]
  const at = tokens.findIndex((token) => token.textContent === name && token.nextElementSibling?.textContent === "=")
  return at < 0 ? undefined : tokens[at].nextElementSibling.nextElementSibling
}

function move(figure) {
  const { sets, positions, ...scale } = JSON.parse(figure.dataset.positions)
  const handle = figure.querySelector(".rosspin-handle")
  const input = handle.querySelector("input")
  const said = handle.querySelector("[aria-hidden]")
  const picture = figure.querySelector("svg")
  const rows = picture.querySelectorAll(":scope > g")
  const number = sets ? assigned(figure, sets) : undefined

  const show = (position) => {
    const [value, words, alternative, ticks] = positions[position]
    ticks.forEach((row, index) => rows[index].replaceChildren(...drawRow(index, row, scale)))
    picture.setAttribute("aria-label", alternative)
    input.setAttribute("aria-valuetext", words)
    said.textContent = words
    if (number) number.textContent = value
  }
  input.addEventListener("input", () => show(input.valueAsNumber))
  // On paper, where nothing moves, stands what the text around the figure is about.
  addEventListener("beforeprint", () => show(Number(input.defaultValue)))
  addEventListener("afterprint", () => show(input.valueAsNumber))
  number?.classList.add("rosspin-number")
  handle.hidden = false
}

document.querySelectorAll("figure[data-positions]").forEach(move)
