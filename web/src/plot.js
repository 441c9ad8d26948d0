// The ticks of a run as they come, in the look of the site's figures.

import { make } from "./make.js"
import { INK, MARGIN, draw, drawTimeline, layOut, percent } from "./svg.js"

const MOST_TICKS = 2000

/** @typedef {import("./protocol.js").Tick} Tick */
/** @typedef {import("./protocol.js").Lost} Lost */

/** A time in seconds. */
const say = (/** @type {number} */ time) => `${Number(time.toFixed(6))} s`

export class Plot {
  /** @type {Tick[]} */
  #ticks = []
  #frame = 0
  /** @type {number[][]} */
  #chunks = [] // of each tick: what it printed
  /** @type {[share: number, down: number][]} */
  #places = [] // of each tick: where its mark is, across as a share and down in pixels
  #chosen = -1
  #name
  #choose

  /**
   * `choose(chunks)` is called with what a tick printed when the reader points at it; with none when no longer.
   *
   * @param {string} name
   * @param {(chunks: number[]) => void} choose
   */
  constructor(name, choose) {
    this.#name = name
    this.#choose = choose
    this.element = make("figure", { className: "rosspin-plot" })
    this.clear()
  }

  clear() {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#ticks = []
    this.#chosen = -1
    this.element.hidden = true
    this.element.replaceChildren()
  }

  /** @param {Tick[]} ticks */
  add(ticks) {
    if (!ticks.length) return
    this.#ticks.push(...ticks.slice(-MOST_TICKS))
    this.#ticks.splice(0, this.#ticks.length - MOST_TICKS)
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0
      this.#paint("Timeline of a run that goes on.")
    })
  }

  /**
   * Draw the ticks of a run that has ended, at `end` (s), and are known in full; `alternative` says what they show.
   *
   * @param {Tick[]} ticks
   * @param {string} alternative
   * @param {number[][]} chunks
   * @param {number} end
   * @param {Lost[]} lost
   */
  finish(ticks, alternative, chunks, end = 0, lost = []) {
    this.clear()
    this.#ticks = ticks
    this.#chunks = chunks
    this.#paint(`Timeline. ${alternative}`, end, lost)
    this.#offer()
  }

  /** Of a run that was stopped, what came before. */
  stop() {
    if (this.#ticks.length) this.finish(this.#ticks, "The run was stopped.", [])
  }

  /** Let the reader choose a tick: by pointing at it, or like a slider, with the arrow keys. */
  #offer() {
    const picture = /** @type {SVGSVGElement} */ (this.element.querySelector("svg"))
    const ring = draw("circle", { r: 5.5, fill: "none", ...INK, "stroke-width": 1.2 })
    const properties = { className: "live-handle", tabIndex: 0, role: "slider", ariaLabel: this.#name }
    const handle = make("div", { ...properties, ariaValueMin: "1", ariaValueMax: `${this.#ticks.length}` })
    const said = make("p", { className: "live-tick", ariaHidden: "true" }) // it is the handle's value

    const show = (/** @type {number} */ index) => {
      this.#chosen = index
      ring.remove()
      const text = index < 0 ? "Choose a tick: point at it, or use the arrow keys here." : this.#describe(index)
      said.textContent = handle.ariaValueText = text
      handle.ariaValueNow = `${Math.max(index + 1, 1)}`
      if (index >= 0) {
        const [share, y] = this.#places[index]
        ring.setAttribute("cx", percent(100 * share))
        ring.setAttribute("cy", `${y}`)
        picture.lastElementChild?.append(ring)
      }
      this.#choose(this.#chunks[index] ?? [])
    }
    const point = (/** @type {PointerEvent} */ event) => {
      const { left, top, width } = picture.getBoundingClientRect()
      const [x, y] = [event.clientX - left - MARGIN * width, event.clientY - top]
      const distances = this.#places.map(([share, down]) => Math.hypot(share * width * (1 - 2 * MARGIN) - x, down - y))
      const nearest = distances.indexOf(Math.min(...distances))
      if (nearest !== this.#chosen) show(nearest)
    }
    handle.addEventListener("pointermove", point)
    handle.addEventListener("pointerdown", point)
    handle.addEventListener("pointerleave", ({ pointerType }) => {
      if (pointerType === "mouse" && document.activeElement !== handle) show(-1) // a finger leaves when it is lifted
    })
    handle.addEventListener("blur", () => show(-1))
    handle.addEventListener("keydown", (event) => {
      const last = this.#ticks.length - 1
      const [later, earlier] = [this.#chosen + 1, this.#chosen - 1]
      /** @type {Record<string, number>} */
      const keys = { ArrowRight: later, ArrowUp: later, ArrowLeft: earlier, ArrowDown: earlier, Home: 0, End: last }
      const next = keys[event.key]
      if (next === undefined) return
      event.preventDefault()
      show(Math.min(Math.max(next, 0), last))
    })
    show(-1)
    const stage = make("div", { className: "live-stage" })
    picture.replaceWith(stage)
    stage.append(picture, handle)
    stage.after(said)
  }

  /**
   * A tick in words.
   *
   * @param {number} index
   */
  #describe(index) {
    const [source, number, expected, real] = this.#ticks[index]
    const late = Number((real - expected).toFixed(6))
    const lateness = late > 0 ? `${say(late)} late` : late < 0 ? `${say(-late)} early` : "on time"
    return `${source}, tick ${number}: expected ${say(expected)}, real ${say(real)}, ${lateness}`
  }

  /**
   * @param {string} alternative
   * @param {number} end
   * @param {Lost[]} lost
   */
  #paint(alternative, end = 0, lost = []) {
    const { rows, scale, places } = layOut(this.#ticks, end, lost)
    this.#places = places
    const textContent = "simulated: this clock has no jitter, at any speed"
    const caption = make("figcaption", { textContent })
    this.element.replaceChildren(drawTimeline(rows, scale, alternative), caption)
    this.element.hidden = false
  }
}
