// Compiles C++ to WebAssembly: node compile.mjs CLANG, with a request as JSON on standard input:
// { steps: [{ args, inputs: { "path in the compiler's world": "file" }, outputs: { "path": "file" } }] }
// What the compiler says goes to standard error; the exit status is its own.

import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs"
import path from "node:path"
import { setFlagsFromString } from "node:v8"

import { Compiler } from "./llvm.mjs"

// To optimise the compiler itself takes longer than it then saves. Nor is garbage to be collected each time that its
// memory has grown, which a newer V8 can be told.
setFlagsFromString("--liftoff-only")
if (Number.parseInt(process.versions.node) >= 24) setFlagsFromString("--external-memory-accounted-in-global-limit")

const brought = (name) => readFileSync(path.join(process.argv[2], "gen", name))
const compiler = new Compiler(await WebAssembly.compile(brought("llvm.core.wasm")), brought("llvm-resources.tar"))
const { steps } = JSON.parse(readFileSync(0, "utf8"))

// Written beside and renamed: a file that is there is whole.
const write = (file, content) => {
  mkdirSync(path.dirname(file), { recursive: true })
  const beside = `${file}.${process.pid}`
  writeFileSync(beside, content)
  renameSync(beside, file)
}

for (const { args, inputs, outputs } of steps) {
  const files = Object.fromEntries(Object.entries(inputs).map(([name, file]) => [name, readFileSync(file)]))
  const { status, said, made } = compiler.run(args, files, Object.keys(outputs))
  process.stderr.write(said)
  if (status) {
    process.exitCode = status
    break
  }
  for (const [name, file] of Object.entries(outputs)) write(file, made[name])
}
