// What the plots that a page draws have in common.

// Those of rosspin/plots.py.
export const COLOURS = ["#0072b2", "#d55e00", "#009e73"]

/** An SVG element. */
export function draw(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag)
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value)
  element.append(...children)
  return element
}
