// What the teachers' page knows: who has handed in what, which of a student's files counts, and what was said of each
// answer. What of it is seen is in judge.js.

import { read } from "./answers.js"
import { STOPPED } from "./judging.js"
import { code, numberOf } from "./names.js"

/** Of these it is said how many there are, where there are any. */
export const NOT_JUDGED = /** @type {const} */ (["to read", "not judged", "stopped"])

/** The table has room for so much: files that count, answers in all, exercises. */
const MOST = { rows: 1000, answers: 10_000, exercises: 100 }

const FULL =
  `this table has room for ${MOST.rows} files, ${MOST.answers} answers and ${MOST.exercises} exercises; ` +
  "rosspin judge, on your computer, takes more"

/** So many files are taken into the table at a time. */
const PIECE = 25

/** Of the names that are beside a row so many are said. */
const MOST_NAMES = 5

/**
 * @typedef {import("./judging.js").Found | "waiting" | "being judged"} Verdict
 * @typedef {(exercise: string, text: string, stopped: AbortSignal) => Promise<import("./judging.js").Judgement>} Judge
 */

/** A row of the table: what one student has handed in. */
class HandIn {
  /** @param {import("./answers.js").Answers} found */
  constructor({ file, name, student, id, date, answers }) {
    this.file = file
    this.name = name
    this.student = student
    this.id = id
    this.date = date ? local(date) : ""
    this.time = date?.getTime() ?? 0
    this.source = [this.date, file].filter(Boolean).join(", ")
    this.answers = new Map(answers.map(([exercise, text]) => [exercise, new Answer(this, exercise, text)]))
  }

  get solved() {
    return [...this.answers.values()].filter(({ verdict }) => verdict === "solved").length
  }
}

/** A time as in "2026-11-21 22:05", where the reader is. */
const local = (/** @type {Date} */ date) => date.toLocaleString("sv", { dateStyle: "short", timeStyle: "short" })

/** An answer and its verdict. */
export class Answer {
  /** @type {Verdict} */
  verdict = "waiting"
  said = ""
  hint = ""

  /**
   * @param {HandIn} row
   * @param {string} exercise
   * @param {string} text
   */
  constructor(row, exercise, text) {
    this.row = row
    this.exercise = exercise
    this.text = text
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

/** Some of these names, and how many more there are. */
const few = (/** @type {string[]} */ names) =>
  names.length > MOST_NAMES ? [...names.slice(0, MOST_NAMES), `${names.length - MOST_NAMES} more`] : names

/** All that was handed in. */
export class Table {
  /** @type {HandIn[]} */
  rows = []

  /** @type {{file: string, why: string}[]} */
  refused = []

  /** By what the rows are ordered, and whether the last comes first. */
  order = { by: "name", isDown: false }

  /** Whether all that is known is in the text that was saved last. */
  isSaved = true

  /** @type {Answer[]} */
  #waiting = []
  #lanes = 0
  #judging = 0 // answers
  #count = 0 // of answers
  #names = new Set() // of the exercises, those of files too whose place was taken
  #stop = new AbortController()
  #judge
  #most
  #changed

  /**
   * @param {Judge} judge
   * @param {number} most how many answers are judged at the same time
   * @param {(answer: Answer | null) => void} changed is called when an answer has another verdict; with null, when there
   *   are other rows
   */
  constructor(judge, most, changed) {
    this.#judge = judge
    this.#most = most
    this.#changed = changed
  }

  /**
   * Read files, and have the answers judged that count: what is to be said of those that do not, in sentences.
   *
   * @param {import("./unpack.js").Dropped[]} files
   * @param {(count: number) => void} [progress] is called with how many have been read
   */
  async add(files, progress = () => {}) {
    // All are read first: while one is being read, others are judged, which looks at the rows.
    /** @type {(import("./answers.js").Answers | string)[]} */
    const contents = []
    for (const file of files) {
      contents.push("why" in file ? file.why : await read(file).catch((error) => error.message))
      progress(contents.length)
    }
    const problems = []
    for (const [number, found] of contents.entries()) {
      if (number % PIECE === PIECE - 1) await new Promise((go) => setTimeout(go)) // the reader may have something to click
      problems.push(typeof found === "string" ? this.#refuse(files[number].name, found) : this.#take(new HandIn(found)))
    }
    this.#sort()
    this.isSaved = false
    this.#changed(null)
    while (this.#lanes < this.#most && this.#waiting.length) this.#work()
    return problems.filter((said) => said !== "")
  }

  #sort() {
    const { by, isDown } = this.order
    const rank = (/** @type {HandIn} */ row) => {
      if (by === "name") return 0
      if (by === "solved") return row.solved
      const verdict = row.answers.get(by)?.verdict
      return verdict === "solved" ? 2 : verdict ? 1 : 0
    }
    const byName = (/** @type {HandIn} */ one, /** @type {HandIn} */ other) =>
      one.name.localeCompare(other.name, undefined, { numeric: true })
    const sign = isDown ? -1 : 1
    this.rows.sort((one, other) => sign * (rank(one) - rank(other) || (by === "name" ? byName(one, other) : 0)) || byName(one, other))
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

  /**
   * @param {string} file
   * @param {string} why
   */
  #refuse(file, why) {
    this.refused.push({ file, why })
    return `${file} is refused: ${why}.`
  }

  /**
   * Of one student's files the newest counts.
   *
   * @param {HandIn} row
   */
  #take(row) {
    const before = this.rows.find(({ name, id }) => name === row.name && id === row.id)
    if (before && before.time > row.time) return `${row.file} is left out: ${row.name} handed in ${before.file} after it.`
    const count = this.#count - (before?.answers.size ?? 0) + row.answers.size
    const names = new Set([...this.#names, ...row.answers.keys()])
    const isFull = (!before && this.rows.length >= MOST.rows) || count > MOST.answers || names.size > MOST.exercises
    if (isFull) return this.#refuse(row.file, FULL)
    this.#count = count
    this.#names = names
    if (before) {
      this.rows = this.rows.filter((other) => other !== before)
      this.#waiting = this.#waiting.filter((answer) => answer.row !== before)
    }
    this.rows.push(row)
    this.#waiting.push(...row.answers.values())
    return before ? `${row.file} takes the place of ${before.file}, which ${row.name} handed in before.` : ""
  }

  /** Judge what waits, one answer after the other. */
  async #work() {
    this.#lanes++
    for (let answer = this.#waiting.shift(); answer; answer = this.#waiting.shift()) {
      this.#judging++
      this.#become(answer, { verdict: "being judged", said: "" })
      const found = await this.#judge(answer.exercise, code(answer.text), this.#stop.signal)
      this.#judging--
      this.isSaved = false
      this.#become(answer, found)
    }
    this.#lanes--
  }

  /**
   * @param {Answer} answer
   * @param {{verdict: Verdict, said: string, hint?: string}} found
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

  /** The exercises that somebody has answered. */
  get exercises() {
    const place = (/** @type {string} */ name) => EXERCISES[name]?.number ?? Infinity
    const names = new Set(this.answers.map(({ exercise }) => exercise))
    return [...names].sort((one, other) => place(one) - place(other) || one.localeCompare(other))
  }

  /**
   * The exercises that were judged and not solved by all, the hardest first: how many answered, how many solved it, and
   * what those were told whose answer is wrong, by how many.
   */
  get hard() {
    const found = this.exercises.map((exercise) => {
      const judged = this.answers.filter((answer) => answer.exercise === exercise && !answer.isOpen)
      /** @type {Map<string, number>} */
      const hints = new Map()
      for (const { hint } of judged) if (hint) hints.set(hint, (hints.get(hint) ?? 0) + 1)
      const solved = judged.filter(({ verdict }) => verdict === "solved").length
      return { exercise, answered: judged.length, solved, hints: [...hints].sort(([, one], [, other]) => other - one) }
    })
    const missed = found.filter(({ answered, solved }) => solved < answered)
    return missed.sort((one, other) => one.solved / one.answered - other.solved / other.answered)
  }

  /**
   * Other names under which answers from the same browser were handed in.
   *
   * @param {HandIn} row
   */
  others(row) {
    return few(this.rows.filter(({ id, name }) => id === row.id && name !== row.name).map(({ name }) => name))
  }

  /**
   * The files that were handed in under this name from other browsers.
   *
   * @param {HandIn} row
   */
  namesakes(row) {
    return few(this.rows.filter(({ id, name }) => id !== row.id && name === row.name).map(({ file }) => file))
  }

  /** How far it is, and in the end how many answers were judged, and how many were not. */
  get said() {
    const { answers } = this
    if (answers.some(({ isOpen }) => isOpen)) return `Judging the answers of ${count(this.rows.length, "file")}`
    const kinds = NOT_JUDGED.map((kind) => ({ kind, number: answers.filter(({ verdict }) => verdict === kind).length }))
    const judged = kinds.reduce((left, { number }) => left - number, answers.length)
    const said = [{ kind: "judged", number: judged }, ...kinds.filter(({ number }) => number)]
    const outcome = `Done: ${said.map(({ kind, number }) => `${number} ${kind}`).join(", ")}`
    return this.refused.length ? `${outcome}; ${count(this.refused.length, "file")} refused` : outcome
  }

  /**
   * The table as rows of cells, to be saved.
   *
   * @param {(exercise: string) => string} title of an exercise
   * @returns {(string | number)[][]}
   */
  save(title) {
    const { exercises } = this
    const marks = ["same browser as", "same name in another browser"]
    const head = ["name", "student ID", "file", "note", "date", ...marks, "answers", "solved", ...exercises.map((name) => title(name))]
    this.isSaved = true
    return [
      head,
      ...this.rows.map((row) => {
        const { name, student, file, date, solved, answers } = row
        const verdicts = exercises.map((name) => answers.get(name)?.verdict ?? "")
        const [others, namesakes] = [this.others(row), this.namesakes(row)].map((list) => list.join(", "))
        return [name, student, file, "", date, others, namesakes, answers.size, solved, ...verdicts]
      }),
      ...this.refused.map(({ file, why }) => head.map((_, number) => ["", "", file, `refused: ${why}`][number] ?? "")),
    ]
  }
}
