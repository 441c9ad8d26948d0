// Runs C++ nodes, one after the other, for a host that talks over pipes. A line of JSON from the host starts one, then
// there is a line for each batch and a line for each answer (see node.mjs); of its ticks a batch says
// how many bytes they are, which follow it. A line that only `loads` one is answered when that is done.

import { readFileSync, readSync, writeSync } from "node:fs"

import { Node } from "./node.mjs"

const chunk = Buffer.alloc(1 << 16)
let rest = Buffer.alloc(0)

/** Read a line, however long that takes. */
function read() {
  for (;;) {
    const at = rest.indexOf(10)
    if (at >= 0) {
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
  try {
    await new Node(modules.get(program), start, exchange, pass).run()
  } catch (error) {
    if (!(error instanceof GivenUp)) throw error
  }
}
