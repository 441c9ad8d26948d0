// What a C++ node of one thread does, step by step, as its ticks tell it: see rosspin/run/noted_steps.py.

/** @typedef {import("./protocol.js").Tick} Tick */

// So many steps are shown, the first ones, and callbacks of a node.
const MOST = 300
const MOST_CALLBACKS = 30

/** The passes of a loop are ticks, too, but nothing is called. */
const LOOP = /^(Wall)?Rate\b/

/** @type {(time: number) => string} */
const seconds = (time) => `${Number(time.toFixed(6))} s`

/**
 * The steps of a run that has ended; null if nothing was called in it.
 *
 * @param {Tick[]} ticks in the order in which they began; duration -1: it had not ended
 * @param {number} end (s) of the run
 * @param {number} status
 * @returns {import("./protocol.js").Scenes | null}
 */
export function called(ticks, end, status) {
  const calls = ticks.filter(([source]) => !LOOP.test(source)).slice(0, MOST)
  const names = [...new Set(calls.map(([source]) => source))]
  if (!names.length || names.length > MOST_CALLBACKS) return null
  /** @type {import("./protocol.js").Step[]} */
  const steps = []
  let [now, running] = [0, -1]
  /** @type {Map<number, number>} */
  const due = new Map() // since when (s), by callback

  const note = (/** @type {string} */ said) => {
    const how = names.map((_, callback) => {
      const since = due.get(callback)
      return callback === running ? "runs" : since === undefined ? "" : `due since ${seconds(since)}`
    })
    steps.push([now, said, [], [[0, running, 0]], how])
  }
  const advance = (/** @type {number} */ to) => {
    if (to <= now) return
    note(`${running < 0 ? "No callback runs" : `${names[running]} is at work`} until ${seconds(to)}.`)
    now = to
  }

  calls.forEach(([name, , expected, real, duration], index) => {
    const done = duration < 0 ? Math.max(end, real) : real + duration
    advance(real)
    running = names.indexOf(name)
    due.delete(running)
    note(`main calls ${name}${seconds(real - expected) === "0 s" ? "" : `, ${seconds(real - expected)} late`}.`)
    for (const [other, , since] of calls.slice(index + 1).filter(([, , at]) => at > real && at < done).sort(byTime)) {
      advance(since)
      due.set(names.indexOf(other), since)
      note(`${other} is due, and waits: ${name} is at work.`)
    }
    advance(done)
    if (duration < 0) return
    running = -1
    note(`${name} ends.`)
  })
  advance(end)
  const isWhole = steps.length < MOST && calls.length < MOST
  const last = isWhole ? `The node has ended, with status ${status}.` : "The rest is not shown."
  return {
    threads: ["main"],
    groups: [],
    callbacks: names.map((name) => [name, 0]),
    steps: [...steps.slice(0, MOST), [isWhole ? now : steps[MOST - 1][0], last, [], [], []]],
    rings: [],
  }
}

/** @type {(one: Tick, other: Tick) => number} */
const byTime = ([, , one], [, , other]) => one - other
