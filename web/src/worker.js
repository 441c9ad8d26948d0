// Python in the worker of a sandbox. It is sent all that it starts from, then jobs, one at a time, and says what comes of
// them: see protocol.js. It can ask for nothing but the files that the page has for it.

// @ts-expect-error: Pyodide does not describe it
import createPyodideModule from "pyodide/pyodide.asm.mjs"
import { info } from "pyodide/pyodide-lock.json"
import { Beside } from "../../src/rosspin/cpp/js/beside.mjs"
import { LONGEST } from "./limits.js"
import { filled, HEAD, restore } from "./memory.js"
import { Page } from "./page.js"
import { signals } from "./signals.js"
import { install, LIBRARY, options, PACKAGES } from "./start.js"

// Python has at most so much memory (bytes): more than ten times what it needs to start, and so little that a computer
// of 4 GB can judge four answers at the same time.
const MOST_MEMORY = 512 * 2 ** 20
const PAGE = 2 ** 16

/** What is asked for when it is needed: the standard library and our own files. */
const LATE = ["python_stdlib.zip", "rosspin.zip"]

/** What Python is told where a file cannot be read: the number of an input/output error. */
const EIO = 29

const MOST = Math.max(...Object.values(LONGEST).map(({ characters }) => characters))
const send = postMessage.bind(globalThis)

/**
 * Send a text, if it can be one that the page takes; or else what it takes for too much. Anything else would be unpacked
 * before it can be refused, in some browsers by the thread of the page. No code here has another way to send.
 *
 * @param {unknown} text
 */
const post = (text) => send(typeof text === "string" && text.length <= MOST ? text : null)
for (let owner = globalThis; owner; owner = Object.getPrototypeOf(owner)) {
  if (Object.hasOwn(owner, "postMessage")) Object.defineProperty(owner, "postMessage", { value: post })
}
function say(/** @type {import("./protocol.js").FromSandbox} */ message) {
  const text = JSON.stringify(message)
  post(text)
  return text
}

// --- files that the page has ---

/** @typedef {import("./protocol.js").File["bytes"]} Bytes or null if the page could not get them */

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
   * @param {any} FS Pyodide's
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

/**
 * Start Python: itself, and what to call before it reads a file. `snapshot`, if it is given, is a promise of one. Until
 * that is kept, Python gets as far as it can without: so much takes as long as to unpack a snapshot.
 *
 * @param {Promise<WebAssembly.Module>} compiled
 * @param {Promise<Bytes>} [snapshot]
 */
async function start(compiled, snapshot) {
  // All that most nodes need is in the snapshot. The standard library and our own files are asked for when one of them is
  // read: for an import, or a line of a traceback. Pyodide insists on a file in the first one's place.
  const [stdlib, ours] = snapshot ? ["-"] : await Promise.all(LATE.map(ask))
  if (!stdlib) throw new Error("its files cannot be had")
  globalThis.fetch = async () => new Response(/** @type {BodyInit} */ (stdlib)) // there is nothing else that Pyodide asks for
  /** @type {Uint8Array} */
  let fresh
  WebAssembly.instantiateStreaming = async (_, imports) => {
    const module = await compiled
    const instance = await WebAssembly.instantiate(module, imports)
    if (snapshot) fresh = filled(/** @type {WebAssembly.Memory} */ (instance.exports.memory))
    return { module, instance }
  }
  /** @type {any} */ // Pyodide says less of it than there is
  const given = { ...options(info), stdout() {}, stderr() {}, stdin: () => null, indexURL: import.meta.url, createPyodideModule }
  if (snapshot) {
    const head = new Uint8Array(HEAD)
    given._loadSnapshot = Promise.resolve(head)
    given.createPyodideModule = async (/** @type {unknown} */ settings) => {
      const module = await createPyodideModule(settings)
      restore(/** @type {ArrayBuffer} */ (await snapshot), head, module.HEAPU8, fresh)
      return module
    }
  }
  // Not before, and not with the rest: it tries what is refused here, and developer tools note from where.
  const { loadPyodide } = await import("pyodide/pyodide.mjs")
  const python = await loadPyodide(given)
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
  const compiled = file("pyodide.asm.wasm").promise.then((bytes) => WebAssembly.compile(/** @type {ArrayBuffer} */ (bytes)))
  compiled.catch(() => {}) // it is awaited later
  await new Promise((go) => setTimeout(go)) // if the file is here, others compile it while this thread continues
  const { python, supply } = await start(compiled, file("snapshot.zst").promise).catch(() => start(compiled))
  files.clear() // what it started from; more is asked for
  const page = python.pyimport("rosspin.page")
  page.wake(supply)
  python.setInterruptBuffer(/** @type {any} */ (signals))
  python.setStdin({ stdin: () => null }) // no one can be asked: EOFError
  return page
}

// --- jobs ---

/** What Python sees of the page, and of nodes in C++ that run together with its own. */
class PageOfPython extends Page {
  /** @type {Map<string, WebAssembly.Module>} by the names of their files */
  programs = new Map()

  /** Have these ready, which have been sent. */
  async take(/** @type {string[]} */ names) {
    for (const name of names) {
      const { promise } = file(name)
      this.programs.set(name.replace(/\.gz$/, ""), new WebAssembly.Module(/** @type {ArrayBuffer} */ (await promise)))
      files.delete(name)
    }
  }

  program(/** @type {string} */ name) {
    return new Beside(/** @type {WebAssembly.Module} */ (this.programs.get(name)))
  }
}

/**
 * A file as Python reads it: no more comes into memory than is asked for.
 *
 * @param {Blob | null} file
 * @returns {import("./protocol.js").Readable}
 */
function readable(file) {
  const read = (/** @type {number} */ from, /** @type {number} */ to) => {
    if (!file) throw new Error("the browser does not give it")
    return new Uint8Array(new FileReaderSync().readAsArrayBuffer(file.slice(from, to)))
  }
  return { size: file?.size ?? 0, read }
}

/**
 * Do a job, with the functions of rosspin.page: what came of it.
 *
 * @param {import("./protocol.js").PythonPage} python
 * @param {import("./protocol.js").PythonJob} job
 * @param {PageOfPython} page
 * @returns {Promise<import("./protocol.js").Results[keyof import("./protocol.js").Results]>}
 */
async function act({ run, trace, judge, look, pin, read, answer, report }, job, page) {
  if (job.kind === "run") {
    const { source, filename, seconds, args, speed, beside, programs, files: texts } = job
    await page.take(programs)
    const more = [beside, texts].map((each) => JSON.stringify(each))
    return JSON.parse(await run.callPromising(source, filename, seconds, args, speed, more[0], more[1], page))
  }
  if (job.kind === "look") return JSON.parse(await look.callPromising(job.log, job.name))
  if (job.kind === "pin") {
    const { source, filename, seconds, args, console, ticks } = job
    return { test: await pin.callPromising(source, filename, seconds, args, console, JSON.stringify(ticks)) }
  }
  if (job.kind === "read") {
    const paths = job.files.map(({ path }) => path)
    return JSON.parse(await read.callPromising(JSON.stringify(paths), job.files.map(({ file }) => readable(file))))
  }
  if (job.kind === "answer") return JSON.parse(await answer.callPromising(job.number, job.exercise))
  if (job.kind === "report") return JSON.parse(await report.callPromising(JSON.stringify(job.verdicts)))
  if (job.kind === "trace") {
    await page.take(job.programs)
    return { trace: await trace.callPromising(job.exercise, job.text, page) }
  }
  return JSON.parse(await judge.callPromising(job.exercise, job.text, job.trace))
}

const fail = (/** @type {string} */ reason) => say({ kind: "failed", reason: reason.slice(0, 1000) })
const broke = (/** @type {unknown} */ error) => fail(`Python itself broke down: ${error}`)

const booting = boot()
booting.then(
  () => say({ kind: "ready" }),
  (error) => fail(`Python could not be started: ${error}`),
)

addEventListener("message", async (/** @type {MessageEvent<import("./protocol.js").PythonJob | import("./protocol.js").File>} */ { data }) => {
  if (data.kind === "file") return file(data.name).resolve(data.bytes)
  const python = await booting
  const page = new PageOfPython(say)
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
