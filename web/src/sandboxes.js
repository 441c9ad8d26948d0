// Judges answers in a sandbox: a frame without the site's origin, which may ask for nothing, and in it a worker with a
// fresh Python for each answer. What an answer does there reaches neither the page, nor the browser's stores, nor the
// network, nor another answer.

import { MOST } from "./answers.js"
import { make } from "./make.js"

/** For how long (ms) an answer may run, and for how long Python may start. */
const TIME = 20_000
const START = 60_000

/** What comes out of a sandbox is at most so long (characters), as JSON; rosspin.page.judge keeps far below it. */
const LONGEST = 500_000

const VERDICTS = ["solved", "not yet", "to read", "not judged"]

const notJudged = (said) => ({ verdict: "not judged", said })

const STOPPED_SAID = "Stopped before it was judged. Drop the file again to have it judged."
export const STOPPED = { verdict: "stopped", said: STOPPED_SAID }

async function load(address, how) {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`${response.status} ${address}`)
  return response[how]()
}

async function loadSnapshot(live) {
  const packed = await load(`${live}snapshot.gz?${SNAPSHOT}`, "blob")
  return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer()
}

/** What sandboxes need. `base` is the address of the folder that our files are in. */
async function loadAll(base) {
  const live = new URL("../live/", base).href
  const [script, module, rosspin, wasm, stdlib, snapshot] = await Promise.all([
    load(`${base}answer.js`, "text"),
    load(`${live}pyodide.asm.mjs`, "text"),
    load(`${live}rosspin.zip?${SNAPSHOT}`, "arrayBuffer"),
    load(`${live}pyodide.asm.wasm`, "arrayBuffer"),
    load(`${live}python_stdlib.zip`, "arrayBuffer"),
    loadSnapshot(live).catch(() => null), // without it, Python starts plainly
  ])
  return { script, module, rosspin, wasm, stdlib, snapshot }
}

let loading = null

export class Sandbox {
  #base
  #frame = null

  constructor(base) {
    this.#base = base
  }

  /** The verdict on an answer, and what was said of it. Stopped when the AbortSignal says so. */
  async judge(number, answer, stopped) {
    if (answer.length > MOST.answer) {
      return notJudged(`It has ${answer.length} characters; at most ${MOST.answer} are judged.`)
    }
    try {
      this.#frame ??= await this.#open()
    } catch {
      loading = null
      return notJudged("Python could not be loaded. Is the site still there?")
    }
    if (stopped.aborted) return STOPPED
    const { port1, port2 } = new MessageChannel()
    let timer
    const verdict = await new Promise((resolve) => {
      const limit = (ms, result) => {
        clearTimeout(timer)
        timer = setTimeout(() => resolve(result), ms)
      }
      limit(START, notJudged("Python did not start."))
      port1.onmessage = ({ data }) => {
        if (data === "begun") limit(TIME, { verdict: "did not end", said: `It was ended after ${TIME / 1000} s.` })
        else resolve(read(data))
      }
      stopped.addEventListener("abort", () => resolve(STOPPED))
      this.#frame.contentWindow.postMessage({ number, answer }, "*", [port2])
    })
    clearTimeout(timer)
    if (!verdict.heard) this.end() // whatever it does now
    port1.close()
    return verdict
  }

  async #open() {
    loading ??= loadAll(this.#base)
    const files = await loading
    const src = `${this.#base}sandbox.html`
    const frame = make("iframe", { sandbox: "allow-scripts", hidden: true, title: "Sandbox", src })
    const loaded = new Promise((resolve) => frame.addEventListener("load", resolve))
    document.body.append(frame)
    await loaded
    frame.contentWindow.postMessage(files, "*")
    return frame
  }

  /** End all that runs in it. */
  end() {
    this.#frame?.remove()
    this.#frame = null
  }
}

/** What came out of a sandbox; it is not trusted. */
function read(data) {
  try {
    const { verdict, said } = typeof data === "string" && data.length <= LONGEST ? JSON.parse(data) : {}
    if (VERDICTS.includes(verdict) && typeof said === "string") return { verdict, said, heard: true }
  } catch {
    // see below
  }
  return notJudged("The sandbox gave no verdict.")
}
