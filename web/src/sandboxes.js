// Code runs in a sandbox: a frame without the site's origin, which may ask for nothing, and in it a worker with a
// Python of its own. What code does there reaches neither the page, nor the browser's stores, nor the network, nor other
// code.

import { Fault, load, loadSnapshot, sandboxPage } from "./files.js"
import { make } from "./make.js"
import { ALL, read } from "./protocol.js"

/** A frame that has loaded has said so before; its word is waited for so long (ms). */
const WORD = 5000

/** What Python starts from, and what it may need later on. */
const SNAPSHOT = "snapshot.gz"
const FIRST = ["pyodide.asm.wasm", "pyodide.asm.mjs", SNAPSHOT]

/** The large ones of these. A sandbox begins to compile and to unpack them while they come. */
const LARGE = ["pyodide.asm.wasm", SNAPSHOT]
const LATE = ["python_stdlib.zip", "rosspin.zip"]

/** @typedef {(part: Uint8Array<ArrayBuffer> | null) => void} HearPart */

/** A file that was asked for: `bytes` is a promise, and a sandbox is given its parts as they come. */
class Loading {
  /** @type {Uint8Array<ArrayBuffer>[] | null} */
  #parts = []
  /** @type {HearPart[] | null} */
  #followers = []

  /** @param {string} name */
  constructor(name) {
    /** @type {HearPart} */
    const hear = (part) => {
      this.#parts = part ? [...(this.#parts ?? []), part] : []
      for (const give of this.#followers ?? []) give(part)
    }
    this.bytes = name === SNAPSHOT ? snapshotIfThere(hear) : load(name, hear)
    const end = () => (this.#parts = this.#followers = null)
    this.bytes.then(end, end)
  }

  /**
   * Call `give` with each part, from the first on, and with null if those until then were wrong; not if all is here.
   *
   * @param {HearPart} give
   */
  follow(give) {
    this.#parts?.forEach((part) => give(part))
    this.#followers?.push(give)
  }
}

/** @type {Map<string, Loading>} what every sandbox starts from, as soon as it was asked for, by its name */
const files = new Map()

/** @param {string} name */
function file(name) {
  const known = files.get(name)
  if (known) return known
  const loading = new Loading(name)
  files.set(name, loading)
  const forget = () => files.delete(name) // the next one may have more luck
  loading.bytes.then((bytes) => bytes || forget(), forget)
  return loading
}

/**
 * Without a snapshot, Python starts plainly. One that is not the right one is a fault of the site.
 *
 * @param {HearPart} hear
 */
async function snapshotIfThere(hear) {
  try {
    return await loadSnapshot(hear)
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

const NOT_LOADED = "Python could not be loaded. Is the site still there?"
const NOT_OPENED = "The frame in which Python runs did not open. Is the site still there, and does the browser sandbox frames?"

/** @typedef {import("./protocol.js").Results} Results */

/** One sandbox: a Python that has started, or is about to. It does one job after the other; one is enough. */
export class Sandbox {
  /** @type {HTMLIFrameElement | null} */
  #frame = make("iframe", { sandbox: "allow-scripts", hidden: true, title: "Sandbox", src: sandboxPage })
  /** @type {MessagePort | null} */
  #port = null
  /** @type {keyof Results | null} */
  #job = null // the kind of what it does
  /** @type {(message: any) => void} */
  #hear = () => {}
  /** @type {(message: import("./protocol.js").Ready | import("./protocol.js").Failed) => void} */
  #start = () => {}

  constructor() {
    /**
     * A promise of its first message: it is ready, or has failed.
     *
     * @type {Promise<import("./protocol.js").Ready | import("./protocol.js").Failed>}
     */
    this.started = new Promise((resolve) => (this.#start = resolve))
    this.#open()
  }

  async #open() {
    const { port1, port2 } = new MessageChannel()
    const frame = /** @type {HTMLIFrameElement} */ (this.#frame)
    try {
      const first = file("worker.js").bytes
      const coming = FIRST.map((name) => ({ name, loading: file(name) }))
      const [script] = await Promise.all([first, open(frame)])
      if (!this.#frame) return
      this.#port = port1
      port1.onmessage = ({ data }) => this.#receive(data)
      frame.contentWindow?.postMessage(script, "*", [port2]) // it has no origin that could be named
      await Promise.all(coming.map(({ name, loading }) => this.#pass(name, loading)))
    } catch (error) {
      this.#start({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })
    }
  }

  /** @param {import("./protocol.js").ToSandbox} message */
  #say(message) {
    this.#port?.postMessage(message)
  }

  /**
   * Pass a file on: if it is still coming, in parts, which are used once it is known that they are right.
   *
   * @param {string} name
   * @param {Loading} loading
   */
  async #pass(name, loading) {
    let inParts = false
    /** @type {HearPart} */
    const give = (bytes) => {
      inParts = true
      this.#say({ kind: "part", name, bytes })
    }
    if (LARGE.includes(name)) loading.follow(give)
    const bytes = await loading.bytes
    this.#say({ kind: "file", name, bytes: inParts && bytes ? ALL : bytes })
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

  /** @param {string} name */
  async #give(name) {
    const bytes = LATE.includes(name) ? await load(name).catch(() => null) : null
    this.#say({ kind: "file", name, bytes })
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

  /** End all that runs in it, at once. */
  end() {
    this.#port?.close()
    this.#frame?.remove()
    this.#port = this.#frame = null
    this.#hear = () => {}
  }
}
