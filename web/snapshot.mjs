// A memory snapshot: Python as it is when rosspin has been imported. Loading it takes a fraction of a start.

import { readFileSync } from "node:fs"
import path from "node:path"
import { pathToFileURL } from "node:url"

import { filled, pack } from "./src/memory.js"
import { install, options } from "./src/start.js"

// Nothing of the machine on which it is made may be in it. With random hashes no two snapshots would be the same.
const SETTINGS = { env: { LANG: "C.UTF-8", PYTHONHASHSEED: "0" }, _sysExecutable: "./this.program", _makeSnapshot: true }

// A block of memory (bytes) that is free, or the first part of one.
const LARGEST = 2 ** 16

/** A promise of what WebAssembly fills of the memory of the next Python. */
function watch() {
  const { instantiate } = WebAssembly
  const { promise, resolve } = Promise.withResolvers()
  WebAssembly.instantiate = async (...given) => {
    const made = await instantiate(...given)
    const { memory } = made.instance?.exports ?? {}
    if (memory) resolve(filled(memory))
    return made
  }
  return promise
}

/** The bytes of a snapshot of the Python in the folder `pyodide`, with our own files in `zip`; `info` is from its lock file. */
export async function snapshot(pyodide, zip, info) {
  const { loadPyodide } = await import(pathToFileURL(path.join(pyodide, "pyodide.mjs")))
  const fresh = watch()
  const python = await loadPyodide({ ...options(info), ...SETTINGS })
  const { HEAP8 } = python._module // another one, once the memory has grown
  install(python, readFileSync(zip))
  python.runPython(readFileSync(path.join(import.meta.dirname, "snapshot.py"), "utf8"))
  wipe(python._module)
  if (python._module.HEAP8 !== HEAP8) throw new Error("what the snapshot should hold does not fit into Python's first memory")
  return pack(python.makeMemorySnapshot(), await fresh)
}

/**
 * Fill the memory that is free with zeros, as far as it can be had: compressed, it is a sixth of all.
 *
 * Free blocks are handed out before new memory is. That must not run out: a snapshot of a memory that has grown could
 * not be loaded.
 */
function wipe(module) {
  const end = module.HEAP8.length - 4 * LARGEST
  const taken = []
  for (let size = LARGEST; size >= 32; size /= 2) {
    for (;;) {
      const block = module._malloc(size)
      module.HEAP8.fill(0, block, block + size)
      taken.push(block)
      if (block > end) break
    }
    module._free(taken.pop())
  }
  taken.forEach((block) => module._free(block))
}
