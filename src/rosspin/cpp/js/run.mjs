// Runs C++ nodes, one after the other, for a host that talks over pipes. A line of JSON from the host starts one, then
// there is a line for each batch and a line for each answer (see node.mjs); of its ticks a batch says
// how many bytes they are, which follow it. A line that only `loads` one is answered when that is done.
//
// A node in simulated time that computes for `most` seconds without a word is in an endless loop: its last batch is `stuck`
// in the function that is running there, and the host ends the process.

import { readFileSync, readSync, writeSync } from "node:fs"
import { Worker } from "node:worker_threads"

import { Node } from "./node.mjs"

const chunk = Buffer.alloc(1 << 16)
let rest = Buffer.alloc(0)

/** How many exchanges with the host there were, and how long (ms) a node may compute; 0: none does, or not in that time. */
const watched = new Int32Array(new SharedArrayBuffer(8))
// To lend it this process's output would make that one that does not block.
new Worker(new URL("./watch.mjs", import.meta.url), { workerData: watched, stdout: true, stderr: true }).unref()
let most = 0

function watch(time) {
  Atomics.add(watched, 0, 1)
  Atomics.store(watched, 1, time)
}

/** Read a line, however long that takes. */
function read() {
  watch(0)
  for (;;) {
    const at = rest.indexOf(10)
    if (at >= 0) {
      watch(most)
      const line = rest.subarray(0, at)
      rest = rest.subarray(at + 1)
      return JSON.parse(line.toString())
    }
    const length = readSync(0, chunk)
    if (length === 0) process.exit(1) // the host has gone
    rest = Buffer.concat([rest, chunk.subarray(0, length)])
  }
}

function pass({ ticks, ...batch }) {
  put(Buffer.from(`${JSON.stringify({ ...batch, ticks: ticks?.length })}\n`))
  if (ticks) put(ticks)
}

function put(bytes) {
  if (next) return
  watch(most)
  for (let at = 0; at < bytes.length; ) at += writeSync(1, bytes, at)
}

/** Another node should start where this one waits for an answer: its host has given it up. */
class GivenUp extends Error {}

let next = null // what starts that one

function exchange(batch) {
  pass(batch)
  const answer = next ?? read()
  if (!answer.program) return answer
  next = answer
  throw new GivenUp()
}

const modules = new Map()
for (;;) {
  const { program, loads, ...start } = next ?? read()
  next = null
  if (!modules.has(program)) modules.set(program, new WebAssembly.Module(readFileSync(program)))
  if (loads) {
    pass({})
    continue
  }
  most = start.real ? 0 : 1000 * start.most
  watch(most)
  const node = new Node(modules.get(program), start, exchange, pass)
  globalThis.standStill = () => node.standStill()
  try {
    await node.run()
  } catch (error) {
    if (!(error instanceof GivenUp)) throw error
  }
}
