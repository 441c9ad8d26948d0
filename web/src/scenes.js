// What a stepper shows: the scenes of a run, as rosspin/run/noted_steps.py has noted them. No drawing is done here.

/** @typedef {import("./protocol.js").Scenes} Scenes */

/**
 * A step as it is drawn: who is ready, in which thread runs what, and in each group how its callbacks are. A callback is
 * known by its number, a line by its number in the listing; 0: it has none there.
 *
 * @typedef {{number: number, name: string, how: string}} Callback
 * @typedef {{name: string, callback: Callback | null, line: number}} Thread
 * @typedef {{time: string, said: string, ready: Callback[], threads: Thread[], groups: {name: string, callbacks: Callback[]}[],
 *   alternative: string}} Scene
 */

/** @type {(time: number) => string} */
const seconds = (time) => `${Number(time.toFixed(6))} s`

/**
 * One step of a run.
 *
 * @param {Scenes} scenes
 * @param {number} index
 * @returns {Scene}
 */
export function scene({ groups, callbacks, threads, steps }, index) {
  const [time, said, ready, where, how] = steps[index]
  const all = how.map((words, number) => ({ number, name: callbacks[number][0], how: words }))
  const byGroup = groups.map((name, group) => ({ name, callbacks: all.filter(({ number }) => callbacks[number][1] === group) }))
  const running = where.map(([thread, callback, line]) => ({ name: threads[thread], callback: all[callback] ?? null, line }))
  const waiting = ready.map((number) => all[number])
  const words = [
    `Step ${index + 1} of ${steps.length}, at ${seconds(time)}`,
    ...(groups.length ? [waiting.length ? `ready: ${waiting.map(({ name }) => name).join(", ")}` : "nothing is ready"] : []),
    ...running.map(({ name, callback, line }) => {
      return [name, callback ? `runs ${callback.name}` : "runs no callback", line && `line ${line}`].filter(Boolean).join(", ")
    }),
    ...all.filter((each) => each.how && each.how !== "ready" && each.how !== "runs").map((each) => `${each.name} ${each.how}`),
  ]
  return {
    time: seconds(time),
    said,
    ready: waiting,
    threads: running,
    groups: byGroup.filter((group) => group.callbacks.length),
    alternative: `${words.join("; ")}.`,
  }
}

/**
 * A ring of waits, or a way that ends where no one continues, in a sentence.
 *
 * @param {import("./protocol.js").Ring} ring
 */
export function sayRing({ links, to }) {
  const said = links.map(([name, waits]) => `${name} ${waits}`).join(". ")
  return to < 0 ? `A way of waits that ends. ${said}.` : `A ring of waits. ${said}. So it comes back to ${links[to][0]}.`
}

/**
 * A text in lines of so many characters at most, broken between words.
 *
 * @param {string} text
 * @param {number} most
 */
export function wrapped(text, most) {
  const lines = [""]
  for (const word of text.split(" ")) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim()
    if (longer.length > most && lines[lines.length - 1]) lines.push(word)
    else lines[lines.length - 1] = longer
  }
  return lines
}
