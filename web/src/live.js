// Loaded with each page that has listings to run. Nothing else is loaded until the reader touches one of them.

import { Cell, loadShare } from "./cell.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { find, here, make } from "./make.js"
import { showProgress } from "./progress.js"
import { notHere } from "./python.js"

const base = here().href

document.querySelectorAll(".live-missing").forEach((line) => line.remove())
/** Why nothing can run here, in a sentence; "" if it can. */
const nothing = notHere("run its listings")
/** Why Python cannot. */
const why = nothing || (HAS_JSPI ? "" : `This browser cannot run this listing: ${LACKS_JSPI}`)
/** @type {(named: string) => HTMLElement[]} */
const listings = (named) => [...document.querySelectorAll(`div.live${named}`)].filter((each) => each instanceof HTMLElement)
/** @type {Cell[]} */
const cells = []
// Those in C++, and then launch files, have the last numbers: what is kept of others, and links to them, go by theirs.
const kinds = [":not(.highlight-cpp, .highlight-xml)", ".highlight-cpp", ".highlight-xml"]
kinds.flatMap(listings).forEach((listing, index) => {
  const textContent = listing.matches(".highlight-cpp") ? nothing : why
  if (textContent) listing.append(make("p", { className: "live-missing", textContent }))
  else cells[index] = new Cell(listing, index, base)
})

/** Show the code that came with the link, if there is some, or say why not. */
async function receive() {
  document.querySelector(".live-notice.of-page")?.remove()
  if (!location.hash.startsWith("#code=")) return
  try {
    if (nothing) throw new Error(nothing)
    await (await loadShare(base)).receive(cells, base)
  } catch (error) {
    const textContent = /** @type {Error} */ (error).message
    find("article").prepend(make("p", { className: "live-notice of-page", textContent, role: "alert" }))
  }
}

showProgress()
// Solved in another tab, or on the page from which the reader comes back.
for (const sign of ["storage", "pageshow"]) addEventListener(sign, showProgress)
document.addEventListener("DOMContentLoaded", receive) // when the chosen tabs are open, too
addEventListener("hashchange", receive)
