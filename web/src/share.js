// A listing in the address of its page: what follows the # is never sent to a server.

import { pack, unpack } from "./link.js"
import { named } from "./names.js"
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
  `${window.rosspinStore ? "neither kept nor handed in" : "not kept"}. Reset brings back what was here before.`

/**
 * The address of this page that carries a listing, and opens the tabs around an element. RangeError: it is too long.
 *
 * @param {Element} element
 * @param {import("./link.js").Listing} listing
 */
export async function address(element, listing) {
  const link = new URL(location.href)
  for (let tab = element.closest(".sd-tab-content"); tab; tab = tab.parentElement?.closest(".sd-tab-content") ?? null) {
    const { syncGroup = "", syncId = "" } = /** @type {HTMLElement} */ (tab.previousElementSibling).dataset
    link.searchParams.set(syncGroup, syncId)
  }
  link.hash = await pack(listing)
  return link.href
}

/**
 * Show the code in the address of the page in one of its cells, in colours if these can be loaded. Error: why not, in
 * words.
 *
 * @param {import("./cell.js").Cell[]} cells
 * @param {string} base the address of the folder that our files are in
 */
export async function receive(cells, base) {
  const { cell, text, seconds, args } = await unpack(location.hash)
  // Exercises change their places, but not their names.
  const exercise = named(text)
  const place = exercise ? cells.find((other) => other?.exercise === exercise) : cells[cell]
  const page = document.querySelector(`.exercise-list a[data-exercise="${CSS.escape(exercise ?? "")}"]`)
  if (page) return location.replace(`${page.getAttribute("href")}${location.search}${location.hash}`)
  if (!place) throw new Error("The code in this link belongs to a listing that this page no longer has.")
  /** @type {typeof import("./editor.js") | null} */
  const editor = await import(`${base}editor.js`).catch(() => null)
  const { pre, said } = reveal(text, editor?.coloured(text, place.language))
  place.receive({ kept: { ...UNKEPT, text }, seconds, args, notice: `${NOTICE} ${said}`, shown: pre })
}
