// The ticks of a run as they come, in the look of the site's figures.

import { SHOWN } from "./limits.js"
import { make } from "./make.js"
import { Painter } from "./painter.js"
import { INK, MARGIN, draw, drawTimeline, drawn, layOut, percent } from "./svg.js"

/** While a run lasts, its axis stands still for so long (s), or until the end of the run. */
const STEP = 30

/** No timeline has more rows. */
const MOST_ROWS = 100

/** @typedef {import("./protocol.js").Tick} Tick */
/** @typedef {import("./protocol.js").Lost} Lost */

const say = (/** @type {number} */ count) => count.toLocaleString("en-GB")

/** A time in seconds. */
const inSeconds = (/** @type {number} */ time) => `${Number(time.toFixed(6))} s`

export class Plot {
  /** @type {Tick[]} */
  #ticks = []
  #painter = new Painter(() => this.#paint("Timeline of a run in progress.", this.#until))
  /** @type {string[]} */
  #drive = []
  #seconds = 0 // that a run should last
  /** @type {number[][]} */
  #chunks = [] // of each tick: what it printed
  /** @type {[share: number, down: number][]} */
  #places = [] // of each tick: where its mark is, across as a share and down in pixels
  #chosen = -1
  #count = 0 // of the ticks that there were
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
    this.driven = make("div", {}) // what a vehicle did, if there was one
    this.clear()
  }

  clear() {
    this.#painter.clear()
    this.#ticks = []
    this.#count = 0
    this.#chosen = -1
    this.element.hidden = true
    this.element.replaceChildren()
  }

  /**
   * A run begins that should last so long.
   *
   * @param {number} seconds
   */
  expect(seconds) {
    this.#seconds = seconds
  }

  /** Where the axis ends while the run lasts. */
  get #until() {
    const last = this.#ticks.at(-1)?.[3] ?? 0
    return Math.min(this.#seconds, STEP * Math.ceil((last + 1e-9) / STEP))
  }

  /**
   * Draw what a vehicle did, if there was one. What draws it is loaded then.
   *
   * @param {string[]} drive
   */
  async drive(drive) {
    this.#drive = drive
    this.driven.replaceChildren()
    if (!drive.length) return
    const { drawDrive } = await import("./drive.js")
    if (this.#drive === drive) this.driven.replaceChildren(drawDrive(drive) ?? "")
  }

  /** @param {Tick[]} ticks */
  add(ticks) {
    if (!ticks.length) return
    this.#count += ticks.length
    this.#ticks.push(...ticks)
    this.#ticks.splice(0, this.#ticks.length - SHOWN.ticks)
    this.#painter.soon()
  }

  /**
   * Draw the last ticks of a run that has ended, at `end` (s), which are known in full; there were `count`.
   * `alternative` says what they show.
   *
   * @param {Tick[]} ticks
   * @param {number} count
   * @param {string} alternative
   * @param {number[][]} chunks
   * @param {number} end
   * @param {Lost[]} lost
   */
  finish(ticks, count, alternative, chunks, end = 0, lost = []) {
    this.clear()
    this.#ticks = ticks
    this.#count = count
    this.#chunks = chunks
    this.#paint(`Timeline. ${alternative}`, end, lost)
    this.#offer()
  }

  /** Of a run that was stopped, what came before. */
  stop() {
    if (this.#ticks.length) this.finish(this.#ticks, this.#count, "The run was stopped.", [])
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
    const lateness = late > 0 ? `${inSeconds(late)} late` : late < 0 ? `${inSeconds(-late)} early` : "on time"
    return `${source}, tick ${number}: expected ${inSeconds(expected)}, real ${inSeconds(real)}, ${lateness}`
  }

  /**
   * @param {string} alternative
   * @param {number} end
   * @param {Lost[]} lost
   */
  #paint(alternative, end = 0, lost = []) {
    const { rows, scale, places } = layOut(this.#ticks, end, lost)
    this.#places = places
    const count = rows.length
    rows.splice(MOST_ROWS)
    const shown = drawn(rows)
    const told = [
      "simulated: this clock has no jitter, at any speed",
      shown < this.#count && `${say(shown)} of ${say(this.#count)} ticks drawn`,
      count > MOST_ROWS && `${say(MOST_ROWS)} of ${say(count)} rows`,
    ]
    const caption = make("figcaption", { textContent: told.filter(Boolean).join("; ") })
    this.element.replaceChildren(drawTimeline(rows, scale, alternative), caption)
    this.element.hidden = false
  }
}
