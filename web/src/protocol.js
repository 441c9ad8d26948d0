// What the page and a sandbox say to each other. The page sends objects; a sandbox sends JSON, in texts that are short
// and few. The page trusts none of it: what comes out of a sandbox may have been written by the code that ran there.

/**
 * What the page sends:
 * @typedef {[source: string, filename: string, args: string]} Beside a node that runs together with the one of the job
 * @typedef {{kind: "run", source: string, filename: string, seconds: number, args: string, speed: number,
 *   beside: Beside[]}} RunJob
 * @typedef {{kind: "trace", exercise: string, text: string}} TraceJob
 * @typedef {{kind: "judge", exercise: string, text: string, trace: string}} JudgeJob
 * @typedef {{kind: "look", log: ArrayBuffer, name: string}} LookJob
 * @typedef {RunJob | TraceJob | JudgeJob | LookJob} Job
 * @typedef {{kind: "file", name: string, bytes: ArrayBuffer | null}} File what a sandbox needed; null: it cannot be had
 * @typedef {Job | File} ToSandbox
 *
 * What the functions of rosspin.page give back, as JSON but for the text of a trace:
 * @typedef {[isError: boolean, text: string, number: number, line: number]} Chunk of what is printed
 * @typedef {[source: string, number: number, expected: number, real: number, duration: number]} Tick
 * @typedef {[source: string, time: number]} Lost when (s) a tick was due that never came
 * @typedef {{status: number, errors: number, count: number, ticks: Tick[], lost: Lost[], chunks: number[][],
 *   end: number, alternative: string, test: string, scenes: Scenes | null}} RunResult
 * @typedef {[thread: number, callback: number, line: number]} Where a thread is; callback -1: in none; line 0: in none
 * @typedef {[time: number, said: string, ready: number[], threads: Where[], how: string[]]} Step
 * @typedef {{links: [name: string, waits: string][], to: number}} Ring of waits; to: for whom the last waits, -1: nobody
 * @typedef {{threads: string[], groups: string[], callbacks: [name: string, group: number][], steps: Step[],
 *   rings: Ring[]}} Scenes of a run; in ROS 1 there are no groups, and nothing is ready: each thread calls its own
 * @typedef {{trace: string}} TraceResult
 * @typedef {"solved" | "not yet" | "open" | "to read" | "not judged"} Verdict
 * @typedef {{verdict: Verdict, solved: boolean, status: string, console: string, said: string,
 *   why: string, hint: string}} JudgeResult
 * @typedef {{title: string, certain: string, evidence: string[], page: string, series: string[]}} Fault that a log shows;
 *   page: the address, below that of the site, of what explains it
 * @typedef {{name: string, part: number, count: number, period: number, chosen: number, drift: number, usual: number,
 *   lost: number, times: number[], late: number[], missing: number[]}} Series in a log; usual: how late 98% are at most;
 *   period 0: it is not regular, and late is empty
 * @typedef {{problem: string, kind: string, entries: number, seconds: number, notes: string[], verdicts: Fault[],
 *   series: Series[], files: [name: string, text: string][]}} LookResult a problem, or all the rest
 * @typedef {{run: RunResult, trace: TraceResult, judge: JudgeResult, look: LookResult}} Results by the kind of the job
 *
 * What a sandbox says; its last word on a job is that it has ended or failed:
 * @typedef {{kind: "ready"}} Ready
 * @typedef {{kind: "need", name: string}} Need
 * @typedef {{kind: "failed", reason: string}} Failed
 * @typedef {{kind: "batch", chunks: Chunk[], leftOut: number, ticks: Tick[]}} Batch
 */

/**
 * @template R
 * @typedef {{kind: "end", result: R}} End
 */

/**
 * @template {keyof Results} K
 * @typedef {Batch | Failed | End<Results[K]>} Word on a job of that kind
 */

/** @typedef {Ready | Need | Word<keyof Results>} FromSandbox */

/**
 * What the worker has for rosspin.page, and that for the worker.
 * @typedef {{
 *   print(text: string, isError: boolean, line: number): void,
 *   tick(source: string, number: number, expected: number, real: number): void,
 *   wait(ms: number): Promise<void>,
 * }} Shown of a run, as it happens
 * @typedef {{
 *   run: Python<[source: string, filename: string, seconds: number, args: string, speed: number, beside: string, page: Shown]>,
 *   trace: Python<[exercise: string, text: string]>,
 *   judge: Python<[exercise: string, text: string, trace: string]>,
 *   look: Python<[log: ArrayBuffer, name: string]>,
 *   wake(supply: (path: string) => Promise<void> | undefined): void,
 * }} PythonPage
 */

/**
 * @template {unknown[]} A
 * @typedef {{callPromising(...args: A): Promise<string>}} Python function that may wait
 */

/** A message has at most so many characters. The longest are traces, of little more than 2 MB, whose quotes are escaped. */
export const LONGEST = 6_000_000

/** So many messages may come together, and so many more in each second. Python sends 20 in a second. */
export const AT_ONCE = 100
export const PER_SECOND = 100

/** An answer is either; see rosspin.exercises.Verdict. */
const VERDICTS = ["solved", "not yet", "open", "to read", "not judged"]

/** @typedef {any} Unknown what may be anything */

const isText = (/** @type {Unknown} */ value) => typeof value === "string"
const isNumber = (/** @type {Unknown} */ value) => typeof value === "number"
/** @type {(value: Unknown, isItem: (item: Unknown) => boolean) => boolean} */
const isList = (value, isItem) => Array.isArray(value) && value.every(isItem)
const isChunk = (/** @type {Unknown} */ value) =>
  isList(value, () => true) && isText(value[1]) && isNumber(value[2]) && isNumber(value[3]) && value.length === 4
const isTick = (/** @type {Unknown} */ value) =>
  isList(value, () => true) && isText(value[0]) && isList(value.slice(1), isNumber) && value.length === 5

/** @type {(...isPart: ((part: Unknown) => boolean)[]) => (value: Unknown) => boolean} */
const isTuple = (...isPart) => (value) =>
  Array.isArray(value) && value.length === isPart.length && isPart.every((is, index) => is(value[index]))
/** @type {(end: number, first?: number) => (value: Unknown) => boolean} */
const isBelow = (end, first = 0) => (value) => Number.isInteger(value) && value >= first && value < end

/** @type {(scenes: Unknown) => boolean} whether each number in them is that of something in them */
function isScenes({ threads, groups, callbacks, steps, rings }) {
  const isWhere = isTuple(isBelow(threads.length), isBelow(callbacks.length, -1), isNumber)
  const isStep = (/** @type {Unknown} */ step) =>
    isTuple(isNumber, isText, Array.isArray, (where) => isList(where, isWhere), (how) => isList(how, isText))(step) &&
    isList(step[2], isBelow(step[4].length)) && step[4].length <= callbacks.length
  const isRing = (/** @type {Unknown} */ { links, to }) =>
    isList(links, isTuple(isText, isText)) && links.length > 0 && isBelow(links.length, -1)(to)
  return (
    [threads, groups].every((names) => isList(names, isText)) &&
    isList(callbacks, isTuple(isText, isBelow(groups.length || 1))) &&
    isList(steps, isStep) &&
    isList(rings, isRing)
  )
}

/** A page of this site, and maybe a place on it. */
const ADDRESS = /^(docs|notebooks)(\/[\w-]+)+\.html(#[\w-]+)?$/

/** @type {(fault: Unknown) => Fault | false} */
function fault({ title, certain, evidence, page, series }) {
  const right = [title, certain, page].every(isText) && [evidence, series].every((list) => isList(list, isText))
  return right && ADDRESS.test(page) && { title, certain, evidence, page, series }
}

/** @type {(series: Unknown) => Series | false} */
function series({ name, part, count, period, chosen, drift, usual, lost, times, late, missing }) {
  const right =
    isText(name) &&
    [part, count, period, chosen, drift, usual, lost].every(isNumber) &&
    [times, late, missing].every((list) => isList(list, isNumber)) &&
    late.length === (period > 0 ? times.length : 0)
  return right && { name, part, count, period, chosen, drift, usual, lost, times, late, missing }
}

/**
 * What is known of the result of a job, by its kind; false if that is not right.
 *
 * @type {{[K in keyof Results]: (result: Unknown) => Results[K] | false}}
 */
const RESULTS = {
  run({ status, errors = 0, count = 0, ticks = [], lost = [], chunks = [], end = 0, alternative = "", ...rest }) {
    const { test = "", scenes = null } = rest
    const right =
      [status, errors, count, end].every(isNumber) &&
      [alternative, test].every(isText) &&
      isList(ticks, isTick) &&
      isList(lost, isTuple(isText, isNumber)) &&
      isList(chunks, (of) => isList(of, isNumber)) &&
      ticks.length > 0 === count > 0 &&
      (scenes === null || isScenes(scenes))
    return right && { status, errors, count, ticks, lost, chunks, end, alternative, test, scenes }
  },
  trace: ({ trace }) => isText(trace) && { trace },
  judge({ verdict, solved, status, console, said, why = "", hint = "" }) {
    const right = VERDICTS.includes(verdict) && (verdict === "solved") === solved
    return right && [status, console, said, why, hint].every(isText) && { verdict, solved, status, console, said, why, hint }
  },
  look({ problem = "", kind = "", entries = 0, seconds = 0, notes = [], verdicts = [], series: rows = [], files = [] }) {
    const known = { verdicts: verdicts.map(fault), series: rows.map(series) }
    const right =
      [problem, kind].every(isText) &&
      [entries, seconds].every(isNumber) &&
      isList(notes, isText) &&
      isList(files, isTuple(isText, isText)) &&
      Boolean(problem) === (verdicts.length === 0) &&
      [...known.verdicts, ...known.series].every(Boolean)
    return right && { problem, kind, entries, seconds, notes, ...known, files }
  },
}

/** @type {Record<string, (message: Unknown, job: keyof Results | null) => object | false>} */
const MESSAGES = {
  ready: () => ({}),
  need: ({ name }) => isText(name) && { name },
  failed: ({ reason }) => isText(reason) && { reason: reason.slice(0, 1000) },
  batch({ chunks, leftOut, ticks }) {
    return isList(chunks, isChunk) && isNumber(leftOut) && isList(ticks, isTick) && { chunks, leftOut, ticks }
  },
  end({ result }, job) {
    const known = result && job && RESULTS[job](result)
    return known && { result: known }
  },
}

/**
 * The message in a text that came from a sandbox, with what is known of such messages alone; `job` is the kind of what
 * the sandbox was asked to do.
 *
 * @param {string} text
 * @param {keyof Results | null} job
 * @returns {FromSandbox | null} null: it is none
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
