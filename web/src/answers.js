// The file in which a student hands in answers: JSON with a name, a date and the texts. What else it says is not read.

import { valuesIn } from "./limits.js"
import { nameOf } from "./names.js"

const FORMAT = "rosspin-answers"
const VERSION = 2

/** The name of an exercise, or in files of version 1 its old number. */
const NAME = new Map([
  [1, /^[1-9]\d{0,2}$/],
  [2, /^[a-z0-9]+(-[a-z0-9]+)*$/],
])

/** What is read at most: of a file (bytes), of an answer and a name (characters), and so many answers, of such JSON. */
export const MOST = { file: 1_000_000, answer: 50_000, name: 100, answers: 100 }
const VALUES = 10_000

/**
 * What such a file holds.
 *
 * @typedef {{file: string, name: string, student: string, id: string, date: Date | null,
 *   answers: [exercise: string, text: string][]}} Answers
 */

/**
 * The text of such a file, made now.
 *
 * @param {string} name
 * @param {string} id what tells students of the same name apart
 * @param {Record<string, string>} answers name of the exercise -> text
 * @param {string} student ID, if the student gives one
 */
export function write(name, id, answers, student = "") {
  const date = new Date().toISOString()
  const known = student ? { name, student } : { name }
  return JSON.stringify({ format: FORMAT, version: VERSION, ...known, id, date, answers }, null, 1)
}

/**
 * What a file holds. The message of an Error says why it is refused.
 *
 * @param {File} file
 * @returns {Promise<Answers>}
 */
export async function read(file) {
  /** @type {(why: string) => never} */
  const refuse = (why) => {
    throw new Error(why)
  }
  const start = await file.slice(0, 4).text().catch(() => refuse("it cannot be read"))
  if (start === "PK\x03\x04") refuse("it is a zip archive; unpack it first") // which unpack.js did if it could
  if (file.size > MOST.file) refuse(`it is ${(file.size / 1e6).toFixed(1)} MB; the limit is ${MOST.file / 1e6} MB`)
  const text = await file.text().catch(() => refuse("it cannot be read"))
  let found
  try {
    found = valuesIn(text) <= VALUES && JSON.parse(text)
  } catch {
    refuse("it is not a file that Hand in saved (it is not JSON)")
  }
  if (found?.format !== FORMAT) refuse("it is not a file of answers to these exercises")
  const isName = NAME.get(found.version)
  if (!isName) refuse("another version of this site wrote it")
  const { name, id, answers } = found
  if (typeof name !== "string" || typeof id !== "string" || typeof answers !== "object" || !answers) {
    refuse("its name or its answers are missing")
  }
  const pairs = Object.entries(answers)
  if (pairs.length > MOST.answers) refuse(`it has ${pairs.length} answers, and at most ${MOST.answers} are read`)
  if (!pairs.every(([name, answer]) => name.length <= MOST.name && isName.test(name) && typeof answer === "string")) {
    refuse("one of its answers is not a text with the name of an exercise")
  }
  const known = pairs.map(([exercise, answer]) => /** @type {[string, string]} */ ([nameOf(exercise), answer]))
  const date = new Date(typeof found.date === "string" ? found.date : NaN)
  const student = typeof found.student === "string" ? plain(found.student) : ""
  const when = isNaN(Number(date)) ? null : date
  return { file: file.name, name: plain(name) || "(no name)", student, id: id.slice(0, MOST.name), date: when, answers: known }
}

/**
 * A name in one line, without the characters that are not seen or that turn the direction of a text.
 *
 * @param {string} name
 */
function plain(name) {
  return name.replace(/\s+/g, " ").replace(/\p{C}/gu, "").trim().slice(0, MOST.name)
}
