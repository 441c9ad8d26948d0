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
 * These bytes, packed, as a text for an address.
 *
 * @param {Uint8Array<ArrayBuffer>} bytes
 */
export async function squeeze(bytes) {
  let text = ""
  for await (const part of read(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw")))) {
    for (const byte of part) text += String.fromCharCode(byte)
  }
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")
}

/**
 * The bytes in such a text. RangeError: there are more than `most`. Another error: it is broken.
 *
 * @param {string} text
 * @param {number} most
 */
export async function expand(text, most) {
  if (text.length > 2 * most) throw new RangeError()
  const packed = atob(text.replaceAll("-", "+").replaceAll("_", "/"))
  const bytes = Uint8Array.from(packed, (character) => character.charCodeAt(0))
  const parts = []
  let size = 0
  for await (const part of read(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")))) {
    parts.push(part)
    size += part.length
    if (size > most) throw new RangeError()
  }
  return new Blob(parts)
}

/**
 * The fragment that carries a listing. RangeError: it is too long, which it has `said`.
 *
 * @param {Listing} listing
 */
export async function pack(listing) {
  const bytes = new TextEncoder().encode(JSON.stringify(listing))
  if (bytes.length > MOST) throw Object.assign(new RangeError(), { said: "the listing is too long for a link" })
  return SIGN + (await squeeze(bytes))
}

/**
 * The listing in such a fragment, checked. Error: what is wrong with it, in words.
 *
 * @param {string} fragment
 * @returns {Promise<Listing>}
 */
export async function unpack(fragment) {
  const unreadable = new Error("The code in this link cannot be read: the link is broken.")
  try {
    const { cell, text, seconds, args } = JSON.parse(await (await expand(fragment.slice(SIGN.length), MOST)).text())
    const right = Number.isInteger(cell) && typeof text === "string" && typeof args === "string"
    if (!right || !Number.isFinite(seconds) || seconds < 0 || seconds > 3600) throw unreadable
    return { cell, text, seconds, args }
  } catch (error) {
    throw error instanceof RangeError ? new Error("The code in this link is too long for a listing.") : unreadable
  }
}
