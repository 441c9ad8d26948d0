// Loaded with each page that has listings to run. Nothing else is loaded until the reader touches one of them.

import { Cell, showProgress } from "./cell.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { make } from "./make.js"
import { notHere } from "./python.js"

const base = new URL(".", document.currentScript.src).href

/** Why Python cannot run here, in a sentence; "" if it can. */
function missing() {
  return notHere("run Python") || (HAS_JSPI ? "" : `This browser cannot run this listing: ${LACKS_JSPI}`)
}

document.querySelectorAll(".live-missing").forEach((line) => line.remove())
const why = missing()
const cells = [...document.querySelectorAll("div.live")].map((listing, index) => new Cell(listing, index, base, why))

/** Show the code that came with the link, if there is some, or say why not. */
async function receive() {
  document.querySelector(".live-notice.of-page")?.remove()
  if (!location.hash.startsWith("#code=")) return
  try {
    if (why) throw new Error(why)
    const share = await import(`${base}share.js`)
    await share.receive(cells)
  } catch ({ message }) {
    const notice = make("p", { className: "live-notice of-page", textContent: message, role: "alert" })
    document.querySelector("article").prepend(notice)
  }
}

showProgress()
document.addEventListener("DOMContentLoaded", receive) // when the chosen tabs are open, too
addEventListener("hashchange", receive)
