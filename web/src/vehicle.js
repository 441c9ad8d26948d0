// The vehicle of the first page. The page carries, of each node and each length of a callback, the way that its run gave;
// here nothing of it is calculated. The vehicle is as fast everywhere: it is as far along its way as the run has come.

import { find } from "./make.js"
import { Play } from "./play.js"

/** How much faster than the run it plays. */
const SPEED = 2

/**
 * What there is to see: in words, the way and its dashes where a tick is overdue, and when the vehicle is off its line most.
 *
 * @typedef {[words: string, alternative: string, path: string, dashes: string, when: number]} Position
 */

const figure = /** @type {HTMLElement} */ (find("figure[data-vehicle]"))
/** @type {[seconds: number, lengths: number[], nodes: Position[][]]} */
const [seconds, lengths, nodes] = JSON.parse(figure.dataset.vehicle ?? "")
const choice = /** @type {HTMLFieldSetElement} */ (find("fieldset", figure))
const handle = find(".rosspin-handle", figure)
const input = /** @type {HTMLInputElement} */ (find("input", handle))
const picture = find("svg", figure)
const ways = /** @type {NodeListOf<SVGPathElement>} */ (figure.querySelectorAll(".way"))
const vehicle = find(".vehicle", figure)
const button = find("button", figure)
const play = new Play(seconds)

/** @returns {Position} */
const chosen = () => nodes[Number(/** @type {HTMLInputElement} */ (find(":checked", choice)).value)][input.valueAsNumber]

/** @param {number} time */
function place(time) {
  const along = (/** @type {number} */ share) => ways[0].getPointAtLength(share * ways[0].getTotalLength())
  const [{ x, y }, before, after] = [0, -1e-3, 1e-3].map((more) => along(time / seconds + more))
  const degrees = (Math.atan2(after.y - before.y, after.x - before.x) * 180) / Math.PI
  vehicle.setAttribute("transform", `translate(${x} ${y}) rotate(${degrees})`)
}

/** Show what is chosen; while nothing plays, the moment at which the vehicle is off its line most. */
function show() {
  const [words, alternative, path, dashes, when] = chosen()
  const length = `${lengths[input.valueAsNumber].toFixed(1)} s`
  ways.forEach((way) => way.setAttribute("d", path))
  ways[1].setAttribute("stroke-dasharray", dashes)
  picture.setAttribute("aria-label", alternative)
  input.setAttribute("aria-valuetext", length)
  find("b", handle).textContent = length
  find("output", figure).textContent = words
  if (!play.plays) stand(when)
}

/** @param {number} time */
function stand(time) {
  button.textContent = "Play"
  place(time)
}

function move() {
  if (!play.plays) return
  place(play.at(now()))
  if (play.plays) requestAnimationFrame(move)
  else stand(chosen()[4])
}

const now = () => (performance.now() / 1000) * SPEED

function toggle() {
  play.toggle(now())
  button.textContent = play.plays ? "Pause" : "Play"
  move()
}

choice.addEventListener("change", show)
input.addEventListener("input", () => {
  play.stop()
  show()
})
button.addEventListener("click", toggle)
choice.hidden = handle.hidden = button.hidden = false
if (!matchMedia("(prefers-reduced-motion: reduce)").matches) toggle()
