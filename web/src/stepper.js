// Goes through a run step by step: what is ready, who is called, what waits; and marks the lines that run.

import { make } from "./make.js"
import { drawRing } from "./ring.js"
import { scene } from "./scenes.js"

/** How long (ms) a step is shown while they play, and how long something moves. */
const SHOWN = 1400
const MOVES = 350

const calm = matchMedia("(prefers-reduced-motion: reduce)")

/** @typedef {import("./scenes.js").Callback} Callback */

/**
 * Mark lines of a listing, and no others; in its editor, if that is open and still has the text that ran.
 *
 * @param {HTMLElement | null} pre
 * @param {string} text that ran
 * @param {number[]} lines
 */
function mark(pre, text, lines) {
  pre?.querySelectorAll(".stepper-line").forEach((element) => element.remove())
  if (!pre) return
  if (pre.hidden) {
    pre.previousElementSibling?.dispatchEvent(new CustomEvent("runs", { detail: { text, lines } }))
    return
  }
  const { paddingTop, paddingBottom } = getComputedStyle(pre)
  const count = (pre.textContent ?? "").replace(/\n$/, "").split("\n").length
  const height = `(100% - ${paddingTop} - ${paddingBottom}) / ${count}` // whatever becomes of its layout
  for (const line of lines) {
    const element = make("span", { className: "stepper-line", ariaHidden: "true" })
    element.style.top = `calc(${paddingTop} + ${line - 1} * ${height})`
    element.style.height = `calc(${height})`
    element.style.width = `${pre.scrollWidth}px`
    pre.append(element)
  }
  const box = pre.closest(".rosspin-beside > div")
  const first = pre.querySelector(".stepper-line")
  if (box && first instanceof HTMLElement) box.scrollTop = first.offsetTop - box.clientHeight / 2
}

export class Stepper {
  #scenes
  #text
  #pre
  /** @type {number[]} */
  #lines = [] // that run
  #at = 0
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #playing
  #picture = make("div", { className: "stepper-picture", role: "img" })
  #said = make("p", { className: "stepper-said", ariaLive: "polite" })
  #swaps
  #count = make("span", { ariaHidden: "true" }) // it is the slider's value

  /**
   * @param {string} name of the run
   * @param {import("./protocol.js").Scenes} scenes with at least one step
   * @param {HTMLElement | null} pre the listing
   * @param {string} text of the listing
   */
  constructor(name, scenes, pre, text) {
    this.#scenes = scenes
    this.#text = text.split("\n")
    this.#pre = pre
    this.#swaps = new MutationObserver(() => this.#mark(this.#lines)) // the editor takes the listing's place
    if (pre) this.#swaps.observe(pre, { attributeFilter: ["hidden"] })
    const button = (/** @type {string} */ textContent, /** @type {() => void} */ act) => {
      const element = make("button", { type: "button", textContent })
      element.addEventListener("click", act)
      return element
    }
    const go = (/** @type {number} */ index) => {
      this.stop()
      this.show(index)
    }
    this.back = button("Back", () => go(this.#at - 1))
    this.play = button("Play", () => (this.#playing ? this.stop() : this.#start()))
    this.forward = button("Forward", () => go(this.#at + 1))
    this.slider = make("input", { type: "range", min: "1", max: `${scenes.steps.length}`, value: "1", ariaLabel: "Step" })
    this.slider.addEventListener("input", () => go(this.slider.valueAsNumber - 1))
    const bar = make("div", { className: "stepper-bar", role: "group", ariaLabel: `Steps of ${name}` })
    bar.append(this.back, this.play, this.forward, this.slider, this.#count)
    this.element = make("div", { className: "stepper" }, bar, this.#said, this.#picture)
    this.show(0)
  }

  /** End the playing, if there is some. */
  stop() {
    clearInterval(this.#playing)
    this.#playing = undefined
    this.play.textContent = "Play"
  }

  /** Take away what it shows elsewhere. */
  end() {
    this.stop()
    this.#swaps.disconnect()
    this.#mark([])
  }

  #start() {
    const last = this.#scenes.steps.length - 1
    this.show(this.#at < last ? this.#at + 1 : 0)
    this.#playing = setInterval(() => (this.#at < last ? this.show(this.#at + 1) : this.stop()), SHOWN)
    this.play.textContent = "Pause"
  }

  /**
   * Show a step; the first or the last if there is none of that number.
   *
   * @param {number} index
   */
  show(index) {
    const last = this.#scenes.steps.length - 1
    this.#at = Math.min(Math.max(index, 0), last)
    const { time, said, ready, threads, groups, alternative } = scene(this.#scenes, this.#at)
    const places = this.#places()
    this.#picture.replaceChildren(
      ...(groups.length ? [box("Groups", ...groups.map(({ name, callbacks }) => box(name, ...callbacks.map(row))))] : []),
      ...(groups.length ? [box("Ready, in this order", ...ready.map(token), ready.length ? "" : "nothing")] : []),
      box("Threads", ...threads.map(({ name, callback, line }) => {
        const code = line ? make("code", { textContent: `${line}: ${this.#text[line - 1]?.trim() ?? ""}` }) : ""
        return box(name, callback ? token(callback) : make("span", { textContent: "no callback" }), code)
      })),
    )
    this.#picture.ariaLabel = alternative
    this.#said.textContent = said
    this.#count.textContent = `${this.#at + 1} of ${last + 1}, at ${time}`
    this.slider.value = `${this.#at + 1}`
    this.slider.ariaValueText = `step ${this.#at + 1} of ${last + 1}, at ${time}`
    this.back.ariaDisabled = String(this.#at === 0)
    this.forward.ariaDisabled = String(this.#at === last)
    this.#mark([...new Set(threads.map(({ line }) => line).filter(Boolean))])
    this.#move(places)
  }

  /** @param {number[]} lines */
  #mark(lines) {
    this.#lines = lines
    mark(this.#pre, this.#text.join("\n"), lines)
  }

  /** Where the callbacks are: a token rather than a row. */
  #places() {
    /** @type {NodeListOf<HTMLElement>} */
    const found = this.#picture.querySelectorAll(".stepper-row, .stepper-token")
    return new Map([...found].map((element) => [element.dataset.of, element.getBoundingClientRect()]))
  }

  /**
   * Let tokens come from where their callbacks were.
   *
   * @param {Map<string | undefined, DOMRect>} before
   */
  #move(before) {
    if (calm.matches) return
    /** @type {NodeListOf<HTMLElement>} */
    const tokens = this.#picture.querySelectorAll(".stepper-token")
    for (const element of tokens) {
      const [from, to] = [before.get(element.dataset.of), element.getBoundingClientRect()]
      if (!from || (from.x === to.x && from.y === to.y)) continue
      const transform = [`translate(${from.x - to.x}px, ${from.y - to.y}px)`, "none"]
      element.animate({ transform }, { duration: MOVES, easing: "ease-in-out" })
    }
  }
}

/**
 * @param {string} name
 * @param {(Node | string)[]} children
 */
const box = (name, ...children) => make("div", { className: "stepper-box" }, make("b", { textContent: name }), ...children)

/**
 * A callback, known by its number wherever it is.
 *
 * @param {string} className
 * @param {Callback} callback
 * @param {string} [how]
 */
function named(className, { number, name }, how) {
  const element = make("span", { className }, name, how === undefined ? "" : make("small", { textContent: how }))
  Object.assign(element.dataset, { of: number, how: how?.split(" ")[0] ?? "" })
  return element
}
const token = (/** @type {Callback} */ callback) => named("stepper-token", callback)
const row = (/** @type {Callback} */ callback) => named("stepper-row", callback, callback.how)

/**
 * Let the reader go through what a run did, where a button was. Returned is what takes away what that shows elsewhere.
 *
 * @param {HTMLElement} button
 * @param {string} name
 * @param {import("./protocol.js").Scenes} scenes with at least one step
 * @param {HTMLElement | null} pre the listing
 * @param {string} text
 */
export function open(button, name, scenes, pre, text) {
  addStyle()
  const stepper = new Stepper(name, scenes, pre, text)
  button.replaceWith(stepper.element)
  stepper.forward.focus()
  return () => stepper.end()
}

/** @param {import("./protocol.js").Ring[]} rings of waits, to be drawn */
export function drawn(rings) {
  addStyle()
  return rings.map(drawRing)
}

function addStyle() {
  const { href } = new URL("../stepper/stepper.css", import.meta.url)
  if (!document.querySelector(`link[href="${href}"]`)) document.head.append(make("link", { rel: "stylesheet", href }))
}
