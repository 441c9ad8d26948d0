// Loaded with each page that has listings to run. Nothing else is loaded until the reader touches one of them.

import { Cell, showProgress } from "./cell.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"

const base = new URL(".", document.currentScript.src).href

/** Why Python cannot run here, in a sentence; "" if it can. */
function missing() {
  if (location.protocol === "file:") {
    return "Opened as a file, a page cannot run Python. Serve the site instead: make serve"
  }
  return HAS_JSPI ? "" : `This browser cannot run this listing: ${LACKS_JSPI}`
}

document.querySelectorAll(".live-missing").forEach((line) => line.remove())
const why = missing()
const cells = [...document.querySelectorAll("div.live")].map((listing, index) => new Cell(listing, index, base, why))

/** Show the code that came with the link, if there is some, or say why not. */
async function receive() {
  document.querySelector(".live-notice.of-page")?.remove()
  if (!location.hash.startsWith("#code=")) return
  let said
  try {
    const { unpack } = await import(`${base}share.js`)
    const shared = await unpack(location.hash)
    if (cells[shared.cell] && !why) return cells[shared.cell].receive(shared)
    said = why || "The code in this link belongs to a listing that this page no longer has."
  } catch (error) {
    said = error.message
  }
  const notice = Object.assign(document.createElement("p"), { className: "live-notice of-page", textContent: said })
  notice.role = "alert"
  document.querySelector("article").prepend(notice)
}

showProgress()
document.addEventListener("DOMContentLoaded", receive) // when the chosen tabs are open, too
addEventListener("hashchange", receive)
