// Compiles C++ to WebAssembly: node compile.mjs CLANG, with requests on standard input until it ends, each a line of JSON:
// { steps: [{ args, inputs: { "path in the compiler's world": "file" }, outputs: { "path": "file" }, said? }] }
// The answer is a line on standard output: { said, status } of the compiler, which ends at the first step that fails. What it
// has said in the steps up to one that names a file as `said` is written there, if that is anything.
// A compiler needs half a gigabyte, so it ends when it was not used for a minute.

import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs"
import path from "node:path"
import { createInterface } from "node:readline"
import { setFlagsFromString } from "node:v8"

import { Compiler } from "./llvm.mjs"

// Garbage need not be collected each time that the compiler's memory has grown, which a newer V8 can be told.
if (Number.parseInt(process.versions.node) >= 24) setFlagsFromString("--external-memory-accounted-in-global-limit")

const brought = (name) => readFileSync(path.join(process.argv[2], "gen", name))
const compiler = new Compiler(await WebAssembly.compile(brought("llvm.core.wasm")), brought("llvm-resources.tar"))

// Written beside and renamed: a file that is there is whole.
const write = (file, content) => {
  mkdirSync(path.dirname(file), { recursive: true })
  const beside = `${file}.${process.pid}`
  writeFileSync(beside, content)
  renameSync(beside, file)
}

function compiled(steps) {
  let all = ""
  let own = ""
  for (const { args, inputs, outputs, said: file } of steps) {
    const files = Object.fromEntries(Object.entries(inputs).map(([name, file]) => [name, readFileSync(file)]))
    const { status, said, made } = compiler.run(args, files, Object.keys(outputs))
    all += said
    own += said
    if (status) return { said: all, status }
    if (file && own) write(file, own) // before the program, with which nothing is compiled again
    if (file) own = ""
    for (const [name, file] of Object.entries(outputs)) write(file, made[name])
  }
  return { said: all, status: 0 }
}

const ending = setTimeout(() => process.exit(), 60_000)
for await (const line of createInterface({ input: process.stdin })) {
  process.stdout.write(`${JSON.stringify(compiled(JSON.parse(line).steps))}\n`)
  ending.refresh()
}
process.exit()
