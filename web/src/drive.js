// A drive below a run: the way of the vehicle, and how far off its line it was. What there is to draw comes from
// rosspin/vehicle/drawn.py, as paths.

import { make } from "./make.js"
import { COLOURS, INK, MARGIN, draw, percent } from "./svg.js"

/** How high (px) the curve is, and its axis below. */
const CURVE = 90
const MARKS = 34
const AXIS = 38

const BODY = "M-.34 -.2L.2 -.2L.42 -.09V.09L.2 .2L-.34 .2Z"

/** Lines that stay as wide in a box that is stretched. */
const EVEN = { "vector-effect": "non-scaling-stroke", fill: "none" }

/**
 * A figure of it; null if there is nothing to draw.
 *
 * @param {string[]} drive
 */
export function drawDrive(drive) {
  if (!drive.length) return null
  const [words, box, line, way, off, told, place, curve, edge, ticks, commands, seconds, most] = drive
  const path = (/** @type {string} */ d, /** @type {string} */ stroke, /** @type {number} */ width, more = {}) =>
    draw("path", { d, stroke, "stroke-width": width, ...more })
  const road = draw(
    "svg",
    { class: "rosspin-road", role: "img", "aria-label": words, viewBox: box, fill: "none", "stroke-linecap": "round" },
    path(line, "currentColor", 0.5, { "stroke-opacity": 0.12 }),
    path(line, "currentColor", 0.03, { "stroke-opacity": 0.5, "stroke-dasharray": 0.12 }),
    path(way, COLOURS[0], 0.07),
    path(off, COLOURS[1], 0.13),
    path(told, COLOURS[0], 0.15),
    draw("g", { transform: place }, path(BODY, "currentColor", 0.04, { fill: COLOURS[1] })),
  )
  const inside = { x: percent(100 * MARGIN), width: percent(100 - 200 * MARGIN), preserveAspectRatio: "none" }
  const text = (/** @type {number} */ y, /** @type {string} */ said, more = {}) => draw("text", { x: 2, y, ...more }, said)
  const [top, bottom] = [24, 24 + CURVE]
  const rows = [["ticks", ticks], ["commands", commands]].filter(([, marks]) => marks)
  const deviation = draw(
    "svg",
    { width: "100%", height: bottom + MARKS * rows.length + AXIS, "aria-hidden": "true", fill: "currentColor", "font-size": 13 },
    text(12, `deviation, 0 to ${most} m; dashed: off the line`),
    draw(
      "svg",
      { ...inside, y: top, height: CURVE, viewBox: "0 0 1000 100" },
      path(edge, COLOURS[1], 1.5, { ...EVEN, "stroke-dasharray": "6 4" }),
      path(curve, COLOURS[0], 2, EVEN),
    ),
    draw("line", { x1: 0, x2: "100%", y1: bottom, y2: bottom, ...INK, "stroke-width": 0.8 }),
    ...rows.flatMap(([name, marks], number) => [
      draw(
        "svg",
        { ...inside, y: bottom + MARKS * number + 21, height: 12, viewBox: "0 0 1000 1" },
        path(marks, COLOURS[number], 2, EVEN),
      ),
      text(bottom + MARKS * number + 15, name),
    ]),
    text(bottom + MARKS * rows.length + 18, "0"),
    text(bottom + MARKS * rows.length + 18, `time (s): ${seconds}`, { x: "100%", dx: -2, "text-anchor": "end" }),
  )
  const caption = make("figcaption", { textContent: `simulated. ${words}` })
  return make("figure", { className: "rosspin-plot live-drive" }, road, deviation, caption)
}
