// Python in the worker of a sandbox. It is sent all that it starts from, then jobs, one at a time, and says what comes of
// them: see protocol.js. It can ask for nothing but the files that the page has for it.

import { info } from "pyodide/pyodide-lock.json"
import { loadPyodide } from "pyodide/pyodide.mjs"
import { ALL } from "./protocol.js"
import { signals } from "./signals.js"
import { install, LIBRARY, options, PACKAGES } from "./start.js"

// What is printed is sent so often (ms), and no more than so much (characters), and so many ticks, of it at a time.
const INTERVAL = 50
const MOST = 50_000
const MOST_TICKS = 2000

// Python has at most so much memory (bytes): more than ten times what it needs to start, and so little that a computer
// of 4 GB can judge four answers at once.
const MOST_MEMORY = 512 * 2 ** 20
const PAGE = 2 ** 16

/** What is asked for when it is needed: the standard library and our own files. */
const LATE = ["python_stdlib.zip", "rosspin.zip"]

// Where Pyodide believes that its files are.
const NOWHERE = "memory:/"

/** What Python is told where a file cannot be read: the number of an input/output error. */
const EIO = 29

/** @type {(text: string) => void} */
const post = postMessage.bind(globalThis)
const say = (/** @type {import("./protocol.js").FromSandbox} */ message) => post(JSON.stringify(message))

/** @typedef {import("./protocol.js").Shown} Shown */

/**
 * What Python sees of the page. What it prints and when it ticks is gathered, so that a flood does not drown it.
 *
 * @implements {Shown}
 */
class Page {
  /** @type {import("./protocol.js").Chunk[]} */
  #chunks = []
  #count = 0
  #size = 0
  #leftOut = 0
  /** @type {import("./protocol.js").Tick[]} */
  #ticks = []
  #sent = 0
  /** @type {number | undefined} */
  #timer

  /**
   * @param {string} text
   * @param {boolean} isError
   * @param {number} line
   */
  print(text, isError, line) {
    if (text.length > MOST) {
      const dropped = text.slice(0, -MOST)
      text = text.slice(-MOST)
      this.#leftOut += lines(dropped)
    }
    this.#chunks.push([isError, text, this.#count++, line])
    this.#size += text.length
    while (this.#size > MOST && this.#chunks.length > 1) {
      const [[, dropped]] = this.#chunks.splice(0, 1)
      this.#size -= dropped.length
      this.#leftOut += lines(dropped)
    }
    this.#soon()
  }

  /**
   * @param {string} source
   * @param {number} number
   * @param {number} expected
   * @param {number} real
   */
  tick(source, number, expected, real) {
    this.#ticks.push([source, number, expected, real, 0])
    if (this.#ticks.length >= 2 * MOST_TICKS) this.#ticks.splice(0, MOST_TICKS)
    this.#soon()
  }

  /**
   * @param {number} ms
   * @returns {Promise<void>}
   */
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
    this.#timer = undefined
    this.#sent = performance.now()
    if (this.#chunks.length || this.#ticks.length) {
      say({ kind: "batch", chunks: this.#chunks, leftOut: this.#leftOut, ticks: this.#ticks.slice(-MOST_TICKS) })
    }
    this.#chunks = []
    this.#size = this.#leftOut = 0
    this.#ticks = []
  }
}

/**
 * How many lines end in a text.
 *
 * @param {string} text
 */
function lines(text) {
  let count = 0
  for (let end = text.indexOf("\n"); end >= 0; end = text.indexOf("\n", end + 1)) count++
  return count
}

// --- files that the page has ---

/** @typedef {import("./protocol.js").Whole["bytes"]} Bytes or null if the page could not get them */

/** @type {Map<string, PromiseWithResolvers<Bytes>>} with what files are promised, by their names */
const files = new Map()

/**
 * A file that the page sends, or null.
 *
 * @param {string} name
 */
function file(name) {
  const promised = files.get(name) ?? Promise.withResolvers()
  files.set(name, promised)
  return promised
}

/**
 * One that it sends when it is asked to.
 *
 * @param {string} name
 */
function ask(name) {
  files.delete(name)
  say({ kind: "need", name })
  return file(name).promise
}

/**
 * A file that is asked for when Python is about to read it. `supply()` is a promise until it is here, or is known not to
 * come this time; opening it fails then.
 */
class LateFile {
  #FS
  #node
  #name
  #usual
  /** @type {Promise<void> | null} */
  #asking = null

  /**
   * @param {any} FS that of Pyodide
   * @param {string} path
   * @param {string} name
   */
  constructor(FS, path, name) {
    FS.writeFile(path, "")
    this.#FS = FS
    this.#node = FS.lookupPath(path).node
    this.#name = name
    this.#usual = this.#node.stream_ops
    const open = () => {
      throw new FS.ErrnoError(EIO)
    }
    this.#node.stream_ops = { ...this.#usual, open }
  }

  supply() {
    if (this.#node.stream_ops === this.#usual) return undefined
    this.#asking ??= ask(this.#name).then((bytes) => {
      this.#asking = null
      if (!(bytes instanceof ArrayBuffer)) return
      this.#node.contents = new Uint8Array(bytes)
      this.#node.usedBytes = bytes.byteLength
      this.#node.stream_ops = this.#usual
    })
    return this.#asking
  }
}

// --- how Python starts ---

/** Let no memory grow beyond what a run may have. Python raises MemoryError then. */
function limitMemory() {
  const { prototype } = WebAssembly.Memory
  const { grow } = prototype
  prototype.grow = function (pages) {
    if (this.buffer.byteLength + pages * PAGE > MOST_MEMORY) throw new RangeError("a run may have no more memory")
    return grow.call(this, pages)
  }
}

async function loadScript() {
  const text = await file("pyodide.asm.mjs").promise
  return (await import(URL.createObjectURL(new Blob([/** @type {ArrayBuffer} */ (text)], { type: "text/javascript" })))).default
}

/** WebAssembly that is compiled while it comes. It is run when all of it is known to be right. */
class Compiling {
  /** @type {ReadableStreamDefaultController | undefined} */
  #controller
  #module

  constructor() {
    const stream = new ReadableStream({
      start: (controller) => {
        this.#controller = controller
      },
    })
    this.#module = WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }))
    this.#module.catch(() => {}) // it is awaited later, if it is right
  }

  /** @param {Uint8Array} part */
  add(part) {
    this.#controller?.enqueue(part)
  }

  end() {
    this.#controller?.close()
    return this.#module
  }
}

/** @type {Compiling | null} */
let compiling = null

/**
 * A part of the WebAssembly has come, or null: those until then were wrong.
 *
 * @param {import("./protocol.js").Part["bytes"]} part
 */
function take(part) {
  compiling = part && (compiling ?? new Compiling())
  if (part) compiling?.add(part)
}

async function compile() {
  const bytes = await file("pyodide.asm.wasm").promise
  if (bytes === ALL && compiling) return compiling.end()
  return WebAssembly.compile(/** @type {ArrayBuffer} */ (bytes))
}

/**
 * Start Python, from `snapshot` if there is one: Python, and what to call before it reads a file.
 *
 * @param {unknown} createPyodideModule
 * @param {Promise<WebAssembly.Module>} compiled
 * @param {Bytes} snapshot
 */
async function start(createPyodideModule, compiled, snapshot) {
  // All that most nodes need is in the snapshot. The standard library and our own files are asked for when one of them is
  // read: for an import, or a line of a traceback. Pyodide insists on a file in the first one's place.
  const [stdlib, ours] = snapshot ? ["-"] : await Promise.all(LATE.map(ask))
  if (!stdlib) throw new Error("its files cannot be had")
  globalThis.fetch = async () => new Response(/** @type {BodyInit} */ (stdlib)) // there is nothing else that Pyodide asks for
  WebAssembly.instantiateStreaming = async (_, imports) => {
    const module = await compiled
    return { module, instance: await WebAssembly.instantiate(module, imports) }
  }
  /** @type {any} */ // Pyodide says less of it than there is
  const given = { ...options(info), stdout() {}, stderr() {}, stdin: () => null, indexURL: NOWHERE, createPyodideModule }
  const python = await loadPyodide({ ...given, _loadSnapshot: snapshot instanceof ArrayBuffer ? Promise.resolve(snapshot) : undefined })
  delete /** @type {Partial<typeof globalThis>} */ (globalThis).fetch // the browser's own is back, which can ask for nothing
  if (!snapshot) {
    install(python, new Uint8Array(/** @type {ArrayBuffer} */ (ours)))
    return { python, supply: () => undefined }
  }
  const paths = [`${LIBRARY}/python314.zip`, `${PACKAGES}/rosspin.zip`]
  const late = new Map(paths.map((path, number) => [path, new LateFile(python.FS, path, LATE[number])]))
  return { python, supply: (/** @type {string} */ path) => late.get(path)?.supply() }
}

async function boot() {
  limitMemory()
  const compiled = compile()
  const snapshot = file("snapshot.gz").promise
  compiled.catch(() => {}) // it is awaited later
  const createPyodideModule = await loadScript()
  const from = (/** @type {Bytes} */ snapshot) => start(createPyodideModule, compiled, snapshot)
  const { python, supply } = await from(await snapshot).catch(() => from(null))
  /** @type {import("./protocol.js").PythonPage} */
  const page = python.pyimport("rosspin.page")
  page.wake(supply)
  python.setInterruptBuffer(/** @type {any} */ (signals))
  python.setStdin({ stdin: () => null }) // there is nobody to ask: EOFError
  return page
}

// --- jobs ---

/**
 * Do a job, with the functions of rosspin.page: what came of it.
 *
 * @param {import("./protocol.js").PythonPage} python
 * @param {import("./protocol.js").Job} job
 * @param {Page} page
 * @returns {Promise<import("./protocol.js").Results[keyof import("./protocol.js").Results]>}
 */
async function act({ run, trace, judge }, job, page) {
  if (job.kind === "run") {
    const { source, filename, seconds, args, speed } = job
    return JSON.parse(await run.callPromising(source, filename, seconds, args, speed, page))
  }
  if (job.kind === "trace") return { trace: await trace.callPromising(job.number, job.text) }
  return JSON.parse(await judge.callPromising(job.number, job.text, job.trace))
}

const fail = (/** @type {string} */ reason) => say({ kind: "failed", reason })
const broke = (/** @type {unknown} */ error) => fail(`Python itself broke down: ${error}`)

const booting = boot()
booting.then(
  () => say({ kind: "ready" }),
  (error) => fail(`Python could not be started: ${error}`),
)

addEventListener("message", async (/** @type {MessageEvent<import("./protocol.js").ToSandbox>} */ { data }) => {
  if (data.kind === "part") return take(data.bytes)
  if (data.kind === "file") return file(data.name).resolve(data.bytes)
  const python = await booting
  const page = new Page()
  try {
    signals.last = performance.now()
    const result = await act(python, data, page)
    signals.last = Infinity
    page.send()
    say({ kind: "end", result })
  } catch (error) {
    page.send()
    broke(error)
  }
})

// What breaks Python itself, such as os.abort(), ends no run; it shows here.
addEventListener("unhandledrejection", ({ reason }) => broke(reason))
