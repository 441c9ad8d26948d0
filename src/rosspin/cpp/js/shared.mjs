// What a program and its host share in the program's memory (see rosspin_shared in runtime/host.cpp).

const NOW = 0
const AHEAD = 8
const HORIZON = 16
const URGENT = 24
const LOOKS = 28
const TICKS = 32
const WAITING = 36
const FIRST = 40
const REAL = 48
const FAULT = 56
const DIVIDES = 60
const TICK = 64

const PLACE = 12 // bytes, of a file, a line and a column
const LONGEST = 1_000 // name of a file

const SIZE = 32 // of a tick: source, number (int32), expected, real, duration (int64)

export class Shared {
  constructor(exports) {
    this.memory = exports.memory
    this.at = exports.rosspin_shared.value
  }

  get #view() {
    if (this.dataView?.buffer !== this.memory.buffer) this.dataView = new DataView(this.memory.buffer, this.at)
    return this.dataView
  }

  get now() {
    return this.#view.getBigInt64(NOW, true)
  }

  set now(time) {
    this.#view.setBigInt64(NOW, time, true)
  }

  get ahead() {
    return this.#view.getBigInt64(AHEAD, true)
  }

  set ahead(time) {
    this.#view.setBigInt64(AHEAD, time, true)
  }

  get horizon() {
    return this.#view.getBigInt64(HORIZON, true)
  }

  set horizon(time) {
    this.#view.setBigInt64(HORIZON, time, true)
  }

  get urgent() {
    return this.#view.getInt32(URGENT, true) !== 0
  }

  set urgent(is) {
    this.#view.setInt32(URGENT, is ? 1 : 0, true)
  }

  /** @param {boolean} is whether time passes by itself */
  set real(is) {
    this.#view.setBigInt64(REAL, is ? 1n : 0n, true)
  }

  get looks() {
    return this.#view.getInt32(LOOKS, true)
  }

  set looks(count) {
    this.#view.setInt32(LOOKS, count, true)
  }

  /** How many callbacks wait for someone to spin; -1: someone does, or has. */
  get waiting() {
    return this.#view.getInt32(WAITING, true)
  }

  /**
   * What has ended it: the file, the line, and whether it `divides` by zero; undefined if that is not known. The program
   * may have written anything there.
   */
  get fault() {
    const place = this.#view.getUint32(FAULT, true)
    const bytes = new Uint8Array(this.memory.buffer)
    if (!place || place + PLACE > bytes.length) return undefined
    const view = new DataView(bytes.buffer, place)
    const file = view.getUint32(0, true)
    const [name] = new TextDecoder().decode(bytes.subarray(file, file + LONGEST)).split("\0")
    return { file: name, line: view.getUint32(4, true), divides: this.#view.getInt32(DIVIDES, true) === 1 }
  }

  /** Take the ticks that were not told yet, as bytes; undefined if there are none. */
  takeTicks() {
    const count = this.#view.getInt32(TICKS, true)
    if (!count) return undefined
    this.#view.setInt32(TICKS, 0, true)
    this.#view.setBigInt64(FIRST, this.#view.getBigInt64(FIRST, true) + BigInt(count), true)
    return new Uint8Array(this.memory.buffer).slice(this.at + TICK, this.at + TICK + count * SIZE)
  }
}
