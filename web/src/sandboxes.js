// Code runs in a sandbox: a frame without the site's origin, which may ask for nothing, and in it a worker with a
// Python of its own. What code does there reaches neither the page, nor the browser's stores, nor the network, nor other
// code.

import { Fault, load, loadSnapshot, sandboxPage } from "./files.js"
import { make } from "./make.js"
import { read } from "./protocol.js"

/** A frame that has loaded has said so before; its word is waited for so long (ms). */
const WORD = 5000

/** A file that could not be had is not asked for again before so long (ms). */
const AGAIN = 300

/** What a sandbox runs: its script, what that starts from, and what it may need later on. */
const SNAPSHOT = "snapshot.zst"
export const PYTHON = {
  script: "worker.js",
  files: ["pyodide.asm.wasm", SNAPSHOT],
  late: ["python_stdlib.zip", "rosspin.zip"],
}
export const CPP = { script: "cpp.js", files: [], late: [] }
export const COMPILER = { script: "clang.js", files: [], late: [] }

/** @typedef {Promise<ArrayBuffer | null>} Coming */

/** @type {Map<string, Coming>} what every sandbox starts from, as soon as it was asked for, by its name */
const files = new Map()

/**
 * @param {string} name
 * @returns {Coming}
 */
function file(name) {
  const known = files.get(name)
  if (known) return known
  /** @type {Coming} */
  const loading = name === SNAPSHOT ? snapshotIfThere() : load(name)
  files.set(name, loading)
  const forget = () => files.delete(name) // the next one may have more luck
  loading.then((bytes) => bytes || forget(), forget)
  return loading
}

/** Without a snapshot, Python starts plainly. One that is not the right one is a fault of the site. */
async function snapshotIfThere() {
  try {
    return await loadSnapshot()
  } catch (error) {
    if (error instanceof Fault) throw error
    return null
  }
}

/**
 * A frame of a sandbox that is ready to be sent something. Error: it could not be loaded.
 *
 * @param {HTMLIFrameElement} frame
 * @returns {Promise<void>}
 */
function open(frame) {
  return new Promise((resolve, reject) => {
    const hear = (/** @type {MessageEvent} */ { source }) => source === frame.contentWindow && end(resolve)
    const end = (/** @type {() => void} */ act) => {
      removeEventListener("message", hear)
      act()
    }
    addEventListener("message", hear)
    frame.addEventListener("load", () => setTimeout(end, WORD, () => reject(new Fault(NOT_OPENED))))
    document.body.append(frame)
  })
}

export const NOT_LOADED = "Python could not be loaded. Is the site still there?"
const NOT_OPENED = "The frame in which Python runs did not open. Is the site still there, and does the browser sandbox frames?"

/** @typedef {import("./protocol.js").Results} Results */

/** One sandbox: a Python that has started, or is about to, or what runs a program. It does one job after the other. */
export class Sandbox {
  /** @type {HTMLIFrameElement | null} */
  #frame = make("iframe", { sandbox: "allow-scripts", hidden: true, title: "Sandbox", src: sandboxPage })
  /** @type {MessagePort | null} */
  #port = null
  /** @type {keyof Results | null} */
  #job = null // the kind of what it does
  /** @type {(message: any) => void} */
  #hear = () => {}
  #missing // which files it has not been given, nor will be soon
  /** @type {(message: import("./protocol.js").Ready | import("./protocol.js").Failed) => void} */
  #start = () => {}

  /** @param {{script: string, files: string[], late: string[]}} what it runs */
  constructor({ script, files, late } = PYTHON) {
    this.#missing = new Set(late)
    /**
     * A promise of its first message: it is ready, or has failed.
     *
     * @type {Promise<import("./protocol.js").Ready | import("./protocol.js").Failed>}
     */
    this.started = new Promise((resolve) => (this.#start = resolve))
    this.#open(script, files)
  }

  /**
   * @param {string} name
   * @param {string[]} names
   */
  async #open(name, names) {
    const { port1, port2 } = new MessageChannel()
    const frame = /** @type {HTMLIFrameElement} */ (this.#frame)
    try {
      const opened = open(frame)
      const coming = names.map((each) => /** @type {const} */ ([each, file(each)]))
      const [script] = await Promise.all([file(name), opened])
      if (!this.#frame) return
      this.#port = port1
      port1.onmessage = ({ data }) => this.#receive(data)
      frame.contentWindow?.postMessage(script, "*", [port2]) // it has no origin that could be named
      // One after the other: the one that should be compiled does not wait for the other one to be unpacked.
      for (const [each, promised] of coming) {
        const bytes = await promised
        await new Promise((go) => setTimeout(go)) // others wait for it, too, and each copy of it takes a moment
        this.pass(each, bytes)
      }
    } catch (error) {
      this.#start({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })
    }
  }

  /** @param {import("./protocol.js").ToSandbox} message */
  #say(message) {
    this.#port?.postMessage(message)
  }

  /**
   * Give it a file.
   *
   * @param {string} name
   * @param {ArrayBuffer | null} bytes
   */
  pass(name, bytes) {
    this.#say({ kind: "file", name, bytes })
  }

  /** @param {string} text */
  #receive(text) {
    /** @type {import("./protocol.js").FromSandbox} */
    const message = read(text, this.#job) ?? { kind: "failed", reason: "The sandbox said what this page does not understand." }
    if (message.kind === "need") return this.#give(message.name)
    if (message.kind === "ready") return this.#start(message)
    if (message.kind === "failed") this.#start(message) // if it had not started yet
    this.#hear(message)
  }

  /**
   * Give it a file that it needs, once: code there may ask for it without end.
   *
   * @param {string} name
   */
  async #give(name) {
    if (!PYTHON.late.includes(name)) return this.pass(name, null)
    if (!this.#missing.delete(name)) return
    const bytes = await load(name).catch(() => null)
    if (!bytes) {
      await new Promise((go) => setTimeout(go, AGAIN))
      this.#missing.add(name)
    }
    this.pass(name, bytes)
  }

  /**
   * Do a job; `hear(message)` is called with what comes of it.
   *
   * @template {keyof Results} K
   * @param {Extract<import("./protocol.js").Job, {kind: K}>} job
   * @param {(message: import("./protocol.js").Word<K>) => void} hear
   */
  do(job, hear) {
    this.#job = job.kind
    this.#hear = hear
    this.#say(job)
  }

  /** End all that runs in it, immediately. */
  end() {
    this.#port?.close()
    this.#frame?.remove()
    this.#port = this.#frame = null
    this.#hear = () => {}
  }
}
