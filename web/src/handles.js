// Figures with a handle. The page carries the rows of all its positions. The first is there as matplotlib drew it, for a
// wide and for a narrow place; another is drawn here, as large as the first is in that place.

import { find } from "./make.js"
import { drawTimeline } from "./svg.js"

/**
 * The number that code next to a figure assigns to a variable; undefined where there is none.
 *
 * @param {HTMLElement} figure
 * @param {string} name
 */
function assigned(figure, name) {
  const tokens = [...(figure.closest(".rosspin-beside")?.querySelectorAll("pre span") ?? [])]
  const at = tokens.findIndex((token) => token.textContent === name && token.nextElementSibling?.textContent === "=")
  return at < 0 ? undefined : tokens[at].nextElementSibling?.nextElementSibling
}

/**
 * What a figure carries: the variable that it `sets` in the code next to it, if there is such, its axis, and its positions.
 *
 * @typedef {[value: string, words: string, alternative: string, rows: import("./svg.js").Row[]]} Position
 * @typedef {import("./svg.js").Scale & {title: string, sets?: string, positions: Position[]}} Carried
 */

/** @param {HTMLElement} figure */
function move(figure) {
  /** @type {Carried} */
  const { sets, positions, ...scale } = JSON.parse(figure.dataset.positions ?? "")
  const handle = find(".rosspin-handle", figure)
  const input = /** @type {HTMLInputElement} */ (find("input", handle))
  const said = find("[aria-hidden]", handle)
  const first = [...figure.querySelectorAll(":scope > svg")]
  const number = sets ? assigned(figure, sets) : undefined
  let shown = first

  const show = (/** @type {number} */ position) => {
    const [value, words, alternative, rows] = positions[position]
    const next = first.map((picture) => {
      if (position === Number(input.defaultValue)) return picture
      const drawn = drawTimeline(rows, scale, alternative)
      for (const name of ["class", "style", "viewBox"]) drawn.setAttribute(name, picture.getAttribute(name) ?? "")
      drawn.removeAttribute("height")
      return drawn
    })
    shown.forEach((picture, index) => picture.replaceWith(next[index]))
    shown = next
    input.setAttribute("aria-valuetext", words)
    said.textContent = words
    if (number) number.textContent = value
  }
  input.addEventListener("input", () => show(input.valueAsNumber))
  // Paper, where nothing moves, shows what the text around the figure is about.
  addEventListener("beforeprint", () => show(Number(input.defaultValue)))
  addEventListener("afterprint", () => show(input.valueAsNumber))
  number?.classList.add("rosspin-number")
  handle.hidden = false
}

/** @type {NodeListOf<HTMLElement>} */
const figures = document.querySelectorAll("figure[data-positions]")
figures.forEach(move)
