// A log in the fragment of an address: what follows the # is never sent to a server.

import { expand, squeeze } from "./link.js"

/** How such a fragment begins. */
export const SIGN = "#log="

/** No link is longer (characters): more, and a browser cuts it off. Nor is what is packed in it (bytes). */
const MOST_LINK = 60_000
const MOST = 2_000_000

/**
 * The fragment that carries a log. Error: it is too long, in words.
 *
 * @param {string} name
 * @param {ArrayBuffer} log
 */
export async function pack(name, log) {
  const head = new TextEncoder().encode(`${name.replaceAll("\n", " ")}\n`)
  const bytes = new Uint8Array(await new Blob([head, log]).arrayBuffer())
  const fragment = bytes.length > MOST ? "" : SIGN + (await squeeze(bytes))
  if (fragment && fragment.length <= MOST_LINK) return fragment
  throw new Error("The log is too long for a link. Paste the part that matters, and share that; or send the file.")
}

/**
 * The log in such a fragment, and its name. Error: what is wrong with it, in words.
 *
 * @param {string} fragment
 */
export async function unpack(fragment) {
  try {
    const bytes = await (await expand(fragment.slice(SIGN.length), MOST)).arrayBuffer()
    const end = new Uint8Array(bytes).indexOf(10)
    if (end < 0) throw new Error()
    return { name: new TextDecoder().decode(bytes.slice(0, end)), log: bytes.slice(end + 1) }
  } catch {
    throw new Error("The log in this link cannot be read: the link is broken.")
  }
}
