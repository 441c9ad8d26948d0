// What runs code is loaded when it is first needed: see runs.js. `base` is the address of the folder that it is in.

/** What to ask a reader for whom a file of the site cannot be loaded. */
export const IS_IT_THERE = "Is the site still there?"

/**
 * The module runs.js, in the version that belongs to this page.
 *
 * @param {string} base
 * @returns {Promise<typeof import("./runs.js")>}
 */
export const load = (base) => import(`${base}runs.js?${RUNS}`)

/**
 * Have ready what the next run needs, of an answer to an exercise if `answers`, or of a program.
 *
 * @param {string} base
 * @param {boolean} answers
 * @param {string} program
 */
export function warmUp(base, answers, program) {
  load(base).then(
    (runs) => runs.warmUp(answers, program),
    () => {}, // a run will say so
  )
}

/**
 * Run a job; `hear(message)` is called with what comes of it. `end()` of what is returned ends it immediately.
 *
 * @param {string} base
 * @param {import("./runs.js").Text} job
 * @param {(message: import("./runs.js").Told) => void} hear
 * @returns {import("./runs.js").Run}
 */
export function start(base, job, hear) {
  /** @type {import("./runs.js").Run | null} */
  let run = null
  let ended = false
  load(base).then(
    (runs) => ended || (run = runs.start(job, hear)),
    () => hear({ kind: "failed", reason: `Python could not be loaded. ${IS_IT_THERE}` }),
  )
  return {
    end() {
      ended = true
      run?.end()
    },
  }
}

/**
 * Why a page as it was opened runs no code, in a sentence; "" if it does.
 *
 * @param {string} what it cannot do, as in "run Python"
 */
export function notHere(what) {
  if (location.protocol === "file:") return `Opened as a file, a page cannot ${what}: see START-HERE.html, or make serve`
  if (self !== top) return `Shown inside another page, a page cannot ${what}. Open it by itself.`
  return ""
}
