// What the teachers' page knows: who has handed in what, as Python has read it, and what was said of each answer. What of
// it is seen is in judge.js.

import { STOPPED } from "./judging.js"
import { numberOf } from "./names.js"

/** Of these it is said how many there are, where there are any. */
export const NOT_JUDGED = /** @type {const} */ (["to read", "not judged", "stopped"])

/**
 * @typedef {import("./judging.js").Found | "waiting" | "being judged"} Verdict
 * @typedef {(exercise: string, text: string, stopped: AbortSignal) => Promise<import("./judging.js").Judgement>} Judge
 * @typedef {import("./protocol.js").HandIn} Read a row as Python has read it
 * @typedef {<K extends "read" | "answer" | "report">(job: Extract<import("./protocol.js").Job, {kind: K}>) =>
 *   Promise<import("./protocol.js").Results[K]>} Ask
 */

/** A row of the table: what one student has handed in. */
class HandIn {
  /**
   * @param {Read} read
   * @param {string[]} exercises
   */
  constructor({ number, name, student, file, date, note, late, answers }, exercises) {
    this.number = number
    this.name = name
    this.student = student
    this.note = [late && "late", note].filter(Boolean).join("; ")
    this.source = [date, file].filter(Boolean).join(", ")
    this.answers = new Map(answers.map((place) => [exercises[place], new Answer(this, exercises[place])]))
    this.place = 0 // in the order of the names
    /** @type {string[]} */
    this.others = []
    /** @type {string[]} */
    this.namesakes = []
  }

  get solved() {
    return [...this.answers.values()].filter(({ verdict }) => verdict === "solved").length
  }
}

/** An answer and its verdict. */
export class Answer {
  /** @type {Verdict} */
  verdict = "waiting"
  said = ""
  why = ""
  hint = ""
  /** @type {number | null} */
  off = null

  /**
   * @param {HandIn} row
   * @param {string} exercise
   */
  constructor(row, exercise) {
    this.row = row
    this.exercise = exercise
  }

  get title() {
    return `${this.row.name}, exercise ${numberOf(this.exercise)}: ${this.verdict}`
  }

  get isOpen() {
    return this.verdict === "waiting" || this.verdict === "being judged"
  }
}

export const count = (/** @type {number} */ number, /** @type {string} */ what) =>
  `${number} ${what}${number === 1 ? "" : "s"}`

/** All that was handed in. */
export class Table {
  /** @type {HandIn[]} */
  rows = []

  /** The exercises that have been answered, in their order. @type {string[]} */
  exercises = []

  /** What should be said of files that were refused or left out, how many more such sentences there are, and files. */
  problems = /** @type {string[]} */ ([])
  unlisted = 0
  refused = 0

  /** By what the rows are ordered, and whether the last comes first. */
  order = { by: "name", isDown: false }

  /** Whether all that is known is in the text that was saved last. */
  isSaved = true

  /** @type {Answer[]} */
  #waiting = []
  #workers = 0
  #judging = 0 // answers
  #stop = new AbortController()
  #ask
  #judge
  #most
  #changed

  /**
   * @param {Ask} ask
   * @param {Judge} judge
   * @param {number} most how many answers are judged at the same time
   * @param {(answer: Answer | null) => void} changed is called when an answer has another verdict; with null, when there
   *   are other rows
   */
  constructor(ask, judge, most, changed) {
    this.#ask = ask
    this.#judge = judge
    this.#most = most
    this.#changed = changed
  }

  /**
   * Read files, and have the answers judged that are new. Error: nothing could be read.
   *
   * @param {import("./dropped.js").Dropped[]} files
   */
  async add(files) {
    const { rows, exercises, problems, unlisted, refused } = await this.#ask({ kind: "read", files })
    Object.assign(this, { exercises, problems, unlisted, refused })
    const before = new Map(this.rows.map((row) => [row.number, row]))
    this.rows = rows.map((read, place) => {
      const { others, namesakes } = read
      return Object.assign(before.get(read.number) ?? new HandIn(read, exercises), { place, others, namesakes })
    })
    const now = new Set(this.rows)
    this.#waiting = this.#waiting.filter(({ row }) => now.has(row))
    this.#waiting.push(...this.rows.filter(({ number }) => !before.has(number)).flatMap(({ answers }) => [...answers.values()]))
    this.#sort()
    this.isSaved = false
    this.#changed(null)
    while (this.#workers < this.#most && this.#waiting.length) this.#work()
  }

  #sort() {
    const { by, isDown } = this.order
    const rank = (/** @type {HandIn} */ row) => {
      if (by === "name") return row.place
      if (by === "solved") return row.solved
      const verdict = row.answers.get(by)?.verdict
      return verdict === "solved" ? 2 : verdict ? 1 : 0
    }
    const sign = isDown ? -1 : 1
    this.rows.sort((one, other) => sign * (rank(one) - rank(other)) || one.place - other.place)
  }

  /**
   * Bring the rows into the order of their names, of how many are solved, or of an exercise; again, the other way.
   *
   * @param {string} by "name", "solved", or the name of an exercise
   */
  sort(by) {
    this.order = { by, isDown: this.order.by === by ? !this.order.isDown : by === "solved" }
    this.#sort()
    this.#changed(null)
  }

  /** Judge what waits, one answer after the other. */
  async #work() {
    this.#workers++
    for (let answer = this.#waiting.shift(); answer; answer = this.#waiting.shift()) {
      this.#judging++
      this.#become(answer, { verdict: "being judged", said: "" })
      const found = await this.#verdict(answer, this.#stop.signal)
      this.#judging--
      this.isSaved = false
      this.#become(answer, found)
    }
    this.#workers--
  }

  /**
   * @param {Answer} answer
   * @param {AbortSignal} stopped
   * @returns {Promise<import("./judging.js").Judgement>}
   */
  async #verdict(answer, stopped) {
    try {
      const { text, why } = await this.text(answer)
      return why ? { verdict: "not judged", said: why } : await this.#judge(answer.exercise, text, stopped)
    } catch (error) {
      return { verdict: "not judged", said: String(error) }
    }
  }

  /**
   * The text of an answer, and why it cannot be judged; "" if it can.
   *
   * @param {Answer} answer
   */
  text({ row: { number }, exercise }) {
    return this.#ask({ kind: "answer", number, exercise })
  }

  /**
   * @param {Answer} answer
   * @param {{verdict: Verdict, said: string, why?: string, hint?: string, off?: number | null}} found
   */
  #become(answer, found) {
    Object.assign(answer, found)
    this.#changed(answer)
  }

  /** End what is being judged and what waits. */
  stop() {
    for (const answer of this.#waiting.splice(0)) this.#become(answer, STOPPED)
    this.#stop.abort()
    this.#stop = new AbortController()
  }

  // --- what there is to say ---

  /** Whether nothing is left to be judged. */
  get isDone() {
    return !this.#waiting.length && !this.#judging
  }

  get answers() {
    return this.rows.flatMap(({ answers }) => [...answers.values()])
  }

  /** How far it is, and in the end how many answers were judged, and how many were not. */
  get said() {
    const { answers } = this
    if (answers.some(({ isOpen }) => isOpen)) return `Judging the answers of ${count(this.rows.length, "file")}`
    const kinds = NOT_JUDGED.map((kind) => ({ kind, number: answers.filter(({ verdict }) => verdict === kind).length }))
    const judged = kinds.reduce((left, { number }) => left - number, answers.length)
    const said = [{ kind: "judged", number: judged }, ...kinds.filter(({ number }) => number)]
    const outcome = `Done: ${said.map(({ kind, number }) => `${number} ${kind}`).join(", ")}`
    return this.refused ? `${outcome}; ${count(this.refused, "file")} refused` : outcome
  }

  /** What came of all answers that have been judged: a table to be saved, and what was hard. */
  report() {
    const verdicts = this.answers
      .filter(({ isOpen }) => !isOpen)
      .map(({ row, exercise, verdict, why, hint, off }) => /** @type {const} */ ([row.number, exercise, verdict, why, hint, off]))
    return this.#ask({ kind: "report", verdicts })
  }
}
