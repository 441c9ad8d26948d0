// What a run prints, as text and never as HTML. A flood pushes its first lines out at the top.

import { OF_NO_NODE } from "./limits.js"
import { make } from "./make.js"
import { Painter } from "./painter.js"

/**
 * So many lines are shown, of so many characters in all. One that is longer than a line can be continues in the next: to lay
 * out one line takes a browser more than twice as long if it is twice as long, above all in scripts other than Latin.
 */
const MOST_LINES = 1000
const MOST = 100_000
const LONGEST = 1000

/** Parts of lines, none longer than that. */
const PARTS = /[^\n]{0,999}(\n|[^\n])/gu

// ROS 2 logs on stderr what is no error, too.
const NO_ERROR = /^\[(DEBUG|INFO)\]/

const LEVEL = /^\[\w+\]/

/**
 * @typedef {HTMLSpanElement & {chunks: number[], size: number}} Line with the numbers of the chunks in it, and its size:
 *   how many characters it has; one that is not ASCII counts as several
 */

const ALIEN = /[^\x00-\x7f]/g
const sizeOf = (/** @type {string} */ text) => text.length + 3 * (text.match(ALIEN)?.length ?? 0)

export class Console {
  #text = make("pre")
  #notice = make("p")
  #leftOut = 0 // lines
  #cut = false // whether anything is left out
  #open = false // whether the last line continues
  #size = 0
  /** @type {import("./protocol.js").Chunk[]} */
  #coming = [] // parts of lines that are not shown yet, and whether each is an error
  #comingSize = 0
  #painter = new Painter(() => this.#show())
  #place // finds where the node's file is named
  #goTo
  #all // whether lines of stdout are searched for it, too

  /**
   * It is shown in an `element`. `goTo(line)` is called when the reader chooses a line of the file `filename`, such as
   * one in a traceback. In what is said of an answer to an exercise, which has no `filename`, all lines are such.
   *
   * @param {HTMLElement} element
   * @param {string} filename
   * @param {(line: number) => void} goTo
   */
  constructor(element, filename, goTo) {
    const file = filename.replace(/[^\w ]/g, "\\$&")
    this.#all = !filename
    this.#place = this.#all
      ? /"<answer>", line (\d+)|\bin line (\d+)/
      : new RegExp(`File "${file}", line (\\d+)|${file}:(\\d+)`)
    this.#goTo = goTo
    this.element = element
    element.append(this.#notice, this.#text)
    this.clear()
  }

  /** All that nodes have printed; null if some of it is left out. */
  get whole() {
    const lines = [.../** @type {Iterable<Line>} */ (this.#text.children)].filter(({ chunks }) => chunks[0] !== OF_NO_NODE)
    return this.#cut ? null : lines.map(({ textContent }) => textContent).join("")
  }

  clear() {
    this.#painter.clear()
    this.element.hidden = this.#notice.hidden = true
    this.#text.replaceChildren()
    this.#coming = []
    this.#leftOut = this.#size = this.#comingSize = 0
    this.#cut = false
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
    this.#leftOut += leftOut
    this.#cut ||= leftOut > 0
    for (const [onStderr, text, number, line] of chunks) {
      const isError = onStderr && !NO_ERROR.test(text)
      for (const [part] of text.matchAll(PARTS)) {
        this.#coming.push([isError, part, number, line])
        this.#comingSize += sizeOf(part)
      }
    }
    let first = 0
    let lines = this.#coming.reduce((sum, [, part]) => sum + Number(part.endsWith("\n")), 0)
    for (; this.#comingSize > MOST || lines > MOST_LINES; first++) {
      const [, part] = this.#coming[first]
      this.#comingSize -= sizeOf(part)
      lines -= Number(part.endsWith("\n"))
      this.#leaveOut(part)
    }
    this.#coming.splice(0, first)
    this.#painter.soon()
  }

  /** Show all that has come. */
  finish() {
    this.#painter.now()
  }

  #show() {
    const atEnd = this.element.scrollTop + this.element.clientHeight >= this.element.scrollHeight - 2
    this.#coming.forEach((chunk) => this.#add(chunk))
    this.#coming = []
    this.#comingSize = 0
    while (this.#text.childElementCount > MOST_LINES || this.#size > MOST) {
      const line = /** @type {Line} */ (this.#text.firstElementChild)
      this.#size -= line.size
      this.#leaveOut(line.textContent)
      line.remove()
    }
    const count = this.#leftOut.toLocaleString("en-GB")
    this.#notice.hidden = !this.#cut
    this.#notice.textContent =
      this.#leftOut < 2 ? "Some of the output before this is left out." : `${count} earlier lines are left out.`
    if (atEnd) this.element.scrollTop = this.element.scrollHeight
  }

  /** @param {string | null} part of a line */
  #leaveOut(part) {
    this.#leftOut += Number(part?.endsWith("\n"))
    this.#cut = true
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

  /** @param {import("./protocol.js").Chunk} part */
  #add([isError, text, number, logged]) {
    const last = /** @type {Line | null} */ (this.#text.lastElementChild)
    const isNew = !last || !this.#open || last.classList.contains("stderr") !== isError || last.size > LONGEST
    const line = isNew ? /** @type {Line} */ (make("span", /** @type {object} */ ({ chunks: [], size: 0 }))) : last
    if (isNew) {
      if (isError) line.className = "stderr"
      line.append(...(isError || this.#all ? this.#linked(text, logged) : [text]))
      this.#text.append(line)
    } else if (line.lastChild instanceof Text) {
      line.lastChild.appendData(text)
    } else {
      line.append(text)
    }
    if (line.chunks.at(-1) !== number) line.chunks.push(number)
    const size = sizeOf(text)
    line.size += size
    this.#size += size
    this.#open = !text.endsWith("\n")
  }
}
