// A C++ node as a page's Python runs it beside others, without a page: node --experimental-wasm-jspi beside_in_page.mjs PROGRAM.
// For each line of standard input, with which it continues, a line of JSON: its batches, the ticks in base64.

import { readFileSync } from "node:fs"
import { createInterface } from "node:readline"

import { Beside } from "../../src/rosspin/cpp/js/beside.mjs"

const node = new Beside(new WebAssembly.Module(readFileSync(process.argv[2])))
for await (const line of createInterface({ input: process.stdin })) {
  const batches = await node.goOn(line)
  const told = batches.map(({ ticks, text }) => ({ ticks: ticks && Buffer.from(ticks).toString("base64"), text }))
  process.stdout.write(`${JSON.stringify(told)}\n`)
}
