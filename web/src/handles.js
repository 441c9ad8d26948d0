// Figures with a handle. The page carries the rows of all its positions. The first stands there as matplotlib drew it, for a
// wide and for a narrow place; another is drawn here, as large as the first is in that place.

import { drawTimeline } from "./svg.js"

/** The number that code beside a figure assigns to a variable; undefined where there is none. */
function assigned(figure, name) {
  const tokens = [...(figure.closest(".rosspin-beside")?.querySelectorAll("pre span") ?? [])]
  const at = tokens.findIndex((token) => token.textContent === name && token.nextElementSibling?.textContent === "=")
  return at < 0 ? undefined : tokens[at].nextElementSibling.nextElementSibling
}

function move(figure) {
  const { sets, positions, ...scale } = JSON.parse(figure.dataset.positions)
  const handle = figure.querySelector(".rosspin-handle")
  const input = handle.querySelector("input")
  const said = handle.querySelector("[aria-hidden]")
  const first = [...figure.querySelectorAll(":scope > svg")]
  const number = sets ? assigned(figure, sets) : undefined
  let shown = first

  const show = (position) => {
    const [value, words, alternative, rows] = positions[position]
    const next = first.map((picture) => {
      if (position === Number(input.defaultValue)) return picture
      const drawn = drawTimeline(rows, scale, alternative)
      for (const name of ["class", "style", "viewBox"]) drawn.setAttribute(name, picture.getAttribute(name))
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
  // On paper, where nothing moves, stands what the text around the figure is about.
  addEventListener("beforeprint", () => show(Number(input.defaultValue)))
  addEventListener("afterprint", () => show(input.valueAsNumber))
  number?.classList.add("rosspin-number")
  handle.hidden = false
}

document.querySelectorAll("figure[data-positions]").forEach(move)
