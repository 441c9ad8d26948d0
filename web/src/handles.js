// Figures with a handle. The page carries the ticks of all its positions; the one chosen is drawn as the first was, so that
// moving there and back changes nothing.

import { drawRow } from "./svg.js"

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
  const picture = figure.querySelector("svg")
  const rows = picture.querySelectorAll(":scope > g")
  const number = sets ? assigned(figure, sets) : undefined

  const show = (position) => {
    const [value, words, alternative, ticks] = positions[position]
    ticks.forEach((row, index) => rows[index].replaceChildren(...drawRow(index, row, scale)))
    picture.setAttribute("aria-label", alternative)
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
