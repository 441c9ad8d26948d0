// The files from which code starts. Each is what it was when the site was built, or it is not used: its SHA-256 is
// known here, and is compared wherever it came from.

const base = new URL(".", import.meta.url)

/** What keeps the snapshot across pages; undefined where the browser offers nothing of the kind, as without https. */
const opening = globalThis.caches?.open("rosspin").catch(() => undefined)

/** The address of a file, which says which version of it is meant. A program is named by what its SHA-256 should be. */
const address = (/** @type {string} */ name) =>
  new URL(name in FILES ? `${name}?${FILES[name].slice(0, 16)}` : `../programs/${name}.gz`, base).href

/** @param {ArrayBuffer} bytes */
async function digest(bytes) {
  // Browsers have this on https and on one's own computer only.
  const hash = crypto.subtle
    ? new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))
    : (await import("./sha256.js")).sha256(new Uint8Array(bytes))
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("")
}

/** @type {(name: string, bytes: ArrayBuffer) => Promise<boolean>} */
const isRight = async (name, bytes) => (await digest(bytes)) === (FILES[name] ?? name)

/** What is wrong with the site or the browser, in words for the reader. */
export class Fault extends Error {}

const wrong = (/** @type {string} */ name) =>
  `The file ${name} of this site is not the one that belongs to this page, so it was not used. Reload the page; ` +
  "if that does not help, tell whoever keeps the site."

/**
 * The bytes of a file of the site. Fault: twice it was another one. Error: it cannot be had.
 *
 * @param {string} name
 */
export async function load(name) {
  for (const cache of /** @type {const} */ (["default", "reload"])) {
    const response = await fetch(address(name), { cache })
    if (!response.ok) throw new Error(`${response.status} ${name}`)
    const bytes = await response.arrayBuffer()
    if (await isRight(name, bytes)) return bytes
  }
  throw new Fault(wrong(name))
}

const SNAPSHOT = "snapshot.zst"

/** The snapshot, unpacked: from what the browser keeps if it is there and right, else from the site, to be kept. */
export async function loadSnapshot() {
  const unpacker = new Worker(address("unpack.js"))
  /** @type {Promise<ArrayBuffer>} */
  const unpacked = new Promise((resolve, reject) => {
    unpacker.onmessage = ({ data }) => resolve(data)
    unpacker.onerror = () => reject(new Error(`${SNAPSHOT} could not be unpacked`))
  })
  const sending = packedSnapshot().then((bytes) => unpacker.postMessage(bytes))
  try {
    const [bytes] = await Promise.all([unpacked, sending])
    return bytes
  } finally {
    unpacker.terminate()
  }
}

async function packedSnapshot() {
  const cache = await opening
  const found = await cache?.match(address(SNAPSHOT))
  if (cache && found) {
    const kept = await found.arrayBuffer()
    if (await isRight(SNAPSHOT, kept)) return kept
    await cache.delete(address(SNAPSHOT))
  }
  const bytes = await load(SNAPSHOT)
  if (cache) keep(cache, bytes)
  return bytes
}

/**
 * Keep the snapshot, and none of earlier versions of the site.
 *
 * @param {Cache} cache
 * @param {ArrayBuffer} bytes
 */
async function keep(cache, bytes) {
  try {
    for (const key of await cache.keys()) if (key.url !== address(SNAPSHOT)) await cache.delete(key)
    await cache.put(address(SNAPSHOT), new Response(bytes))
  } catch {
    // There is no room for it: the next page loads it again.
  }
}

/** @typedef {{name: string, ros: number, bytes: number, sha256: string}} Part of the compiler; ros 0: for either */

/** What keeps the compiler. */
const KEPT = "rosspin-clang"

/**
 * Load the files of the compiler for a ROS: from what the browser keeps, else from the site, to be kept. As they come,
 * `tell(so many bytes, of so many)` is called, and `give(name, bytes)` with each. Fault: one is not the right one. Error:
 * one cannot be had.
 *
 * @param {number} ros
 * @param {(loaded: number, total: number) => void} tell
 * @param {(name: string, bytes: ArrayBuffer) => Promise<void>} give
 */
export async function loadCompiler(ros, tell, give) {
  const folder = new URL("../clang/", base)
  const cache = await globalThis.caches?.open(KEPT).catch(() => undefined)
  /** @type {Part[]} */
  const all = await (await fetch(new URL("parts.json", folder), { cache: "no-cache" })).json()
  const parts = all.filter((part) => part.ros === ros || !part.ros)
  const total = parts.reduce((sum, { bytes }) => sum + bytes, 0)
  const known = new Set(all.map(({ sha256 }) => new URL(`${sha256}.xz`, folder).href))
  for (const key of (await cache?.keys()) ?? []) if (!known.has(key.url)) await cache?.delete(key)
  let loaded = 0
  for (const { name, sha256 } of parts) {
    const url = new URL(`${sha256}.xz`, folder).href
    const kept = await cache?.match(url)
    const response = kept ?? (await fetch(url))
    if (!response.ok || !response.body) throw new Error(`${response.status} ${name}`)
    const chunks = []
    const reader = response.body.getReader()
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      chunks.push(part.value)
      tell((loaded += part.value.length), total)
    }
    const bytes = await new Blob(chunks).arrayBuffer()
    if ((await digest(bytes)) !== sha256) {
      await cache?.delete(url)
      throw new Fault(wrong(name))
    }
    if (!kept) await cache?.put(url, new Response(bytes)).catch(() => {}) // there is no room for it: the next page loads it again
    await give(name, bytes)
  }
}

/** The address of the page of a sandbox. */
export const sandboxPage = address("sandbox.html")
