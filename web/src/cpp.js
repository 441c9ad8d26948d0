// A C++ node in the worker of a sandbox, without Python. It is sent one job, with the program, and says what comes of it: see
// protocol.js.

import { Alone, COLOURS } from "../../src/rosspin/cpp/js/alone.mjs"
import { called } from "./called.js"
import { SHOWN } from "./limits.js"
import { bySource, describe, lost } from "./measures.js"
import { Page } from "./page.js"
import { split } from "./words.js"

/** @typedef {import("./protocol.js").CppJob} CppJob */

// So many chunks of what a tick prints are remembered, and so many of the last in all: see rosspin/page.py.
const MOST_CHUNKS = 1000
const LAST_CHUNKS = 10_000

// So many sources are described, in so many characters.
const MOST_SOURCES = 100
const TEXT = 1_000_000

/** So many deadlocks are drawn. */
const MOST_RINGS = 20

/** Names are not longer (characters). */
const NAME = 200

/**
 * Let time (ms) pass. A browser that has nothing to sleep on computes meanwhile.
 *
 * @param {number} ms
 */
function sleep(ms) {
  const until = performance.now() + ms
  try {
    Atomics.wait(new Int32Array(new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true }).buffer), 0, 0, ms)
  } catch {
    while (performance.now() < until);
  }
}

function say(/** @type {import("./protocol.js").FromSandbox} */ message) {
  const text = JSON.stringify(message)
  postMessage(text)
  return text
}

/** What a run shows. */
class Shown {
  count = 0 // of the chunks that were printed
  /** @type {Map<number, number[]>} */
  chunks = new Map() // of the last ticks: what each printed
  /** @type {[chunk: number, when: number][]} */
  #since = [] // what was printed in no tick since the last one
  #begun = performance.now()
  #page
  #speed
  /** @type {Alone | null} */
  node = null

  /**
   * @param {Page} page
   * @param {number} speed
   */
  constructor(page, speed) {
    this.#page = page
    this.#speed = speed
  }

  /**
   * @param {string} text
   * @param {boolean} isError
   * @param {number} tick in which it is printed
   */
  print(text, isError, tick) {
    if (tick >= 0) this.#add(tick, this.count)
    else this.#since.push([this.count, this.node ? Number(this.node.now) / 1e9 : 0])
    if (this.#since.length > MOST_CHUNKS) this.#since.shift()
    this.count++
    this.#page.print(text.replace(COLOURS, ""), isError, 0)
  }

  /**
   * @param {number} tick
   * @param {number} chunk
   */
  #add(tick, chunk) {
    const own = this.chunks.get(tick) ?? []
    own.push(chunk)
    if (own.length > MOST_CHUNKS) own.shift()
    this.chunks.set(tick, own)
    if (this.chunks.size > 2 * SHOWN.ticks) this.chunks.delete(this.chunks.keys().next().value ?? 0)
  }

  /**
   * A tick begins, or the pass of a loop, to which belongs what was printed since it began, has ended.
   *
   * @param {import("./protocol.js").Tick} tick
   * @param {number} number
   */
  begin([source, count, expected, real, duration], number) {
    if (duration >= 0) for (const [chunk, when] of this.#since) if (when >= real) this.#add(number, chunk)
    this.#since = []
    if (this.#speed) this.#page.tick(source.slice(0, NAME), count, expected, real)
  }

  /**
   * Wait until the page's clock has come to a time (s) of the run.
   *
   * @param {number} now
   */
  pace(now) {
    const target = this.#begun + (now * 1e3) / this.#speed
    for (;;) {
      const [left, due] = [target - performance.now(), this.#page.due]
      if (due <= 0) this.#page.send()
      else if (left <= 0) return
      else sleep(Math.min(left, due))
    }
  }
}

/**
 * What the reader can go through, or is drawn of a deadlock. No tick tells in which of several threads it is.
 *
 * @param {Alone} node
 * @param {number} end
 * @param {number} status
 * @returns {import("./protocol.js").Scenes | null}
 */
function scenes({ hasThreads, ticks, rings }, end, status) {
  if (!hasThreads) return called(ticks.map(([source, ...rest]) => [source.slice(0, NAME), ...rest]), end, status)
  return rings.length ? { threads: [], groups: [], callbacks: [], steps: [], rings: rings.slice(0, MOST_RINGS) } : null
}

/**
 * Run a node; what came of it.
 *
 * @param {CppJob} job
 * @param {Page} page
 * @returns {Promise<import("./protocol.js").RunResult>}
 */
async function run({ bytes, ros, filename, seconds, args, speed }, page) {
  const failed = { status: 1, errors: 0, count: 0, hints: 0, ticks: [], lost: [], chunks: [], end: 0, alternative: "", scenes: null, drive: [] }
  const shown = new Shown(page, speed)
  let words
  try {
    words = split(args)
  } catch (error) {
    page.print(`${/** @type {Error} */ (error).message}\n`, true, 0)
    return failed
  }
  const [seed] = crypto.getRandomValues(new Uint32Array(1))
  const module = new WebAssembly.Module(/** @type {ArrayBuffer} */ (bytes))
  const node = new Alone(module, { ros, name: filename, words, seconds, seed, paced: speed > 0 }, shown)
  shown.node = node
  const { status, end, hints } = await node.run()
  for (const hint of hints) page.print(`${hint}\n`, true, 0)
  const all = node.ticks.map(([source, number, expected, real, duration]) =>
    /** @type {import("./protocol.js").Tick} */ ([source.slice(0, NAME), number, expected, real, Math.max(duration, 0)]))
  const ticks = all.slice(-SHOWN.ticks)
  const since = ticks.length === all.length ? 0 : Math.min(...ticks.map(([, , expected]) => expected))
  const groups = [...bySource(all)].map(([source, group]) => {
    const [, last] = group[group.length - 1]
    const coming = node.foreseen.filter(([name, number]) => name === source && number > last)
    return { source, group, gone: lost([...group, ...coming], node.periods.get(source) ?? 0) }
  })
  const first = all.length - ticks.length
  return {
    ...failed,
    status,
    count: all.length,
    hints: hints.length,
    ticks,
    lost: groups
      .flatMap(({ source, gone }) => gone.map((time) => /** @type {import("./protocol.js").Lost} */ ([source, Number(time.toFixed(6))])))
      .filter(([, time]) => time >= since)
      .slice(-SHOWN.ticks),
    chunks: ticks.map((_, place) => (shown.chunks.get(first + place) ?? []).filter((chunk) => chunk >= shown.count - LAST_CHUNKS)),
    end: Math.min(end, seconds),
    scenes: scenes(node, Math.min(end, seconds), status),
    alternative: groups
      .slice(0, MOST_SOURCES)
      .map(({ source, group, gone }) => describe(source, group) + (gone.length ? ` Lost ticks: ${gone.length}.` : ""))
      .join(" ")
      .slice(0, TEXT),
  }
}

addEventListener("message", async ({ data }) => {
  const page = new Page(say)
  try {
    const result = await run(data, page)
    page.send()
    say({ kind: "end", result })
  } catch (error) {
    page.send()
    say({ kind: "failed", reason: `The node could not be run: ${error}`.slice(0, 1000) })
  }
})
say({ kind: "ready" })
