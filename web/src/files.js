// The files from which Python starts. Each is what it was when the site was built, or it is not used: its SHA-256 is
// known here, and is compared wherever it came from.

const base = new URL(".", import.meta.url)

/** What keeps the snapshot across pages; undefined where the browser offers nothing of the kind, as without https. */
const opening = globalThis.caches?.open("rosspin").catch(() => undefined)

/** The address of a file, which says which version of it is meant. */
const address = (name) => new URL(`${name}?${FILES[name].slice(0, 16)}`, base).href

async function digest(bytes) {
  // Browsers have this on https and on one's own computer only.
  const hash = crypto.subtle
    ? new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))
    : (await import("./sha256.js")).sha256(new Uint8Array(bytes))
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("")
}

const isRight = async (name, bytes) => (await digest(bytes)) === FILES[name]

/** What is wrong with the site or the browser, in words for the reader. */
export class Fault extends Error {}

const wrong = (name) =>
  `The file ${name} of this site is not the one that belongs to this page, so it was not used. Reload the page; ` +
  "if that does not help, tell whoever keeps the site."

/** Parts have at least so many bytes, but for the last: to pass one on to another process costs as much as it weighs. */
const PART = 2 ** 19

/** Some bytes after each other, in one piece. */
function join(parts) {
  const bytes = new Uint8Array(parts.reduce((size, part) => size + part.length, 0))
  parts.reduce((at, part) => (bytes.set(part, at), at + part.length), 0)
  return bytes
}

/** The bytes of a stream; `hear` is called with each part of them as it comes. */
async function gather(stream, hear) {
  const whole = []
  let parts = []
  let size = 0
  const give = () => {
    whole.push(join(parts))
    hear(whole.at(-1))
    parts = []
    size = 0
  }
  const reader = stream.getReader()
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value)
    size += part.value.length
    if (size >= PART) give()
  }
  if (size) give()
  return join(whole).buffer
}

/**
 * The bytes of a file of the site. Fault: twice it was another one. Error: it cannot be had. `hear` is called with each
 * part as it comes, not checked yet, and with null if those until then were wrong.
 */
export async function load(name, hear = () => {}) {
  for (const cache of ["default", "reload"]) {
    const response = await fetch(address(name), { cache })
    if (!response.ok) throw new Error(`${response.status} ${name}`)
    const bytes = await gather(response.body, hear)
    if (await isRight(name, bytes)) return bytes
    hear(null)
  }
  throw new Fault(wrong(name))
}

const SNAPSHOT = "snapshot.gz"

/** The snapshot, likewise: from what the browser keeps if it is there and right, else from the site, to be kept. */
export async function loadSnapshot(hear) {
  const cache = await opening
  const found = await cache?.match(address(SNAPSHOT))
  if (found) {
    const kept = await gather(found.body, hear)
    if (await isRight(SNAPSHOT, kept)) return kept
    hear(null)
    await cache.delete(address(SNAPSHOT))
  }
  const bytes = await load(SNAPSHOT, hear)
  if (cache) keep(cache, bytes)
  return bytes
}

/** Keep the snapshot, and none of earlier versions of the site. */
async function keep(cache, bytes) {
  try {
    for (const key of await cache.keys()) if (key.url !== address(SNAPSHOT)) await cache.delete(key)
    await cache.put(address(SNAPSHOT), new Response(bytes))
  } catch {
    // There is no room for it: the next page loads it again.
  }
}

/** The address of the page of a sandbox. */
export const sandboxPage = address("sandbox.html")
