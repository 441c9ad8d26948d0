// What a run prints, as text and never as HTML. A flood pushes its first lines out at the top.

import { make } from "./make.js"

const MOST_LINES = 1000

// ROS 2 logs on stderr what is no error, too.
const NO_ERROR = /^\[(DEBUG|INFO)\]/

const LEVEL = /^\[\w+\]/

/** @typedef {HTMLSpanElement & {chunks: number[]}} Line with the numbers of the chunks that it is made of */

export class Console {
  #text = make("pre")
  #notice = make("p")
  #leftOut = 0
  #open = false // whether the last line goes on
  #place // finds where the node's file is named
  #goTo
  #all // whether lines of stdout are searched for it, too

  /**
   * `goTo(line)` is called when the reader chooses a line of the file `filename`, such as one in a traceback. In what
   * is said of an answer to an exercise, which has no `filename`, all lines are such.
   *
   * @param {string} name
   * @param {string} filename
   * @param {(line: number) => void} goTo
   */
  constructor(name, filename, goTo) {
    const file = filename.replace(/[^\w ]/g, "\\$&")
    this.#all = !filename
    this.#place = this.#all
      ? /"<answer>", line (\d+)|\bin line (\d+)/
      : new RegExp(`File "${file}", line (\\d+)|${file}:(\\d+)`)
    this.#goTo = goTo
    // The status line says how it went; read out, a flood would drown everything.
    const properties = { className: "live-console", role: "log", ariaLive: "off", ariaLabel: name, tabIndex: 0 }
    this.element = make("div", properties, this.#notice, this.#text)
    this.clear()
  }

  get empty() {
    return this.element.hidden
  }

  clear() {
    this.element.hidden = this.#notice.hidden = true
    this.#text.replaceChildren()
    this.#leftOut = 0
    this.#open = false
  }

  /**
   * Add chunks, each [whether it is of stderr, text, number, line of the node that logged it or 0]; `leftOut` lines
   * before them were left out.
   *
   * @param {import("./protocol.js").Chunk[]} chunks
   * @param {number} leftOut
   */
  print(chunks, leftOut) {
    if (!chunks.length) return
    this.element.hidden = false
    const atEnd = this.element.scrollTop + this.element.clientHeight >= this.element.scrollHeight - 2
    this.#leftOut += leftOut
    for (const chunk of chunks) this.#add(chunk)
    while (this.#text.childElementCount > MOST_LINES) {
      this.#text.firstChild?.remove()
      this.#leftOut++
    }
    this.#notice.hidden = this.#leftOut === 0
    this.#notice.textContent = `${this.#leftOut.toLocaleString("en-GB")} earlier lines are left out.`
    if (atEnd) this.element.scrollTop = this.element.scrollHeight
  }

  /**
   * Mark the lines in which these chunks are, and show the first of them.
   *
   * @param {number[]} chunks
   */
  mark(chunks) {
    const numbers = new Set(chunks)
    /** @type {Line | null} */
    let first = null
    for (const line of /** @type {Iterable<Line>} */ (this.#text.children)) {
      const marked = line.chunks.some((number) => numbers.has(number))
      line.classList.toggle("of-tick", marked)
      if (marked) first ??= line
    }
    if (!first) return
    const { top, bottom } = this.element.getBoundingClientRect()
    const place = first.getBoundingClientRect()
    if (place.top < top || place.bottom > bottom) this.element.scrollTop += place.top - top
  }

  /**
   * A text; where it names a line of the node's file, it leads there. So does the level of what the node logged.
   *
   * @param {string} text
   * @param {number} logged
   */
  #linked(text, logged) {
    const found = text.match(logged ? LEVEL : this.#place)
    if (!found) return [text]
    const line = logged || Number(found[1] ?? found[2])
    const button = make("button", { type: "button", textContent: found[0] })
    if (logged) button.title = `line ${line}`
    button.addEventListener("click", () => this.#goTo(line))
    const at = /** @type {number} */ (found.index)
    return [text.slice(0, at), button, text.slice(at + found[0].length)]
  }

  /** @param {import("./protocol.js").Chunk} chunk */
  #add([onStderr, text, number, logged]) {
    const isError = onStderr && !NO_ERROR.test(text)
    const lines = text.split(/(?<=\n)/)
    if (lines.length > MOST_LINES) this.#leftOut += lines.splice(0, lines.length - MOST_LINES).length
    for (const line of lines) {
      const last = /** @type {Line | null} */ (this.#text.lastElementChild)
      if (last && this.#open && last.classList.contains("stderr") === isError) {
        last.append(line)
        last.chunks.push(number)
      } else {
        const element = make("span", /** @type {object} */ ({ chunks: [number] }))
        if (isError) element.className = "stderr"
        element.append(...(isError || this.#all ? this.#linked(line, logged) : [line]))
        this.#text.append(element)
      }
      this.#open = !line.endsWith("\n")
    }
  }
}
