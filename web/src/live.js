// Loaded with each page that has listings to run. Nothing else is loaded until the reader touches one of them.

import { Cell, loadShare, showProgress } from "./cell.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { find, here, make } from "./make.js"
import { notHere } from "./python.js"

const base = here().href

document.querySelectorAll(".live-missing").forEach((line) => line.remove())
/** Why Python cannot run here, in a sentence; "" if it can. */
const why = notHere("run Python") || (HAS_JSPI ? "" : `This browser cannot run this listing: ${LACKS_JSPI}`)
/** @type {NodeListOf<HTMLElement>} */
const listings = document.querySelectorAll("div.live")
const cells = why ? [] : [...listings].map((listing, index) => new Cell(listing, index, base))
if (why) listings.forEach((listing) => listing.append(make("p", { className: "live-missing", textContent: why })))

/** Show the code that came with the link, if there is some, or say why not. */
async function receive() {
  document.querySelector(".live-notice.of-page")?.remove()
  if (!location.hash.startsWith("#code=")) return
  try {
    if (why) throw new Error(why)
    await (await loadShare(base)).receive(cells, base)
  } catch (error) {
    const textContent = /** @type {Error} */ (error).message
    find("article").prepend(make("p", { className: "live-notice of-page", textContent, role: "alert" }))
  }
}

showProgress()
document.addEventListener("DOMContentLoaded", receive) // when the chosen tabs are open, too
addEventListener("hashchange", receive)
