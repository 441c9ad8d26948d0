// Who waits for whom in a deadlock, as a picture: boxes one below the other, and the way back next to them.

import { sayRing, wrapped } from "./scenes.js"
import { draw } from "./svg.js"

const WIDTH = 340
const LEFT = 22 // of the boxes; the way back is further left
const LINE = 16
const [IN_BOX, IN_WAIT] = [44, 40] // characters in a line
const STROKE = { fill: "none", stroke: "currentColor", "stroke-width": 1.4 }

/**
 * The picture of a ring.
 *
 * @param {import("./protocol.js").Ring} ring
 */
export function drawRing(ring) {
  let y = 2
  /** @type {SVGElement[]} */
  const parts = []
  /** @type {number[]} */
  const tops = []
  const write = (/** @type {string[]} */ lines, /** @type {number} */ x, /** @type {object} */ style) => {
    for (const line of lines) parts.push(draw("text", { x, y: (y += LINE), ...style }, line))
  }
  ring.links.forEach(([name, waits], index) => {
    const lines = wrapped(name, IN_BOX)
    tops.push(y)
    parts.push(draw("rect", { x: LEFT, y, width: WIDTH - LEFT - 1, height: lines.length * LINE + 10, rx: 4, ...STROKE }))
    write(lines, LEFT + 8, { "font-weight": 700 })
    const from = (y += 10)
    write(wrapped(waits, IN_WAIT), LEFT + 26, {})
    y += 12
    const goesOn = index < ring.links.length - 1
    if (goesOn) parts.push(draw("path", { d: `M${LEFT + 12} ${from}V${y}m-4 -6l4 6l4 -6`, ...STROKE }))
    else if (ring.to < 0) parts.push(draw("path", { d: `M${LEFT + 12} ${from}V${y}m-6 0h12`, ...STROKE }))
    else parts.push(draw("path", { d: `M${LEFT + 12} ${from}V${y}H6V${tops[ring.to] + 13}H${LEFT}m-6 -4l6 4l-6 4`, ...STROKE }))
  })
  const size = { width: WIDTH, height: y + 4, viewBox: `0 0 ${WIDTH} ${y + 4}` }
  return draw("svg", { ...size, class: "stepper-ring", role: "img", "aria-label": sayRing(ring), fill: "currentColor" }, ...parts)
}
