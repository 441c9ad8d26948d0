// The compiler of C++ in the worker of a sandbox. It is sent its files, then jobs, one after the other: see protocol.js.

import { XzReadableStream } from "xz-decompress"
import { Compiler, unpacked } from "../../src/rosspin/cpp/js/llvm.mjs"

/** @typedef {import("./protocol.js").CompileJob} CompileJob */

/** @type {Map<string, PromiseWithResolvers<Uint8Array>>} with what files are promised, by their names */
const files = new Map()

/** @param {string} name */
function file(name) {
  const promised = files.get(name) ?? Promise.withResolvers()
  files.set(name, promised)
  return promised
}

/**
 * A file as it was before it was packed. No browser unpacks xz by itself, but what gzip makes of them is half as large again.
 *
 * @param {string} name
 */
async function whole(name) {
  const packed = await file(name).promise
  return new Response(new XzReadableStream(new Blob([/** @type {BlobPart} */ (packed)]).stream())).bytes()
}

const say = (/** @type {object} */ message) => postMessage(JSON.stringify(message))

const starting = Promise.all([whole("llvm.xz"), whole("usr.xz")]).then(
  async ([llvm, usr]) => new Compiler(await WebAssembly.compile(/** @type {BufferSource} */ (llvm)), usr),
)
const kept = whole("ros.xz").then((archive) => unpacked(archive))

/**
 * Compile a node; its program, in base64, and what the compiler has said.
 *
 * @param {CompileJob} job
 */
async function compile({ text, filename }) {
  const [compiler, given] = await Promise.all([starting, kept])
  const name = `node/0/${filename}`
  const { compile, link } = JSON.parse(new TextDecoder().decode(given["request.json"]))
  const words = compile.map((/** @type {string} */ word) => (word === "node/0/NODE" ? name : word))
  const compiled = compiler.run(words, { ...given, [name]: new TextEncoder().encode(text) }, ["made"])
  const said = compiled.said.replaceAll("node/0/", "")
  if (compiled.status) return { said, program: "" }
  const linked = compiler.run(link, { ...given, "0.o": compiled.made.made }, ["made"])
  if (linked.status) return { said: said + linked.said, program: "" }
  return { said, program: base64(linked.made.made) }
}

/** @param {Uint8Array} bytes */
function base64(bytes) {
  let text = ""
  for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000))
  return btoa(text)
}

addEventListener("message", async ({ data }) => {
  if (data.kind === "file") return file(data.name).resolve(new Uint8Array(data.bytes))
  try {
    say({ kind: "end", result: await compile(data) })
  } catch (error) {
    say({ kind: "failed", reason: `The compiler broke down: ${error}`.slice(0, 1000) })
  }
})
say({ kind: "ready" })
