// A listing in the fragment of an address.

/** How such a fragment begins. */
const SIGN = "#code="

// No listing is longer (bytes); a link that says otherwise is not read to its end.
const MOST = 100_000

/** @typedef {{cell: number, text: string, seconds: number, args: string}} Listing its number on the page, and what is in it */

/** @param {ReadableStream<Uint8Array<ArrayBuffer>>} stream */
async function* read(stream) {
  const reader = stream.getReader()
  for (let part = await reader.read(); !part.done; part = await reader.read()) yield part.value
}

/**
 * The fragment that carries a listing. RangeError: it is too long, which it has `said`.
 *
 * @param {Listing} listing
 */
export async function pack(listing) {
  const bytes = new TextEncoder().encode(JSON.stringify(listing))
  if (bytes.length > MOST) throw Object.assign(new RangeError(), { said: "the listing is too long for a link" })
  let text = ""
  for await (const part of read(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw")))) {
    for (const byte of part) text += String.fromCharCode(byte)
  }
  return SIGN + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")
}

/**
 * The listing in such a fragment, checked. Error: what is wrong with it, in words.
 *
 * @param {string} fragment
 * @returns {Promise<Listing>}
 */
export async function unpack(fragment) {
  const unreadable = new Error("The code in this link cannot be read: the link is broken.")
  const tooLong = new Error("The code in this link is too long for a listing.")
  if (fragment.length > 2 * MOST) throw tooLong
  const parts = []
  let size = 0
  try {
    const packed = atob(fragment.slice(SIGN.length).replaceAll("-", "+").replaceAll("_", "/"))
    const bytes = Uint8Array.from(packed, (character) => character.charCodeAt(0))
    for await (const part of read(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")))) {
      parts.push(part)
      size += part.length
      if (size > MOST) throw tooLong
    }
    const { cell, text, seconds, args } = JSON.parse(await new Blob(parts).text())
    const right = Number.isInteger(cell) && typeof text === "string" && typeof args === "string"
    if (!right || !Number.isFinite(seconds) || seconds < 0 || seconds > 3600) throw unreadable
    return { cell, text, seconds, args }
  } catch (error) {
    throw error === tooLong ? tooLong : unreadable
  }
}
