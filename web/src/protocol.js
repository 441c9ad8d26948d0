// What the page and a sandbox say to each other. The page sends objects; a sandbox sends JSON, in texts that are short
// and few. The page trusts none of it: what comes out of a sandbox may have been written by the code that ran there.

/**
 * @typedef {{kind: "run", source: string, filename: string, seconds: number, args: string, speed: number}
 *   | {kind: "trace", number: number, text: string}
 *   | {kind: "judge", number: number, text: string, trace: string}} Job
 * @typedef {{kind: "file", name: string, bytes: ArrayBuffer | null}} File what a sandbox needed; null: it cannot be had
 * @typedef {[isError: boolean, text: string, number: number, line: number]} Chunk of what is printed
 * @typedef {[source: string, number: number, expected: number, real: number, duration: number]} Tick
 * @typedef {{kind: "ready"} | {kind: "need", name: string} | {kind: "failed", reason: string}
 *   | {kind: "batch", chunks: Chunk[], leftOut: number, ticks: Tick[]}
 *   | {kind: "end", result: object}} Message what a sandbox says; the result is that of rosspin.page's function
 */

/** A message has at most so many characters. The longest are traces, of little more than 2 MB, whose quotes are escaped. */
export const LONGEST = 6_000_000

/** So many messages may come at once, and so many more in each second. Python sends 20 in a second. */
export const AT_ONCE = 100
export const PER_SECOND = 100

/** An answer is either; see rosspin.page.judge. */
const VERDICTS = ["solved", "not yet", "open", "to read", "not judged"]

const isText = (value) => typeof value === "string"
const isNumber = (value) => typeof value === "number"
const isList = (value, isItem) => Array.isArray(value) && value.every(isItem)
const isChunk = (value) =>
  isList(value, () => true) && isText(value[1]) && isNumber(value[2]) && isNumber(value[3]) && value.length === 4
const isTick = (value) => isList(value, () => true) && isText(value[0]) && isList(value.slice(1), isNumber) && value.length === 5

const RESULTS = {
  run({ status, errors = 0, count = 0, ticks = [], chunks = [], end = 0, alternative = "", test = "" }) {
    const right =
      [status, errors, count, end].every(isNumber) &&
      [alternative, test].every(isText) &&
      isList(ticks, isTick) &&
      isList(chunks, (of) => isList(of, isNumber)) &&
      ticks.length > 0 === count > 0
    return right && { status, errors, count, ticks, chunks, end, alternative, test }
  },
  trace: ({ trace }) => isText(trace) && { trace },
  judge({ verdict, solved, status, console, said }) {
    const right = VERDICTS.includes(verdict) && (verdict === "solved") === solved && [status, console, said].every(isText)
    return right && { verdict, solved, status, console, said }
  },
}

const MESSAGES = {
  ready: () => ({}),
  need: ({ name }) => isText(name) && { name },
  failed: ({ reason }) => isText(reason) && { reason: reason.slice(0, 1000) },
  batch({ chunks, leftOut, ticks }) {
    return isList(chunks, isChunk) && isNumber(leftOut) && isList(ticks, isTick) && { chunks, leftOut, ticks }
  },
  end: ({ result }, job) => result && job && (result = RESULTS[job](result)) && { result },
}

/**
 * The message in a text that came from a sandbox, with what is known of such messages alone; `job` is the kind of what
 * the sandbox was asked to do.
 *
 * @returns {Message | null} null: it is none
 */
export function read(text, job) {
  try {
    const message = text.length <= LONGEST && JSON.parse(text)
    const known = Object.hasOwn(MESSAGES, message.kind) && MESSAGES[message.kind](message, job)
    return known ? { kind: message.kind, ...known } : null
  } catch {
    return null
  }
}
