// What a run prints and when it ticks, gathered, so that a flood does not drown the page.

import { PER_SECOND, room, SHOWN } from "./limits.js"

// It is sent so often (ms), or less often, so that it takes no more than that part of the room there is.
const INTERVAL = 50
const PART = 0.5

/** @typedef {import("./protocol.js").Shown} Shown */

/**
 * What a node sees of the page.
 *
 * @implements {Shown}
 */
export class Page {
  /** @type {import("./protocol.js").Chunk[]} */
  #chunks = []
  #count = 0
  #size = 0
  #leftOut = 0 // lines
  #cut = false // whether anything is left out
  /** @type {import("./protocol.js").Tick[]} */
  #ticks = []
  #next = 0 // when (ms) more may be sent
  /** @type {number | undefined} */
  #timer
  #say

  /** @param {(message: import("./protocol.js").Batch) => string} say says it, and returns it as text */
  constructor(say) {
    this.#say = say
  }

  /**
   * @param {string} text
   * @param {boolean} isError
   * @param {number} line
   */
  print(text, isError, line) {
    const number = this.#count++
    if (!text) return
    const most = SHOWN.characters
    if (text.length > most) this.#leaveOut(text.slice(0, -most))
    this.#chunks.push([isError, text.slice(-most), number, line])
    this.#size += Math.min(text.length, most)
    while (this.#size > most || this.#chunks.length > SHOWN.chunks) {
      const first = this.#chunks[0]
      const dropped = first[1].slice(0, this.#chunks.length > SHOWN.chunks ? Infinity : this.#size - most)
      if (dropped.length < first[1].length) first[1] = first[1].slice(dropped.length)
      else this.#chunks.shift()
      this.#size -= dropped.length
      this.#leaveOut(dropped)
    }
    this.#soon()
  }

  /** @param {string} text */
  #leaveOut(text) {
    this.#leftOut += lines(text)
    this.#cut = true
  }

  /**
   * @param {string} source
   * @param {number} number
   * @param {number} expected
   * @param {number} real
   */
  tick(source, number, expected, real) {
    this.#ticks.push([source, number, expected, real, 0])
    if (this.#ticks.length >= 2 * SHOWN.ticks) this.#ticks.splice(0, SHOWN.ticks)
    this.#soon()
  }

  /**
   * @param {number} ms
   * @returns {Promise<void>}
   */
  wait(ms) {
    return new Promise((resolve) => setTimeout(resolve, ms))
  }

  /** How long (ms) until what is gathered may be sent; Infinity: nothing is. */
  get due() {
    return this.#chunks.length || this.#ticks.length ? this.#next - performance.now() : Infinity
  }

  #soon() {
    const left = this.#next - performance.now()
    if (left <= 0) this.send()
    else this.#timer ??= setTimeout(() => this.send(), left)
  }

  send() {
    clearTimeout(this.#timer)
    this.#timer = undefined
    if (this.#chunks.length || this.#ticks.length) {
      const ticks = this.#ticks.slice(-SHOWN.ticks)
      const leftOut = Math.max(this.#leftOut, Number(this.#cut)) // part of a line counts if there is no more
      const text = this.#say({ kind: "batch", chunks: this.#chunks, leftOut, ticks })
      this.#next = performance.now() + Math.max(INTERVAL, (room(text, "run") / PER_SECOND / PART) * 1e3)
    }
    this.#chunks = []
    this.#size = this.#leftOut = 0
    this.#cut = false
    this.#ticks = []
  }
}

/**
 * How many lines end in a text.
 *
 * @param {string} text
 */
function lines(text) {
  let count = 0
  for (let end = text.indexOf("\n"); end >= 0; end = text.indexOf("\n", end + 1)) count++
  return count
}
