// The ticks of a run as they come, in the look of the site's figures: a line where a tick was expected, a dot where it
// came, a bar for how long it took.

import { COLOURS, draw } from "./svg.js"

const WIDTH = 331
const ROW = 29
const MOST_TICKS = 2000

/** A mark for a tick: a dot in the first row, a square in the second, a triangle in the third. */
function mark(row, x, y) {
  const fill = COLOURS[row % COLOURS.length]
  const shape = row % COLOURS.length
  if (shape === 1) return draw("rect", { x: x - 2, y: y - 2, width: 4, height: 4, fill })
  if (shape === 2) return draw("path", { d: `M${x} ${y - 2.6}l2.6 4.6h-5.2z`, fill })
  return draw("circle", { cx: x, cy: y, r: 2.2, fill })
}

/** The step between the numbers on an axis of that length: 1, 2 or 5 times a power of ten, 4 to 10 of them. */
function step(length) {
  const power = 10 ** Math.floor(Math.log10(length / 4))
  return [5, 2, 1].map((factor) => factor * power).find((size) => length / size >= 4)
}

/** A time in seconds. */
const say = (time) => `${Number(time.toFixed(6))} s`

export class Plot {
  #ticks = []
  #frame = 0
  #chunks = [] // of each tick: what it printed
  #places = [] // of each tick: where its mark is
  #chosen = -1
  #name
  #choose

  /** `choose(chunks)` is called with what a tick printed when the reader points at it; with none when no longer. */
  constructor(name, choose) {
    this.#name = name
    this.#choose = choose
    this.element = document.createElement("figure")
    this.element.className = "rosspin-plot"
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

  /** Draw the ticks of a run that has ended, which are now known in full; `alternative` says what they show. */
  finish(ticks, alternative, chunks) {
    this.clear()
    this.#ticks = ticks
    this.#chunks = chunks
    this.#paint(`Timeline. ${alternative}`)
    this.#offer()
  }

  /** Let the reader choose a tick: by pointing at it, or like a slider, with the arrow keys. */
  #offer() {
    const picture = this.element.querySelector("svg")
    const ring = draw("circle", { r: 5.5, fill: "none", stroke: "currentColor", "stroke-width": 1.2 })
    const handle = document.createElement("div")
    handle.className = "live-handle"
    handle.tabIndex = 0
    handle.role = "slider"
    handle.ariaLabel = this.#name
    handle.ariaValueMin = 1
    handle.ariaValueMax = this.#ticks.length
    const said = document.createElement("p")
    said.className = "live-tick"
    said.ariaHidden = "true" // it is the handle's value

    const show = (index) => {
      this.#chosen = index
      ring.remove()
      const text = index < 0 ? "Point at a tick, or use the arrow keys here." : this.#describe(index)
      said.textContent = handle.ariaValueText = text
      handle.ariaValueNow = Math.max(index + 1, 1)
      if (index >= 0) {
        const [x, y] = this.#places[index]
        ring.setAttribute("cx", x)
        ring.setAttribute("cy", y)
        picture.append(ring)
      }
      this.#choose(this.#chunks[index] ?? [])
    }
    const point = (event) => {
      const { left, top, width } = picture.getBoundingClientRect()
      const scale = WIDTH / width
      const [x, y] = [(event.clientX - left) * scale, (event.clientY - top) * scale]
      const distances = this.#places.map((place) => Math.hypot(place[0] - x, place[1] - y))
      const nearest = distances.indexOf(Math.min(...distances))
      if (nearest !== this.#chosen) show(nearest)
    }
    handle.addEventListener("pointermove", point)
    handle.addEventListener("pointerdown", point)
    handle.addEventListener("pointerleave", () => document.activeElement !== handle && show(-1))
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
    const stage = document.createElement("div")
    stage.className = "live-stage"
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

  #paint(alternative) {
    const sources = [...new Set(this.#ticks.map(([source]) => source))]
    const left = 14 + 5.4 * Math.max(...sources.map((source) => source.length))
    const bottom = ROW * sources.length + 4
    const first = this.#ticks[0][1] === 1 ? 0 : Math.min(...this.#ticks.map(([, , expected]) => expected))
    const last = Math.max(first + 1, ...this.#ticks.map(([, , expected, real, duration]) => Math.max(expected, real + duration)))
    const x = (time) => (left + ((time - first) / (last - first)) * (WIDTH - left - 10)).toFixed(2)

    const axis = draw("g", { stroke: "currentColor", "stroke-width": 0.6 })
    axis.append(draw("path", { d: `M${x(first)} ${bottom}H${WIDTH - 4}` }))
    const texts = draw("g", { fill: "currentColor", "font-size": 10, "text-anchor": "middle" })
    const size = step(last - first)
    for (let n = Math.ceil(first / size); n * size <= last + 1e-9; n++) {
      axis.append(draw("path", { d: `M${x(n * size)} ${bottom}v3.5` }))
      texts.append(draw("text", { x: x(n * size), y: bottom + 14 }, String(Number((n * size).toPrecision(12)))))
    }
    texts.append(draw("text", { x: (left + WIDTH) / 2, y: bottom + 28 }, "time (s); line: expected, mark: real"))

    const grid = draw("g", { stroke: "currentColor", "stroke-width": 0.8, "stroke-opacity": 0.55 })
    const bars = draw("g", { "fill-opacity": 0.45 })
    const marks = draw("g", {})
    sources.forEach((source, row) => {
      texts.append(draw("text", { x: left - 8, y: ROW * (row + 0.5) + 3.5, "text-anchor": "end" }, source))
    })
    const latest = new Map()
    this.#places = []
    for (const [source, , expected, real, duration] of this.#ticks) {
      const row = sources.indexOf(source)
      const y = ROW * (row + 0.5)
      grid.append(draw("path", { d: `M${x(expected)} ${y - 11}v22` }))
      if (duration > 0) {
        const width = (x(real + duration) - x(real)).toFixed(2)
        bars.append(draw("rect", { x: x(real), y: y - 4.5, width, height: 9, fill: COLOURS[row % COLOURS.length] }))
      }
      // Ticks at the same time are drawn one above the other.
      const together = real - (latest.get(source) ?? -1) < 1e-3
      latest.set(source, real)
      const place = [Number(x(real)), together ? y - 7 : y]
      this.#places.push(place)
      marks.append(mark(row, ...place))
    }
    const picture = draw("svg", { viewBox: `0 0 ${WIDTH} ${bottom + 34}`, role: "img", "aria-label": alternative })
    picture.append(grid, bars, marks, axis, texts)
    const caption = document.createElement("figcaption")
    caption.textContent = "simulated: this clock has no jitter, at whichever speed it runs"
    this.element.replaceChildren(picture, caption)
    this.element.hidden = false
  }
}
