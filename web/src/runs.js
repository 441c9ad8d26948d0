// Runs of code, each in a sandbox of its own, which finds nothing of earlier ones there and ends with it. The next one is
// started meanwhile.

import { ANSWER, isCpp } from "./answers.js"
import { Fault, load } from "./files.js"
import { CPP, PYTHON, Sandbox } from "./sandboxes.js"

export { Console } from "./console.js"
export { outcome } from "./outcome.js"
export { Plot } from "./plot.js"
export { Sandbox }

/**
 * @typedef {import("./protocol.js").Failed} Failed
 * @typedef {import("./protocol.js").Results} Results
 * @typedef {{source: string, filename: string, args: string, program: string, ros: number}} Node ros: 0, or the ROS of one in
 *   C++, whose program has this SHA-256; "": it has to be compiled
 * @typedef {Node & {original: string}} Listing of a page, and what stood there at first
 * @typedef {Node & {seconds: number, speed: number, exercise: string, beside: Node[], launch: string, listings: Listing[]}} Text
 *   to be run: a node, maybe beside others, an answer to an exercise, or a launch file. What that starts has the SHA-256
 *   `launch`, and the page has these listings
 * @typedef {{verdict: string, solved: boolean, drive: string[]}} Judged the verdict in a line; "" if there is none
 * @typedef {{kind: "doing", said: string, share: number}} Doing before it begins; share: of what there is to do, -1: unknown
 * @typedef {{kind: "faults", faults: import("./faults.js").Fault[], filename: string}} Faults in a text that does not compile
 * @typedef {import("./protocol.js").Word<"run"> | import("./protocol.js").End<Judged> | {kind: "begun"} | Doing | Faults} Told
 * @typedef {{end(): void}} Run that has begun
 */

/**
 * @template {keyof Results} K
 * @typedef {(message: import("./protocol.js").Word<K> | {kind: "begun"}) => void} Hear
 */

/** So long (ms) a run has the computer for itself, before the next sandbox is started. */
const FIRST = 200

/** Sandboxes for one purpose. What judges never shares one with what runs. */
class Pool {
  /** @type {Runner | null} the one for the next job, if it was asked for */
  next = null

  /** @param {typeof PYTHON} what its sandboxes run */
  constructor(what) {
    this.what = what
  }

  warmUp() {
    return (this.next ??= new Runner(this))
  }

  take() {
    const runner = this.warmUp()
    this.next = null
    return runner
  }
}

/** A sandbox that is ready for a job, or will be. */
class Runner {
  #pool
  #sandbox
  #known // a promise, kept when it is known whether it is ready
  #dead = false

  /** @param {Pool} pool */
  constructor(pool) {
    this.#pool = pool
    this.#sandbox = new Sandbox(pool.what)
    this.#known = this.#sandbox.started.then((message) => {
      if (message.kind === "failed") this.end()
      return message
    })
  }

  /**
   * Do a job, which may need files; `hear(message)` is called with what comes of it.
   *
   * @template {keyof Results} K
   * @param {Extract<import("./protocol.js").Job, {kind: K}>} job
   * @param {Hear<K>} hear
   * @param {Program[]} [files]
   */
  async do(job, hear, files = []) {
    const message = await this.#known
    if (message.kind === "failed") return hear(message)
    if (this.#dead) return
    hear({ kind: "begun" })
    for (const { name, bytes } of files) this.#sandbox.pass(name, bytes)
    this.#sandbox.do(job, (message) => {
      if (message.kind === "end" || message.kind === "failed") this.end() // and so does what it has started
      hear(message)
    })
    setTimeout(() => this.#pool.warmUp(), FIRST)
  }

  end() {
    if (this.#pool.next === this) this.#pool.next = null
    this.#dead = true
    this.#sandbox.end()
  }
}

const runs = new Pool(PYTHON)
const judges = new Pool(PYTHON)
const programs = new Pool(CPP)

/** @type {Map<string, Promise<ArrayBuffer>>} programs that were asked for, by their SHA-256 */
const brought = new Map()

/** @param {string} program */
function bring(program) {
  const coming = brought.get(program) ?? load(program)
  brought.set(program, coming)
  coming.catch(() => brought.delete(program)) // the next time may have more luck
  return coming
}

/**
 * Have sandboxes ready for the next run, of an answer to an exercise if `answers`, or of a program.
 *
 * @param {boolean} answers
 * @param {string} program
 */
export function warmUp(answers, program) {
  if (program) {
    programs.warmUp()
    bring(program)
    return
  }
  runs.warmUp()
  if (answers) judges.warmUp()
}

/**
 * Run a job; `hear(message)` is called with what comes of it. `end()` of what is returned ends it immediately.
 *
 * @param {Text} job
 * @param {(message: Told) => void} hear
 * @returns {Run}
 */
export function start(job, hear) {
  const { source, filename, seconds, args, speed, beside, exercise, ros, launch } = job
  if (exercise) return answer(job, hear)
  const isAlone = ros > 0 && !beside.length // then it needs no Python
  const runner = (isAlone ? programs : runs).take()
  let ended = false
  const run = {
    end() {
      ended = true
      runner.end()
    },
  }
  const begin = async () => {
    const { path = filename, files = {}, nodes = [job, ...beside] } = launch ? await launched(job) : {}
    const made = await compiledOf(nodes, (message) => ended || hear(message))
    if (!made) return run.end()
    if (ended) return
    if (isAlone) return runner.do({ kind: "cpp", ...made[0], ros, filename, seconds, args, speed }, hear)
    const others = beside.map((node) => /** @type {import("./protocol.js").Beside} */ ([node.source, node.filename, node.args]))
    const programs = made.map(({ name }) => name)
    runner.do({ kind: "run", source, filename: path, seconds, args, speed, beside: others, programs, files }, hear, made)
  }
  begin().catch((error) => ended || hear(failed(error)))
  return run
}

/**
 * @param {unknown} error
 * @returns {Failed}
 */
const failed = (error) => ({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })

/**
 * The path of a launch file, the texts of what it starts, as they stand in the page's listings, by their paths, and those
 * nodes that are in C++.
 *
 * @param {Text} job
 */
async function launched({ launch, listings }) {
  const unpacked = new Blob([await bring(launch)]).stream().pipeThrough(new DecompressionStream("gzip"))
  /** @type {{path: string, files: Record<string, string>, programs: Record<string, string>}} */
  const { path, files, programs } = await new Response(unpacked).json()
  /** @type {Node[]} */
  const nodes = []
  for (const [name, text] of Object.entries(files)) {
    const listing = listings.find(({ original }) => original.trimEnd() === text.trimEnd())
    if (listing) files[name] = listing.source
    const node = { source: text, filename: name.replace(/.*\//, ""), args: "", program: programs[name], ros: 1, ...listing }
    if (name in programs) nodes.push(node)
  }
  return { path, files, nodes }
}

/** @typedef {{name: string, bytes: ArrayBuffer}} Program by the name of its file, which ends in .gz if it is packed */

/**
 * The programs of an answer to an exercise, none if it is in Python; null: it does not compile, which is then told.
 *
 * @param {string} source
 * @param {(message: Told) => void} hear
 */
export async function programsOf(source, hear) {
  const ros = /\brclcpp\//.test(source) ? 2 : 1
  return isCpp(source) ? compiledOf([{ source, filename: ANSWER, args: "", program: "", ros }], hear) : []
}

/**
 * The programs of those nodes that are in C++; null: one does not compile, which is then told.
 *
 * @param {Node[]} nodes
 * @param {(message: Told) => void} hear
 */
async function compiledOf(nodes, hear) {
  /** @type {Program[]} */
  const files = []
  for (const node of nodes.filter(({ ros }) => ros)) {
    const { program, filename } = node
    const bytes = program ? await bring(program) : await import("./compiled.js").then(({ compiled }) => compiled(node, hear))
    if (!bytes) return null
    files.push({ name: program ? `${filename}.gz` : filename, bytes })
  }
  return files
}

const NOT_LOADED = "What this needs could not be loaded. Is the site still there?"

/**
 * Look at a log, of which the browser has these bytes; `hear(message)` is called with what comes of it. `end()` of what
 * is returned ends it immediately.
 *
 * @param {ArrayBuffer} log
 * @param {string} name
 * @param {Hear<"look">} hear
 * @returns {Run}
 */
export function look(log, name, hear) {
  const runner = runs.take()
  runner.do({ kind: "look", log, name }, hear)
  return runner
}

/**
 * The test that pins what a run showed, made where nothing of that run is. Error: it could not be made, in words.
 *
 * @param {Omit<import("./protocol.js").PinJob, "kind">} shown
 * @returns {Promise<string>}
 */
export function pin(shown) {
  return new Promise((resolve, reject) =>
    runs.take().do({ kind: "pin", ...shown }, (message) => {
      if (message.kind === "end") resolve(message.result.test)
      if (message.kind === "failed") reject(new Error(message.reason))
    }),
  )
}

/**
 * Run an answer in one sandbox, and have what came of that judged in another.
 *
 * @param {Text} job
 * @param {(message: Told) => void} hear
 */
function answer(job, hear) {
  const { exercise, source: text } = job
  const [running, judging] = [runs.take(), judges.take()]
  let ended = false
  const run = {
    end() {
      ended = true
      running.end()
      judging.end()
    },
  }
  const begin = async () => {
    const files = await compiledOf([job], (message) => ended || hear(message))
    if (!files) return run.end()
    running.do({ kind: "trace", exercise, text, programs: files.map(({ name }) => name) }, (message) => {
      if (message.kind !== "end") return hear(message)
      judging.do({ kind: "judge", exercise, text, trace: message.result.trace }, (message) => {
        if (message.kind === "begun") return
        hear(message.kind === "end" ? { kind: "end", result: told(message.result, hear) } : message)
      })
    }, files)
  }
  begin().catch((error) => ended || hear(failed(error)))
  return run
}

/**
 * Tell what was said of an answer; what is left to say at the end of its run.
 *
 * @param {Results["judge"]} result
 * @param {(message: Told) => void} hear
 * @returns {Judged}
 */
function told({ verdict, solved, status, console, said, drive }, hear) {
  const texts = [console, said.replaceAll("`", "")].filter(Boolean) // a console is no Markdown
  const isError = verdict === "not judged"
  hear({ kind: "batch", chunks: texts.map((text, number) => [isError, `${text}\n`, number, 0]), leftOut: 0, ticks: [] })
  return { verdict: isError ? "" : status, solved, drive }
}
