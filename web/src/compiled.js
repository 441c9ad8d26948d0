// Loaded when a node in C++ should be compiled. The compiler runs in a sandbox of its own, and serves the next node, too.

import { isCpp } from "./answers.js"
import { advice, faults, shown } from "./faults.js"
import { Fault, loadCompiler } from "./files.js"
import { OF_NO_NODE } from "./limits.js"
import { COMPILER, Sandbox } from "./sandboxes.js"

/** @typedef {import("./runs.js").Node} Node */
/** @typedef {import("./runs.js").Told} Told */
/** @typedef {import("./runs.js").Doing} Doing */

/** @type {{ros: number, sandbox: Promise<Sandbox>} | null} the compiler, for one ROS: it takes much memory */
let compiler = null

/**
 * @param {number} ros
 * @param {(message: Doing) => void} hear
 */
function startCompiler(ros, hear) {
  if (compiler?.ros === ros) return compiler.sandbox
  compiler?.sandbox.then((sandbox) => sandbox.end(), () => {})
  const tell = (/** @type {number} */ loaded, /** @type {number} */ total) =>
    hear({ kind: "doing", said: `loading clang: ${Math.floor(loaded / 1e6)} of ${Math.ceil(total / 1e6)} MB`, share: loaded / total })
  const made = new Sandbox(COMPILER)
  // It unpacks and compiles what it is given while the rest is loading.
  const give = async (/** @type {string} */ name, /** @type {ArrayBuffer} */ bytes) => {
    const message = await made.started
    if (message.kind === "failed") throw new Fault(message.reason)
    made.pass(name, bytes)
  }
  const sandbox = loadCompiler(ros, tell, give).then(() => made)
  compiler = { ros, sandbox }
  sandbox.catch(() => {
    made.end()
    compiler = null
  })
  return sandbox
}

/** So long (ms) a node may take to compile. */
const TIME = 60_000

/** @type {Sandbox | null} which has compiled before: to start clang takes longer than to compile a node */
let warm = null

/** @type {Promise<unknown>} until the compiler has done what it was asked: one thing after the other */
let compiling = Promise.resolve()

/**
 * @param {Sandbox} sandbox
 * @param {string} text
 * @param {string} filename
 * @returns {Promise<import("./protocol.js").CompileResult>}
 */
const compile = (sandbox, text, filename) =>
  new Promise((resolve, reject) => {
    const fail = (/** @type {string} */ reason) => {
      compiler = null
      sandbox.end()
      reject(new Fault(reason))
    }
    const timer = setTimeout(fail, TIME, `The compiler was ended after ${TIME / 1e3} s.`)
    sandbox.do({ kind: "compile", text, filename }, (message) => {
      clearTimeout(timer)
      if (message.kind === "end") resolve(message.result)
      if (message.kind === "failed") fail(message.reason)
    })
  })

/**
 * The program of a node; null: it does not compile, which is then told.
 *
 * @param {Node} node
 * @param {(message: Told) => void} hear
 * @returns {Promise<ArrayBuffer | null>}
 */
export async function compiled(node, hear) {
  try {
    return await compileFor(node, hear)
  } catch (error) {
    hear({ kind: "failed", reason: error instanceof Fault ? error.message : NOT_LOADED })
    return null
  }
}

const NOT_LOADED = "The compiler could not be loaded. Is the site still there?"

/**
 * @param {Node} node
 * @param {(message: Told) => void} hear
 */
async function compileFor({ source, filename, ros }, hear) {
  // The compiler is given them all, so it would miss none.
  if (!isCpp(source)) throw new Fault(`${filename} includes neither ros/ros.h nor rclcpp/rclcpp.hpp`)
  const result = compiling.then(async () => {
    const sandbox = await startCompiler(ros, hear) // which ends one for another ROS
    hear({ kind: "doing", said: sandbox === warm ? "compiling" : "compiling: the first time takes longer", share: -1 })
    warm = sandbox
    return compile(sandbox, source.replace(/^%%.*/, ""), filename) // the first line of an answer is none of it
  })
  compiling = result.catch(() => {})
  const { said: all, program } = await result
  const said = shown(all)
  const texts = [said, advice(said)].filter(Boolean)
  hear({ kind: "batch", chunks: texts.map((text) => [true, `${text.trimEnd()}\n`, OF_NO_NODE, 0]), leftOut: 0, ticks: [] })
  if (said) hear({ kind: "faults", faults: faults(said, filename), filename })
  if (program) return Uint8Array.from(atob(program), (character) => character.charCodeAt(0)).buffer
  hear({ kind: "end", result: { ...NOTHING, ticks: [], lost: [], chunks: [], drive: [] } })
  return null
}

/** What comes of a node that does not compile. */
const NOTHING = /** @type {const} */ ({ status: 1, errors: 0, count: 0, hints: 0, end: 0, alternative: "", scenes: null })
