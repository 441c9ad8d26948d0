// The runs that a page lets the reader go through step by step. It carries what they did; no Python is needed here.

import { find } from "./make.js"
import { drawRing } from "./ring.js"
import { Stepper } from "./stepper.js"

/** @type {NodeListOf<HTMLElement>} */
const figures = document.querySelectorAll("figure[data-scenes]")
for (const figure of figures) {
  /** @type {import("./protocol.js").Scenes & {name: string}} */
  const scenes = JSON.parse(figure.dataset.scenes ?? "")
  const pre = figure.closest(".rosspin-beside")?.querySelector("pre") ?? null
  const stepper = scenes.steps.length ? new Stepper(scenes.name, scenes, pre, pre?.textContent ?? "").element : ""
  find("ol", figure).replaceWith(stepper, ...scenes.rings.map(drawRing))
}
