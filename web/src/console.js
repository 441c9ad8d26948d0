// What a run prints, as text and never as HTML. A flood pushes its first lines out at the top.

const MOST_LINES = 1000

export class Console {
  #text = document.createElement("pre")
  #notice = document.createElement("p")
  #leftOut = 0
  #open = false // whether the last line goes on

  constructor(name) {
    this.element = document.createElement("div")
    this.element.className = "live-console"
    this.element.role = "log"
    this.element.ariaLive = "off" // the status line says how it went; read out, a flood would drown everything
    this.element.ariaLabel = name
    this.element.tabIndex = 0
    this.element.append(this.#notice, this.#text)
    this.clear()
  }

  get empty() {
    return this.element.hidden
  }

  clear() {
    this.element.hidden = true
    this.#notice.hidden = true
    this.#text.replaceChildren()
    this.#leftOut = 0
    this.#open = false
  }

  /** Add chunks, each [whether it is of stderr, text]; `leftOut` lines before them were left out. */
  print(chunks, leftOut) {
    if (!chunks.length) return
    this.element.hidden = false
    const atEnd = this.element.scrollTop + this.element.clientHeight >= this.element.scrollHeight - 2
    this.#leftOut += leftOut
    for (const [isError, text] of chunks) this.#add(isError, text)
    while (this.#text.childElementCount > MOST_LINES) {
      this.#text.firstChild.remove()
      this.#leftOut++
    }
    this.#notice.hidden = this.#leftOut === 0
    this.#notice.textContent = `${this.#leftOut.toLocaleString("en-GB")} earlier lines are left out.`
    if (atEnd) this.element.scrollTop = this.element.scrollHeight
  }

  #add(isError, text) {
    const lines = text.split(/(?<=\n)/)
    if (lines.length > MOST_LINES) this.#leftOut += lines.splice(0, lines.length - MOST_LINES).length
    for (const line of lines) {
      const last = this.#text.lastChild
      if (this.#open && last.classList.contains("stderr") === isError) {
        last.append(line)
      } else {
        const element = document.createElement("span")
        if (isError) element.className = "stderr"
        element.append(line)
        this.#text.append(element)
      }
      this.#open = !line.endsWith("\n")
    }
  }
}
