// A listing in the address of its page: what follows the # is never sent to a server.

import { reveal } from "./unseen.js"

/** In place of what is kept of a listing: of what came with a link, nothing is. */
const UNKEPT = {
  said: "as it came with the link",
  unkept: "",
  write: () => false,
  solve: () => " The code came with the link, so it does not count.",
}

const NOTICE =
  "This code came with the link that you opened, not with the page. Read it before you run it. What you change is " +
  `${window.rosspinStore ? "neither kept nor handed in" : "not kept"}. Reset brings back what stood here before.`

/** The beginning of such a fragment. */
const SIGN = "#code="

// No listing is longer (bytes); a link that says otherwise is not read to its end.
const MOST = 100_000

async function* read(stream) {
  const reader = stream.getReader()
  for (let part = await reader.read(); !part.done; part = await reader.read()) yield part.value
}

/** The fragment that carries an object. RangeError: it is too long. */
async function pack(object) {
  const bytes = new TextEncoder().encode(JSON.stringify(object))
  if (bytes.length > MOST) throw Object.assign(new RangeError(), { said: "the listing is too long for a link" })
  let text = ""
  for await (const part of read(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw")))) {
    for (const byte of part) text += String.fromCharCode(byte)
  }
  return SIGN + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")
}

/** The address of this page that carries an object, and opens the tabs around an element. RangeError: too long. */
export async function address(element, object) {
  const link = new URL(location.href)
  for (let tab = element.closest(".sd-tab-content"); tab; tab = tab.parentElement.closest(".sd-tab-content")) {
    const { syncGroup, syncId } = tab.previousElementSibling.dataset
    link.searchParams.set(syncGroup, syncId)
  }
  link.hash = await pack(object)
  return link.href
}

/** Show the code in the address of the page in one of its cells. Error: why not, in words. */
export async function receive(cells) {
  const { cell, text, seconds, args } = await unpack(location.hash)
  if (!cells[cell]) throw new Error("The code in this link belongs to a listing that this page no longer has.")
  const { pre, said } = reveal(text)
  cells[cell].receive({ kept: { ...UNKEPT, text }, seconds, args, notice: `${NOTICE} ${said}`, shown: pre })
}

/** The listing in such a fragment, checked. Error: what is wrong with it, in words. */
async function unpack(fragment) {
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
