// The memory of a Python that has started, in a file: only what is not in the memory of one that has not.

/** Memory is compared in blocks of so many bytes, and what WebAssembly itself fills is in the first part of it. */
const BLOCK = 1024
const FILLED = 2 ** 22

/** Pyodide's own words on a snapshot have so much room (bytes); where the memory begins is the second number of them. */
export const HEAD = 1024

/** What WebAssembly has filled of a memory; to be called before anything runs there. */
export const filled = (/** @type {WebAssembly.Memory} */ { buffer }) => new Uint8Array(buffer).slice(0, FILLED)

/**
 * A file of Pyodide's snapshot; `fresh` is what was filled of its memory.
 *
 * @param {Uint8Array} snapshot
 * @param {Uint8Array} fresh
 */
export function pack(snapshot, fresh) {
  const numbers = new Uint32Array(snapshot.buffer)
  const memory = snapshot.subarray(numbers[1])
  const base = new Uint8Array(memory.length)
  base.set(fresh)
  const head = new Uint8Array(HEAD)
  head.set(snapshot.subarray(0, numbers[1])) // throws if it has no room
  new Uint32Array(head.buffer)[1] = HEAD
  /** @type {[start: number, end: number][]} */
  const runs = []
  for (let at = 0; at < memory.length; at += BLOCK) {
    const end = at + BLOCK
    const known = base.subarray(at, end)
    if (memory.subarray(at, end).every((byte, place) => byte === known[place])) continue
    const last = runs.at(-1)
    if (last?.[1] === at) last[1] = end
    else runs.push([at, end])
  }
  /** @type {Uint8Array[]} */
  const parts = [new Uint8Array(Uint32Array.from([runs.length, ...runs.flat()]).buffer), head]
  parts.push(...runs.map(([start, end]) => memory.subarray(start, end)))
  const file = new Uint8Array(parts.reduce((size, part) => size + part.length, 0))
  parts.reduce((at, part) => (file.set(part, at), at + part.length), 0)
  return file
}

/**
 * Make a memory what it was, whatever was written there since it was `fresh`, and fill in `head`.
 *
 * @param {ArrayBuffer} file
 * @param {Uint8Array} head
 * @param {Uint8Array} memory
 * @param {Uint8Array} fresh
 */
export function restore(file, head, memory, fresh) {
  const [count] = new Uint32Array(file, 0, 1)
  const runs = new Uint32Array(file, 4, 2 * count)
  let from = 4 + runs.byteLength
  const next = (/** @type {number} */ size) => new Uint8Array(file, from, ((from += size), size))
  head.set(next(HEAD))
  let last = 0
  const freshen = (/** @type {number} */ end) => {
    const known = fresh.subarray(last, end)
    memory.set(known, last)
    memory.fill(0, last + known.length, end)
  }
  for (let n = 0; n < runs.length; n += 2) {
    const [start, end] = runs.subarray(n, n + 2)
    freshen(start)
    memory.set(next(end - start), start)
    last = end
  }
  freshen(memory.length)
}
