// The names of a program's functions, which the compiler puts into a section of their own.

const known = new WeakMap()
const decoder = new TextDecoder()

/** Return the names of functions by their numbers. */
export function functionNames(module) {
  if (!known.has(module)) known.set(module, read(module))
  return known.get(module)
}

function read(module) {
  const names = new Map()
  for (const section of WebAssembly.Module.customSections(module, "name")) {
    const bytes = new Uint8Array(section)
    let at = 0
    const number = () => {
      let value = 0
      for (let shift = 0; ; shift += 7) {
        const byte = bytes[at++]
        value |= (byte & 0x7f) << shift
        if (byte < 0x80) return value >>> 0
      }
    }
    while (at < bytes.length) {
      const kind = bytes[at++]
      const end = number() + at
      if (kind === 1) {
        for (let left = number(); left > 0; left--) {
          const index = number()
          const length = number()
          names.set(index, decoder.decode(bytes.subarray(at, at + length)))
          at += length
        }
      }
      at = end
    }
  }
  return names
}
