// The ticks of a run as they come, in the look of the site's figures.

import { make } from "./make.js"
import { MARGIN, draw, drawTimeline, heights, percent } from "./svg.js"

const MOST_TICKS = 2000

/** A time in seconds. */
const say = (time) => `${Number(time.toFixed(6))} s`

export class Plot {
  #ticks = []
  #frame = 0
  #chunks = [] // of each tick: what it printed
  #places = [] // of each tick: where its mark is, across as a share and down in pixels
  #chosen = -1
  #name
  #choose

  /** `choose(chunks)` is called with what a tick printed when the reader points at it; with none when no longer. */
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

  /** Add ticks, each [source, number, expected, real, duration] in seconds. */
  add(ticks) {
    if (!ticks.length) return
    this.#ticks.push(...ticks.slice(-MOST_TICKS))
    this.#ticks.splice(0, this.#ticks.length - MOST_TICKS)
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0
      this.#paint("Timeline of a run that goes on.")
    })
  }

  /** Draw the ticks of a run that has ended, at `end` (s), and are known in full; `alternative` says what they show. */
  finish(ticks, alternative, chunks, end = 0) {
    this.clear()
    this.#ticks = ticks
    this.#chunks = chunks
    this.#paint(`Timeline. ${alternative}`, end)
    this.#offer()
  }

  /** Of a run that was stopped, what came before. */
  stop() {
    if (this.#ticks.length) this.finish(this.#ticks, "The run was stopped.", [])
  }

  /** Let the reader choose a tick: by pointing at it, or like a slider, with the arrow keys. */
  #offer() {
    const picture = this.element.querySelector("svg")
    const ring = draw("circle", { r: 5.5, fill: "none", stroke: "currentColor", "stroke-width": 1.2 })
    const properties = { className: "live-handle", tabIndex: 0, role: "slider", ariaLabel: this.#name }
    const handle = make("div", { ...properties, ariaValueMin: 1, ariaValueMax: this.#ticks.length })
    const said = make("p", { className: "live-tick", ariaHidden: "true" }) // it is the handle's value

    const show = (index) => {
      this.#chosen = index
      ring.remove()
      const text = index < 0 ? "Choose a tick: point at it, or use the arrow keys here." : this.#describe(index)
      said.textContent = handle.ariaValueText = text
      handle.ariaValueNow = Math.max(index + 1, 1)
      if (index >= 0) {
        const [share, y] = this.#places[index]
        ring.setAttribute("cx", percent(100 * share))
        ring.setAttribute("cy", y)
        picture.lastChild.append(ring)
      }
      this.#choose(this.#chunks[index] ?? [])
    }
    const point = (event) => {
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

  /** A tick in words. */
  #describe(index) {
    const [source, number, expected, real] = this.#ticks[index]
    const late = Number((real - expected).toFixed(6))
    const lateness = late > 0 ? `${say(late)} late` : late < 0 ? `${say(-late)} early` : "on time"
    return `${source}, tick ${number}: expected ${say(expected)}, real ${say(real)}, ${lateness}`
  }

  #paint(alternative, end = 0) {
    const known = this.#ticks.map(([, , expected, real, duration]) => [expected, real, Math.max(duration, 0)])
    const first = this.#ticks[0][1] === 1 ? 0 : Math.min(...known.map(([expected]) => expected))
    const last = Math.max(end, ...known.map(([expected, real, duration]) => Math.max(expected, real + duration)))
    const scale = { first, span: last - first || 1, kinds: 3, title: "time (s); line: expected, mark: real" }

    const numbers = new Map() // of the rows
    const rows = []
    this.#ticks.forEach(([source], index) => {
      if (!numbers.has(source)) numbers.set(source, rows.push([source, "", [], [], []]) - 1)
      const [, , grid, , ticks] = rows[numbers.get(source)]
      const [expected, real, duration] = known[index]
      if (!grid.includes(expected)) grid.push(expected)
      ticks.push([real, duration])
    })
    const places = rows.map(([, , , , ticks], number) =>
      heights(number, ticks).map((height, index) => [(ticks[index][0] - first) / scale.span, height]),
    )
    this.#places = this.#ticks.map(([source]) => places[numbers.get(source)].shift())

    const textContent = "simulated: this clock has no jitter, at whichever speed it runs"
    const caption = make("figcaption", { textContent })
    this.element.replaceChildren(drawTimeline(rows, scale, alternative), caption)
    this.element.hidden = false
  }
}
