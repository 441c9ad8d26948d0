// Code runs in a sandbox: a frame without the site's origin, which may ask for nothing, and in it a worker with a
// Python of its own. What code does there reaches neither the page, nor the browser's stores, nor the network, nor other
// code.

import { Fault, load, loadSnapshot, sandboxPage } from "./files.js"
import { make } from "./make.js"
import { read } from "./protocol.js"

/** A frame that has loaded has said so before; its word is waited for so long (ms). */
const WORD = 5000

/** What Python starts from, and what it may need later on. */
const WASM = "pyodide.asm.wasm"
const SNAPSHOT = "snapshot.gz"
const LATE = ["python_stdlib.zip", "rosspin.zip"]

/** What every sandbox starts from, as soon as it was asked for: name -> a promise of the bytes. */
const files = new Map()

function file(name) {
  if (!files.has(name)) {
    const loading = name === SNAPSHOT ? snapshotIfThere() : load(name)
    files.set(name, loading)
    const forget = () => files.delete(name) // the next one may have more luck
    loading.then((bytes) => bytes || forget(), forget)
  }
  return files.get(name)
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
    try {
      const opened = open(this.#frame)
      const [first, ...coming] = ["worker.js", WASM, SNAPSHOT].map((name) => file(name))
      const [script] = await Promise.all([first, opened])
      if (!this.#frame) return
      this.#port = port1
      port1.onmessage = ({ data }) => this.#receive(data)
      this.#frame.contentWindow.postMessage(script, "*", [port2]) // it has no origin that could be named
      // One after the other: that which is to be compiled does not wait for the other one to be unpacked.
      this.#pass(WASM, await coming[0])
      this.#pass(SNAPSHOT, await coming[1])
    } catch (error) {
      this.#start({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })
    }
  }

  #pass(name, bytes) {
    this.#port?.postMessage({ kind: "file", name, bytes })
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
    this.#pass(name, bytes)
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
