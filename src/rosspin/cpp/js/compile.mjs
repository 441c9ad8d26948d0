// Compiles C++ to WebAssembly: node compile.mjs CLANG, with a request as JSON on standard input:
// { steps: [{ args, inputs: { "path in the compiler's world": "file" }, outputs: { "path": "file" } }] }
// What the compiler says goes to standard error; the exit status is its own.

import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs"
import path from "node:path"
import { pathToFileURL } from "node:url"

const { runClang, Exit } = await import(pathToFileURL(path.join(process.argv[2], "gen/bundle.js")))
const { steps } = JSON.parse(readFileSync(0, "utf8"))

const put = (tree, name, content) => {
  const parts = name.split("/")
  const last = parts.pop()
  for (const part of parts) tree = tree[part] ??= {}
  tree[last] = content
}

const take = (tree, name) => name.split("/").reduce((at, part) => at[part], tree)

// Written beside and renamed: a file that is there is whole.
const write = (file, content) => {
  mkdirSync(path.dirname(file), { recursive: true })
  const beside = `${file}.${process.pid}`
  writeFileSync(beside, content)
  renameSync(beside, file)
}

for (const { args, inputs, outputs } of steps) {
  const tree = {}
  for (const [name, file] of Object.entries(inputs)) put(tree, name, readFileSync(file))
  let made
  try {
    made = await runClang(args, tree, {
      stdout: null,
      stderr: (bytes) => bytes && process.stderr.write(bytes),
      fetchProgress: () => {},
    })
  } catch (error) {
    if (!(error instanceof Exit)) throw error
    process.exit(error.code || 1)
  }
  for (const [name, file] of Object.entries(outputs)) write(file, take(made, name))
}
