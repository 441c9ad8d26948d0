// Loaded with each page that has listings to run. Nothing else is loaded until the reader touches one of them.

import { Cell } from "./cell.js"

const base = new URL(".", document.currentScript.src).href

/** Why Python cannot run here, in a sentence; "" if it can. */
function missing() {
  if (location.protocol === "file:") {
    return "Opened as a file, a page cannot run Python. Serve the site instead: make serve"
  }
  if (!("Suspending" in WebAssembly)) {
    return (
      "This browser cannot run this listing: it lacks JSPI, which Chrome and Edge have from version 137, " +
      "Firefox from 153 and Safari from 27."
    )
  }
  return ""
}

document.querySelectorAll(".live-missing").forEach((line) => line.remove())
document.querySelectorAll("div.live").forEach((listing, index) => new Cell(listing, index, base, missing()))
