// Judges answers that were handed in: each runs in one sandbox, and what came of it is judged in another.

import { load } from "./python.js"

/** For how long (ms) an answer may run, or be judged, and for how long Python may start. */
const TIME = RULES.handIns.time * 1000
const START = 60_000

/** For how long (ms) hand-ins may be read. */
const READING = 600_000

/** So much (characters) is shown of what was said of an answer. */
const MOST_SAID = RULES.handIns.said

/** @typedef {import("./protocol.js").Verdict | "did not end" | "stopped"} Found of an answer */
/**
 * @typedef {{verdict: Found, said: string, why?: string, hint?: string, off?: number | null}} Judgement why and hint: of a
 *   wrong answer; off: how far (m) its vehicle came off its line
 */

const NOT_JUDGED = "not judged"

const STOPPED_SAID = "Stopped before it was judged. Drop the file again to have it judged."
/** @type {Judgement} */
export const STOPPED = { verdict: "stopped", said: STOPPED_SAID }

/** @typedef {import("./protocol.js").Results} Results */

/** Why an answer has no verdict. */
class NoVerdict extends Error {
  /**
   * @param {string} said
   * @param {Found} verdict
   */
  constructor(said, verdict = NOT_JUDGED) {
    super(said)
    /** @type {Judgement} */
    this.judgement = { verdict, said }
  }
}

/**
 * The result of a job in a sandbox. NoVerdict: there is none.
 *
 * @template {keyof Results} K
 * @param {import("./sandboxes.js").Sandbox} sandbox
 * @param {Extract<import("./protocol.js").Job, {kind: K}>} job
 * @param {AbortSignal} stopped
 * @returns {Promise<Results[K]>}
 */
function result(sandbox, job, stopped, time = TIME) {
  return new Promise((resolve, reject) => {
    /** @type {number | undefined} */
    let timer
    /** @type {(said: string, verdict?: Found) => void} */
    const fail = (said, verdict) => reject(new NoVerdict(said, verdict))
    /** @type {(ms: number, said: string, verdict?: Found) => void} */
    const limit = (ms, said, verdict) => {
      clearTimeout(timer)
      timer = setTimeout(fail, ms, said, verdict)
    }
    const hear = (/** @type {import("./protocol.js").Failed | import("./protocol.js").End<Results[K]>} */ message) => {
      clearTimeout(timer)
      if (message.kind === "end") resolve(message.result)
      else fail(message.reason)
    }
    if (stopped.aborted) fail(STOPPED.said, STOPPED.verdict)
    stopped.addEventListener("abort", () => fail(STOPPED.said, STOPPED.verdict))
    limit(START, "Python did not start.")
    sandbox.started.then((message) => {
      if (message.kind !== "ready") return hear(message)
      limit(time, `It was ended after ${time / 1000} s.`, "did not end")
      sandbox.do(job, (message) => message.kind !== "batch" && hear(message))
    })
  })
}

/**
 * Sandboxes that have judged, and will continue: nothing of an answer runs in them.
 *
 * @type {import("./sandboxes.js").Sandbox[]}
 */
const resting = []

/**
 * The sandbox in which hand-ins are read; none of them runs there. It does one job after the other.
 *
 * @type {import("./sandboxes.js").Sandbox | undefined}
 */
let reading
/** @type {Promise<unknown>} */
let before = Promise.resolve()

/**
 * What comes of a job for that sandbox. Error: nothing, and it says why.
 *
 * @template {"read" | "answer" | "report"} K
 * @param {string} base the address of the folder that runs.js is in
 * @param {Extract<import("./protocol.js").Job, {kind: K}>} job
 * @returns {Promise<Results[K]>}
 */
export function ask(base, job) {
  const asked = before.then(async () => {
    const { Sandbox } = await load(base)
    reading ??= new Sandbox()
    return result(reading, job, new AbortController().signal, READING)
  })
  before = asked.catch(() => {})
  return asked
}

/** End what is left when all has been judged. */
export const rest = () => resting.splice(0).forEach((sandbox) => sandbox.end())

/**
 * The verdict on an answer, and what was said of it.
 *
 * @param {string} base the address of the folder that runs.js is in
 * @param {string} exercise
 * @param {string} text
 * @param {AbortSignal} stopped
 * @returns {Promise<Judgement>}
 */
export async function judge(base, exercise, text, stopped) {
  /** @type {import("./sandboxes.js").Sandbox[]} */
  const sandboxes = []
  try {
    const { Sandbox, programsOf } = await load(base).catch(() => {
      throw new NoVerdict("Python could not be loaded. Is the site still there?")
    })
    /** @type {string[]} */
    const texts = []
    const programs = await programsOf(text, (message) => {
      if (message.kind === "batch") texts.push(...message.chunks.map(([, chunk]) => chunk))
      else if (message.kind === "failed") throw new NoVerdict(message.reason)
    })
    if (!programs) return { verdict: "not yet", why: "It does not compile.", hint: texts[1] ?? "", said: texts.join("\n").slice(0, MOST_SAID) }
    const [running, judging] = [new Sandbox(), resting.pop() ?? new Sandbox()]
    sandboxes.push(running, judging)
    const names = programs.map(({ name }) => name)
    await running.started
    for (const { name, bytes } of programs) running.pass(name, bytes)
    const { trace } = await result(running, { kind: "trace", exercise, text, programs: names }, stopped)
    running.end()
    const { verdict, console, said, why, hint, off } = await result(judging, { kind: "judge", exercise, text, trace }, stopped)
    sandboxes.pop()
    resting.push(judging)
    const shown = console.slice(0, Math.max(MOST_SAID - said.length, 0))
    return { verdict, why, hint, off, said: [shown, said].filter(Boolean).join("\n").slice(0, MOST_SAID) }
  } catch (error) {
    return error instanceof NoVerdict ? error.judgement : { verdict: NOT_JUDGED, said: String(error) }
  } finally {
    sandboxes.forEach((sandbox) => sandbox.end())
  }
}
