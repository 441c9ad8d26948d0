// Python in a worker. It is sent one job at a time, and sends what comes of it.

import { info } from "pyodide/pyodide-lock.json"
import { loadPyodide } from "./pyodide.mjs"
import { signals } from "./signals.js"
import { install, LIBRARY, options, PACKAGES } from "./start.js"

// What is printed is sent so often (ms), and no more than so much (characters) of it at a time.
const INTERVAL = 50
const MOST = 50_000

/** What Python sees of the page. What it prints and when it ticks is gathered, so that a flood does not drown it. */
class Page {
  #chunks = []
  #count = 0
  #size = 0
  #leftOut = 0
  #ticks = []
  #sent = 0
  #timer = null

  print(text, isError, line) {
    this.#chunks.push([isError, text, this.#count++, line])
    this.#size += text.length
    while (this.#size > MOST && this.#chunks.length > 1) {
      const [, dropped] = this.#chunks.shift()
      this.#size -= dropped.length
      this.#leftOut += dropped.split("\n").length - 1
    }
    this.#soon()
  }

  tick(source, number, expected, real) {
    this.#ticks.push([source, number, expected, real, 0])
    this.#soon()
  }

  wait(ms) {
    return new Promise((resolve) => setTimeout(resolve, ms))
  }

  #soon() {
    const left = this.#sent + INTERVAL - performance.now()
    if (left <= 0) this.send()
    else this.#timer ??= setTimeout(() => this.send(), left)
  }

  send() {
    clearTimeout(this.#timer)
    this.#timer = null
    this.#sent = performance.now()
    if (this.#chunks.length || this.#ticks.length) {
      postMessage({ kind: "batch", chunks: this.#chunks, leftOut: this.#leftOut, ticks: this.#ticks })
    }
    this.#chunks = []
    this.#size = this.#leftOut = 0
    this.#ticks = []
  }
}

/** What Python is told where a file cannot be read: the number of an input/output error. */
const EIO = 29

const address = (name) => new URL(name, import.meta.url).href

/** What keeps the snapshot across pages; undefined where the browser offers nothing of the kind, as without https. */
const opening = globalThis.caches?.open("rosspin").catch(() => undefined)

// The address of the memory snapshot says which one it is. What it knows of our files holds for these only.
const url = address(`snapshot.gz?${SNAPSHOT}`)
const ours = address(`rosspin.zip?${SNAPSHOT}`)

async function load(response) {
  if (!response.ok) throw new Error(`${response.status} ${url}`)
  return new Response(response.body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer()
}

/** Keep the snapshot, and none of earlier visits. */
async function keep(cache, response) {
  try {
    for (const key of await cache.keys()) if (key.url !== url) await cache.delete(key)
    await cache.put(url, response)
  } catch {
    // There is no room for it: the next page loads it again.
  }
}

/**
 * A file that is loaded when Python first opens it. Where that fails, opening it does, and is tried again the next time;
 * Emscripten's own such files break Python down then.
 */
function createLazyFile(FS, path, url, size) {
  FS.writeFile(path, "")
  const { node } = FS.lookupPath(path)
  const usual = node.stream_ops
  const open = () => {
    const request = new XMLHttpRequest()
    request.open("GET", url, false)
    request.responseType = "arraybuffer"
    try {
      request.send()
    } catch {
      throw new FS.ErrnoError(EIO) // the server is gone
    }
    if (request.status !== 200 || request.response.byteLength !== size) throw new FS.ErrnoError(EIO)
    node.contents = new Uint8Array(request.response)
    node.usedBytes = size
    node.stream_ops = usual
  }
  node.stream_ops = { ...usual, open }
}

async function startFromSnapshot() {
  const cache = await opening
  const kept = await cache?.match(url)
  const response = kept ?? (await fetch(url))
  const copy = cache && !kept && response.clone()
  const _loadSnapshot = load(response)
  _loadSnapshot.catch(() => {}) // it is awaited later, and until then nobody would have handled it
  // All that most nodes need is in the snapshot. The standard library and our own files are loaded when one of them is
  // read: for an import, or a line of a traceback. Pyodide insists on a file in the first one's place: this one is here.
  const python = await loadPyodide({ ...options(info), stdLibURL: import.meta.url, _loadSnapshot })
  if (copy) keep(cache, copy) // now that it is known to be whole
  createLazyFile(python.FS, `${LIBRARY}/python314.zip`, address("python_stdlib.zip"), SIZES.stdlib)
  createLazyFile(python.FS, `${PACKAGES}/rosspin.zip`, ours, SIZES.ours)
  return python
}

async function startPlainly() {
  const loading = fetch(ours).then((response) => response.bytes())
  const python = await loadPyodide(options(info))
  install(python, await loading)
  return python
}

async function boot() {
  const python = await startFromSnapshot().catch(async () => {
    await globalThis.caches?.delete("rosspin").catch(() => {}) // what was kept may be what is broken
    return startPlainly()
  })
  const { run, wake } = python.pyimport("rosspin.page")
  wake()
  python.setInterruptBuffer(signals)
  python.setStdin({ stdin: () => null }) // there is nobody to ask: EOFError
  return run
}

function fail(error) {
  postMessage({ kind: "failed", reason: `Python itself broke down: ${error}` })
}

const booting = boot()
booting.then(
  () => postMessage({ kind: "ready" }),
  (error) => postMessage({ kind: "failed", reason: `Python could not be started: ${error}` }),
)

addEventListener("message", async ({ data: { source, filename, seconds, args, speed } }) => {
  const run = await booting
  const page = new Page()
  try {
    signals.last = performance.now()
    const result = JSON.parse(await run.callPromising(source, filename, seconds, args, speed, page))
    signals.last = Infinity
    page.send()
    postMessage({ kind: "end", result })
  } catch (error) {
    page.send()
    fail(error)
  }
})

// What breaks Python itself, such as os.abort(), ends no run; it shows here.
addEventListener("unhandledrejection", ({ reason }) => fail(reason))
