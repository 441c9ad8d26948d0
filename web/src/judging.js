// Judges answers that were handed in: each runs in one sandbox, and what came of it is judged in another.

import { MOST } from "./answers.js"
import { load } from "./python.js"

/** For how long (ms) an answer may run, or be judged, and for how long Python may start. */
const TIME = 20_000
const START = 60_000

/** So much (characters) is shown of what was said of an answer. */
const MOST_SAID = 30_000

const NOT_JUDGED = "not judged"

const STOPPED_SAID = "Stopped before it was judged. Drop the file again to have it judged."
export const STOPPED = { verdict: "stopped", said: STOPPED_SAID }

/** Why an answer has no verdict. */
class NoVerdict extends Error {
  constructor(said, verdict = NOT_JUDGED) {
    super(said)
    this.verdict = { verdict, said }
  }
}

/** The result of a job in a sandbox. NoVerdict: there is none. */
function result(sandbox, job, stopped) {
  return new Promise((resolve, reject) => {
    let timer
    const fail = (...why) => reject(new NoVerdict(...why))
    const limit = (ms, ...why) => {
      clearTimeout(timer)
      timer = setTimeout(fail, ms, ...why)
    }
    const hear = (message) => {
      clearTimeout(timer)
      if (message.kind === "end") resolve(message.result)
      else fail(message.reason)
    }
    if (stopped.aborted) fail(STOPPED.said, STOPPED.verdict)
    stopped.addEventListener("abort", () => fail(STOPPED.said, STOPPED.verdict))
    limit(START, "Python did not start.")
    sandbox.started.then((message) => {
      if (message.kind !== "ready") return hear(message)
      limit(TIME, `It was ended after ${TIME / 1000} s.`, "did not end")
      sandbox.do(job, (message) => message.kind !== "batch" && hear(message))
    })
  })
}

/**
 * The verdict on an answer, and what was said of it. Stopped when the AbortSignal says so. `base` is the address of the
 * folder that runs.js is in.
 */
export async function judge(base, number, text, stopped) {
  if (text.length > MOST.answer) {
    return { verdict: NOT_JUDGED, said: `It has ${text.length} characters; at most ${MOST.answer} are judged.` }
  }
  const sandboxes = []
  try {
    const { Sandbox } = await load(base).catch(() => {
      throw new NoVerdict("Python could not be loaded. Is the site still there?")
    })
    sandboxes.push(new Sandbox(), new Sandbox())
    const [running, judging] = sandboxes
    const { trace } = await result(running, { kind: "trace", number, text }, stopped)
    running.end()
    const { verdict, console, said } = await result(judging, { kind: "judge", number, text, trace }, stopped)
    const shown = console.slice(0, Math.max(MOST_SAID - said.length, 0))
    return { verdict, said: [shown, said].filter(Boolean).join("\n").slice(0, MOST_SAID) }
  } catch (error) {
    return error.verdict ?? { verdict: NOT_JUDGED, said: String(error) }
  } finally {
    sandboxes.forEach((sandbox) => sandbox.end())
  }
}
