// What the page and a sandbox say to each other. The page sends objects; a sandbox sends JSON, in texts that are short
// and few. The page trusts none of it: what comes out of a sandbox may have been written by the code that ran there.

import { LONGEST, SHOWN } from "./limits.js"

/**
 * What the page sends:
 * @typedef {[source: string, filename: string, args: string]} Beside - a node that runs together with the job's
 * @typedef {{kind: "run", source: string, filename: string, seconds: number, args: string, speed: number,
 *   beside: Beside[], programs: string[], files: Record<string, string>}} RunJob programs: the names of the files, sent
 *   before, of those in C++, packed or not; files: of a launch file, what it starts, by their paths
 * @typedef {{kind: "cpp", name: string, bytes: ArrayBuffer | null, ros: number, filename: string, seconds: number, args: string,
 *   speed: number}} CppJob to run a compiled node; bytes: its program, packed until it reaches its worker
 * @typedef {{kind: "compile", text: string, filename: string}} CompileJob
 * @typedef {{kind: "trace", exercise: string, text: string, programs: string[]}} TraceJob programs: as above, of an answer in C++
 * @typedef {{kind: "judge", exercise: string, text: string, trace: string}} JudgeJob
 * @typedef {{kind: "look", log: ArrayBuffer, name: string}} LookJob
 * @typedef {{kind: "pin", source: string, filename: string, seconds: number, args: string, console: string,
 *   ticks: Tick[]}} PinJob to write a test that pins what a run showed
 * @typedef {{kind: "read", files: {path: string, file: Blob | null}[]}} ReadJob what students handed in, besides all before
 * @typedef {{kind: "answer", number: number, exercise: string}} AnswerJob to have one that was read
 * @typedef {{kind: "report", verdicts: (readonly [row: number, exercise: string, verdict: string, why: string,
 *   hint: string, off: number | null])[]}} ReportJob to have a table of all that was read
 * @typedef {RunJob | TraceJob | JudgeJob | LookJob | PinJob | ReadJob | AnswerJob | ReportJob} PythonJob
 * @typedef {PythonJob | CppJob | CompileJob} Job
 * @typedef {{kind: "file", name: string, bytes: ArrayBuffer | null}} File what a sandbox needed; null: it cannot be had
 * @typedef {Job | File} ToSandbox
 *
 * What the functions of rosspin.page give back, as JSON but for the text of a trace:
 * @typedef {[isError: boolean, text: string, number: number, line: number]} Chunk of what is printed
 * @typedef {[source: string, number: number, expected: number, real: number, duration: number]} Tick
 * @typedef {[source: string, time: number]} Lost when (s) a tick was due that never came
 * @typedef {{status: number, errors: number, count: number, ticks: Tick[], lost: Lost[], chunks: number[][],
 *   end: number, alternative: string, scenes: Scenes | null, drive: Drive, hints: number}} RunResult hints: how many lines of
 *   the console are for the reader, of what became of the run
 * @typedef {string[]} Drive what is drawn of a vehicle: see rosspin/vehicle/drawn.py; nothing if there was none
 * @typedef {[thread: number, callback: number, line: number]} Where a thread is; callback -1: in none; line 0: in none
 * @typedef {[time: number, said: string, ready: number[], threads: Where[], how: string[]]} Step
 * @typedef {{links: [name: string, waits: string][], to: number}} Ring of waits; to: for whom the last waits, -1: no one
 * @typedef {{threads: string[], groups: string[], callbacks: [name: string, group: number][], steps: Step[],
 *   rings: Ring[]}} Scenes of a run; in ROS 1 there are no groups, and nothing is ready: each thread calls its own
 * @typedef {{said: string, program: string}} CompileResult what the compiler said, and the program in base64; "": none
 * @typedef {{trace: string}} TraceResult
 * @typedef {"solved" | "not yet" | "open" | "to read" | "not judged"} Verdict
 * @typedef {{verdict: Verdict, solved: boolean, status: string, console: string, said: string,
 *   why: string, hint: string, off: number | null, drive: Drive}} JudgeResult off: how far (m) a vehicle came off its line
 * @typedef {{title: string, certain: string, evidence: string[], page: string, series: string[]}} Fault that a log shows;
 *   page: the address, within the site, of what explains it
 * @typedef {{name: string, part: number, count: number, period: number, chosen: number, drift: number, usual: number,
 *   lost: number, times: number[], late: number[], missing: number[]}} Series in a log; usual: how late 98% are at most;
 *   period 0: it is not regular, and late is empty
 * @typedef {{problem: string, kind: string, entries: number, seconds: number, notes: string[], verdicts: Fault[],
 *   series: Series[], files: [name: string, text: string][]}} LookResult a problem, or all the rest
 * @typedef {{test: string}} PinResult
 * @typedef {{number: number, name: string, student: string, file: string, date: string, note: string, late: boolean,
 *   others: string[], namesakes: string[], answers: number[]}} HandIn of a student; answers: to which of the exercises
 * @typedef {{exercises: string[], rows: HandIn[], problems: string[], unlisted: number, refused: number}} ReadResult
 * @typedef {{text: string, why: string}} AnswerResult why: it cannot be judged
 * @typedef {{csv: string, hard: [exercise: string, answered: number, solved: number,
 *   hints: [hint: string, count: number][]][]}} ReportResult
 * @typedef {{run: RunResult, cpp: RunResult, compile: CompileResult, trace: TraceResult, judge: JudgeResult, look: LookResult, pin: PinResult,
 *   read: ReadResult, answer: AnswerResult, report: ReportResult}} Results by the kind of the job
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
 *   run: Python<[source: string, filename: string, seconds: number, args: string, speed: number, beside: string, files: string,
 *     page: Shown]>,
 *   trace: Python<[exercise: string, text: string, page: Shown]>,
 *   judge: Python<[exercise: string, text: string, trace: string]>,
 *   look: Python<[log: ArrayBuffer, name: string]>,
 *   pin: Python<[source: string, filename: string, seconds: number, args: string, console: string, ticks: string]>,
 *   read: Python<[paths: string, files: Readable[]]>,
 *   answer: Python<[number: number, exercise: string]>,
 *   report: Python<[verdicts: string]>,
 *   wake(supply: (path: string) => Promise<void> | undefined): void,
 * }} PythonPage
 */

/** @typedef {{size: number, read(from: number, to: number): Uint8Array}} Readable file as Python reads it */

/**
 * @template {unknown[]} A
 * @typedef {{callPromising(...args: A): Promise<string>}} Python function that may wait
 */

/** An answer is either; see rosspin.exercises.Verdict. */
const VERDICTS = ["solved", "not yet", "open", "to read", "not judged"]

// --- what is right, of values that may be anything ---

/** @typedef {any} Unknown */
/** @typedef {(value: Unknown) => boolean} Is */

/** @type {(most: number) => Is} */
const text = (most) => (value) => typeof value === "string" && value.length <= most
/** @type {(least: number, most: number) => Is} a number, which is neither infinite nor none */
const number = (least, most) => (value) => typeof value === "number" && value >= least && value <= most
/** @type {(least?: number, most?: number) => Is} */
const integer = (least = 0, most = Number.MAX_SAFE_INTEGER) => (value) =>
  Number.isInteger(value) && value >= least && value <= most
/** @type {(is: Is, most: number) => Is} */
const list = (is, most) => (value) => Array.isArray(value) && value.length <= most && value.every((item) => is(item))
/** @type {(...are: Is[]) => Is} */
const tuple = (...are) => (value) =>
  Array.isArray(value) && value.length === are.length && are.every((is, index) => is(value[index]))
/** @type {Is} */
const truth = (value) => typeof value === "boolean"

/**
 * An object of such parts: what is known of a value, which may leave out what there is something in place of; false if it
 * is none.
 *
 * @param {Record<string, Is>} parts
 * @param {Record<string, unknown>} [instead]
 * @returns {(value: Unknown) => any}
 */
function object(parts, instead = {}) {
  return (value) => {
    if (typeof value !== "object" || !value) return false
    const found = Object.keys(parts).map((name) => [name, (Object.hasOwn(value, name) ? value : instead)[name]])
    return found.every(([name, part]) => parts[name](part)) && Object.fromEntries(found)
  }
}

const NAME = text(200)
const SENTENCE = text(500)
const TEXT = text(1_500_000)
/** A time or a length of time (s): as far as a clock of 64 bits can count nanoseconds, about 292 years. */
const FAR = 1e10
const TIME = number(-FAR, FAR)
const LENGTH = number(0, FAR)

const CHUNK = tuple(truth, text(SHOWN.characters), integer(), integer())
const TICKS = list(tuple(NAME, integer(-FAR, FAR), TIME, TIME, LENGTH), SHOWN.ticks)
const LOST = list(tuple(NAME, TIME), SHOWN.ticks)

/** Texts that become attributes of an SVG: whatever they are, they draw at most nonsense. */
const DRIVE = (/** @type {Unknown} */ value) => list(text(100_000), 13)(value) && [0, 13].includes(value.length)

const isScenes = object({
  threads: list(SENTENCE, 100),
  groups: list(SENTENCE, 100),
  callbacks: list(tuple(SENTENCE, integer(0, 100)), 100),
  steps: list(
    tuple(TIME, SENTENCE, list(integer(), 100), list(tuple(integer(), integer(-1), integer()), 100), list(SENTENCE, 100)),
    500,
  ),
  rings: list(object({ links: list(tuple(SENTENCE, SENTENCE), 100), to: integer(-1) }), 20),
})

/** @type {(scenes: Scenes) => boolean} whether each number in them is for something in them */
function areMatched({ threads, groups, callbacks, steps, rings }) {
  return (
    callbacks.every(([, group]) => group < (groups.length || 1)) &&
    steps.every(
      ([, , ready, where, how]) =>
        how.length <= callbacks.length &&
        ready.every((callback) => callback < how.length) &&
        where.every(([thread, callback]) => thread < threads.length && callback < callbacks.length),
    ) &&
    rings.every(({ links, to }) => to < links.length && links.length > 0)
  )
}

/** A page of this site, and maybe a place on it. */
const ADDRESS = /^(docs|notebooks)(\/[\w-]+)+\.html(#[\w-]+)?$/

const FAULT = object({
  title: SENTENCE,
  certain: SENTENCE,
  evidence: list(SENTENCE, 100),
  page: (value) => SENTENCE(value) && ADDRESS.test(value),
  series: list(NAME, 1000),
})

/** So many times are drawn of a log, in all. */
const TIMES = 60_000

const SERIES = object({
  ...{ name: NAME, part: integer(), count: integer(), lost: integer() },
  ...{ period: LENGTH, chosen: LENGTH, drift: number(-1e15, 1e15), usual: LENGTH },
  ...{ times: list(TIME, TIMES), late: list(TIME, TIMES), missing: list(TIME, TIMES) },
})

const LOOK = object(
  {
    ...{ problem: SENTENCE, kind: SENTENCE, entries: integer(), seconds: LENGTH },
    notes: list(SENTENCE, 100),
    verdicts: list(FAULT, 100),
    series: list(SERIES, 100),
    files: list(tuple(NAME, TEXT), 10),
  },
  { problem: "", kind: "", entries: 0, seconds: 0, notes: [], verdicts: [], series: [], files: [] },
)

const RUN = object(
  {
    ...{ status: integer(-FAR, FAR), errors: integer(), count: integer(), hints: integer() },
    ...{ ticks: TICKS, lost: LOST, chunks: list(list(integer(), 1000), SHOWN.ticks) },
    ...{ end: LENGTH, alternative: TEXT, scenes: (value) => value === null || isScenes(value), drive: DRIVE },
  },
  { errors: 0, count: 0, hints: 0, ticks: [], lost: [], chunks: [], end: 0, alternative: "", scenes: null, drive: [] },
)

const JUDGE = object(
  {
    ...{ verdict: (value) => VERDICTS.includes(value), solved: truth, status: SENTENCE, console: TEXT, said: TEXT },
    ...{ why: TEXT, hint: TEXT, off: (value) => value === null || LENGTH(value), drive: DRIVE },
  },
  { why: "", hint: "", off: null, drive: [] },
)

/** What a table has room for: see rosspin/hand_ins/on_page.py. */
const ROWS = 1000
const EXERCISES_OF_ALL = 100

const HAND_IN = object({
  ...{ number: integer(), name: NAME, student: NAME, file: SENTENCE, date: NAME, note: SENTENCE, late: truth },
  ...{ others: list(NAME, 10), namesakes: list(SENTENCE, 10), answers: list(integer(0, EXERCISES_OF_ALL - 1), EXERCISES_OF_ALL) },
})

const READ = object({
  ...{ exercises: list(NAME, EXERCISES_OF_ALL), rows: list(HAND_IN, ROWS) },
  ...{ problems: list(text(1000), 100), unlisted: integer(), refused: integer() },
})

const HARD = list(tuple(NAME, integer(), integer(), list(tuple(SENTENCE, integer()), 10)), EXERCISES_OF_ALL)

/**
 * @param {Unknown} result
 * @returns {RunResult | false}
 */
function run(result) {
  const known = RUN(result)
  const right = known && known.ticks.length > 0 === known.count > 0 && known.ticks.length <= known.count
  return right && (known.scenes === null || areMatched(known.scenes)) && known
}

/**
 * What is known of the result of a job, by its kind; false if that is not right.
 *
 * @type {{[K in keyof Results]: (result: Unknown) => Results[K] | false}}
 */
const RESULTS = {
  run,
  cpp: run,
  compile: object({ said: TEXT, program: text(LONGEST.compile.characters) }),
  trace: object({ trace: text(LONGEST.trace.characters) }),
  judge(result) {
    const known = JUDGE(result)
    return known && (known.verdict === "solved") === known.solved && known
  },
  look(result) {
    const known = LOOK(result)
    const isWhole = (/** @type {Series} */ { period, times, late }) => late.length === (period > 0 ? times.length : 0)
    return known && Boolean(known.problem) === (known.verdicts.length === 0) && known.series.every(isWhole) && known
  },
  pin: object({ test: TEXT }),
  read(result) {
    const known = READ(result)
    return known && known.rows.every((/** @type {HandIn} */ row) => row.answers.every((place) => place < known.exercises.length)) && known
  },
  answer: object({ text: TEXT, why: SENTENCE }),
  report: object({ csv: text(LONGEST.report.characters), hard: HARD }),
}

const isResult = object({ result: (value) => typeof value === "object" })

/** @type {Record<string, (message: Unknown, job: keyof Results | null) => object | false>} */
const MESSAGES = {
  ready: object({}),
  need: object({ name: NAME }),
  failed: ({ reason }) => TEXT(reason) && { reason: reason.slice(0, 1000) },
  batch: object({ chunks: list(CHUNK, SHOWN.chunks), leftOut: integer(), ticks: TICKS }),
  end(message, job) {
    const known = job && isResult(message) && RESULTS[job](message.result)
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
    const message = text.length <= LONGEST[job ?? ""].characters && JSON.parse(text)
    const { kind } = message
    const known = typeof kind === "string" && Object.hasOwn(MESSAGES, kind) && MESSAGES[kind](message, job)
    return known ? /** @type {FromSandbox} */ ({ kind, ...known }) : null
  } catch {
    return null
  }
}
