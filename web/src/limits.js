// How much a sandbox may say: what comes out of it may have been written by the code that ran there, and the page continues
// answering its reader. See protocol.js.

/** @typedef {import("./protocol.js").Job["kind"]} Kind of a job */

/**
 * A message on each kind of job has at most so many characters, and its JSON so many values: to read that takes a page a
 * moment. A trace is one text of little more than 2 MB, whose quotes are escaped.
 *
 * @type {Record<Kind | "", {characters: number, values: number}>}
 */
export const LONGEST = {
  "": { characters: 100_000, values: 100 }, // before there is a job
  run: { characters: 1_500_000, values: 100_000 },
  cpp: { characters: 1_500_000, values: 100_000 },
  compile: { characters: 20_000_000, values: 100 },
  trace: { characters: 6_000_000, values: 100 },
  judge: { characters: 2_000_000, values: 100 },
  look: { characters: 4_000_000, values: 250_000 },
  pin: { characters: 2_000_000, values: 100 },
  read: { characters: 4_000_000, values: 100_000 },
  answer: { characters: 1_000_000, values: 100 },
  report: { characters: 6_000_000, values: 2000 },
}

/** So much room is there for messages in each second, in characters: each takes some itself, and for each value. */
export const PER_SECOND = 2_000_000
const MESSAGE = 20_000
const VALUE = 5

/** So much is shown of a run at a time: characters, chunks of them, and ticks. */
export const SHOWN = { characters: 50_000, chunks: 5000, ticks: 2000 }

/**
 * How many values are in a text of JSON, which is not read for that.
 *
 * @param {string} text
 */
export function valuesIn(text) {
  let count = 1
  let quoted = false
  for (let at = 0; at < text.length; at++) {
    const code = text.charCodeAt(at)
    if (code === 0x22) quoted = !quoted
    else if (quoted) at += Number(code === 0x5c) // and the character after a \
    else if (code === 0x2c || code === 0x5b || code === 0x7b) count++ // , [ {
  }
  return count
}

/**
 * How much room a message on a job takes; Infinity if none may be like that.
 *
 * @param {unknown} message
 * @param {Kind | null} job
 */
export function room(message, job) {
  const { characters, values } = LONGEST[job ?? ""]
  if (typeof message !== "string" || message.length > characters) return Infinity
  const count = valuesIn(message)
  return count > values ? Infinity : MESSAGE + message.length + VALUE * count
}

/** The number of chunks that no node has printed. */
export const OF_NO_NODE = -1
