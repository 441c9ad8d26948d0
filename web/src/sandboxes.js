// Code runs in a sandbox: a frame without the site's origin, which may ask for nothing, and in it a worker with a
// Python of its own. What code does there reaches neither the page, nor the browser's stores, nor the network, nor other
// code.

import { Fault, load, loadSnapshot, sandboxPage } from "./files.js"
import { make } from "./make.js"
import { ALL, read } from "./protocol.js"

/** A frame that has loaded has said so before; its word is waited for so long (ms). */
const WORD = 5000

/** What Python starts from, which a sandbox begins to compile and to unpack while it comes, and what it may need later on. */
const WASM = "pyodide.asm.wasm"
const SNAPSHOT = "snapshot.gz"
const LATE = ["python_stdlib.zip", "rosspin.zip"]

/** A file that was asked for: `bytes` is a promise, and a sandbox is given its parts as they come. */
class Loading {
  #parts = []
  #followers = []

  constructor(name) {
    const hear = (part) => {
      this.#parts = part ? [...this.#parts, part] : []
      for (const give of this.#followers) give(part)
    }
    this.bytes = name === SNAPSHOT ? snapshotIfThere(hear) : load(name, hear)
    const end = () => (this.#parts = this.#followers = null)
    this.bytes.then(end, end)
  }

  /** Call `give` with each part, from the first on, and with null if those until then were wrong; not if all is here. */
  follow(give) {
    this.#parts?.forEach((part) => give(part))
    this.#followers?.push(give)
  }
}

/** What every sandbox starts from, as soon as it was asked for: name -> Loading. */
const files = new Map()

function file(name) {
  if (!files.has(name)) {
    const loading = new Loading(name)
    files.set(name, loading)
    const forget = () => files.delete(name) // the next one may have more luck
    loading.bytes.then((bytes) => bytes || forget(), forget)
  }
  return files.get(name)
}

/** Without a snapshot, Python starts plainly. One that is not the right one is a fault of the site. */
async function snapshotIfThere(hear) {
  try {
    return await loadSnapshot(hear)
  } catch (error) {
    if (error instanceof Fault) throw error
    return null
  }
}

/** A frame of a sandbox that is ready to be sent something. Error: it could not be loaded. */
function open(frame) {
  return new Promise((resolve, reject) => {
    const hear = ({ source }) => source === frame.contentWindow && end(resolve)
    const end = (act) => {
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

/** One sandbox: a Python that has started, or is about to. It does one job after the other; one is enough. */
export class Sandbox {
  #frame = make("iframe", { sandbox: "allow-scripts", hidden: true, title: "Sandbox", src: sandboxPage })
  #port = null
  #job = null // the kind of what it does
  #hear = () => {}
  #start

  constructor() {
    /** A promise of its first message: it is ready, or has failed. */
    this.started = new Promise((resolve) => (this.#start = resolve))
    this.#open()
  }

  async #open() {
    const { port1, port2 } = new MessageChannel()
    const wasm = new MessageChannel() // past the page of the sandbox, which has a snapshot to unpack
    try {
      const opened = open(this.#frame)
      const [first, code, snapshot] = ["worker.js", WASM, SNAPSHOT].map(file)
      const [script] = await Promise.all([first.bytes, opened])
      if (!this.#frame) return
      this.#port = port1
      port1.onmessage = ({ data }) => this.#receive(data)
      this.#frame.contentWindow.postMessage(script, "*", [port2, wasm.port2]) // it has no origin that could be named
      await Promise.all([this.#pass(WASM, code, wasm.port1), this.#pass(SNAPSHOT, snapshot, port1)])
    } catch (error) {
      this.#start({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })
    } finally {
      wasm.port1.close() // before anybody's code runs there: nothing is heard on it
    }
  }

  /** Pass a file on: if it is still coming, in parts, which are used once it is known that they are right. */
  async #pass(name, loading, port) {
    let inParts = false
    loading.follow((bytes) => {
      inParts = true
      port.postMessage({ kind: "part", name, bytes })
    })
    const bytes = await loading.bytes
    port.postMessage({ kind: "file", name, bytes: inParts && bytes ? ALL : bytes })
  }

  #receive(text) {
    const message = read(text, this.#job) ?? { kind: "failed", reason: "The sandbox said what this page does not understand." }
    if (message.kind === "need") return this.#give(message.name)
    if (message.kind === "ready") return this.#start(message)
    if (message.kind === "failed") this.#start(message) // if it had not started yet
    this.#hear(message)
  }

  async #give(name) {
    const bytes = LATE.includes(name) ? await load(name).catch(() => null) : null
    this.#port?.postMessage({ kind: "file", name, bytes })
  }

  /** Do a job; `hear(message)` is called with what comes of it. */
  do(job, hear) {
    this.#job = job.kind
    this.#hear = hear
    this.#port.postMessage(job)
  }

  /** End all that runs in it, at once. */
  end() {
    this.#port?.close()
    this.#frame?.remove()
    this.#port = this.#frame = null
    this.#hear = () => {}
  }
}
