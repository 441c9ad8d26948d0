// A listing that can be edited and run: its buttons, its status line, what its runs show.

import { Console } from "./console.js"
import { Plot } from "./plot.js"
import { release, start, warmUp } from "./workers.js"

/** For how long (s) a node runs, unless the reader says otherwise. */
const SECONDS = "10"

/** What a node has in it that reads its command line. */
const READS_ARGUMENTS = /\b(get_param|search_param|declare_parameters?|argv)\b/

/** An example of how a parameter is set, by the ROS of the node. */
const EXAMPLE = { rospy: "_frequency:=5", rclpy: "--ros-args -p frequency:=5.0" }

/** The status of a node that Ctrl-C ended, as it does at the end of a run unless the node has seen to it. */
const BY_CTRL_C = 130

/** The cells of the page that are answers to exercises. */
const exercises = []

/** Under this and the path of a page, how many of its exercises are solved. */
const PROGRESS = "rosspin:progress:"

/** Under this, beside the reader's text, a cell notes that its exercise has been solved. */
const SOLVED = ":solved"

/** Say on a page that has exercises how many are solved, and on every page beside the links to such pages. */
export function showProgress() {
  document.querySelectorAll(".live-progress").forEach((element) => element.remove())
  try {
    if (exercises.length) {
      const solved = exercises.filter((cell) => cell.solved).length
      localStorage.setItem(PROGRESS + location.pathname, `${solved} of ${exercises.length} solved`)
      sayProgress(document.querySelector("article h1"), location.pathname)
    }
    document.querySelectorAll('.bd-docs-nav a[href$="exercises.html"], .bd-docs-nav a[aria-current]').forEach((link) => {
      sayProgress(link, link.pathname)
    })
  } catch {
    // the reader does not let pages keep anything
  }
}

/** Say beside an element how many exercises of a page are solved, if that is known. */
function sayProgress(place, page) {
  const said = localStorage.getItem(PROGRESS + page)
  if (said) place.after(make("p", { className: "live-progress", textContent: said }))
}

/** An element with these properties and children. */
function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties)
  element.append(...children)
  return element
}

/** The plot that stands below a listing since the site was built. */
function made(listing) {
  const next = (listing.closest(".literal-block-wrapper") ?? listing).nextElementSibling
  return next?.matches("figure.live-made") ? next : null
}

/** A short text that differs when the given one does (FNV-1a). */
function fingerprint(text) {
  let hash = 0x811c9dc5
  for (const character of text) hash = Math.imul(hash ^ character.codePointAt(0), 0x01000193)
  return (hash >>> 0).toString(16)
}

export class Cell {
  #base
  #index
  #pre
  #original
  #highlighted
  #key
  #name
  #answers // whether it is an answer to an exercise, which is checked rather than run
  #simulates // whether its first line says for how long it runs
  #made // the plot that was made with the page, if there is one
  #output // of a notebook's cell: what it printed when the site was built
  #test = "" // pins what the last run showed
  #shared = false // whether the text came with a link; it is not kept
  #editor = null
  #worker = null
  #runs = 0

  /**
   * @param {HTMLElement} listing what Sphinx made of a listing
   * @param {number} index its number on the page
   * @param {string} base the address of the folder that our files are in
   * @param {string} missing why Python cannot run here; "" if it can
   */
  constructor(listing, index, base, missing) {
    this.#base = base
    this.#index = index
    this.#pre = listing.querySelector("pre")
    this.#original = this.#pre.textContent
    this.#highlighted = [...this.#pre.childNodes]
    this.#key = `rosspin:${location.pathname}:${index}:${fingerprint(this.#original)}`
    const caption = listing.parentElement.querySelector(".code-block-caption .caption-text")
    const [, magic, number] = this.#original.match(/^%%(\w+) (\S+)/) ?? []
    this.#answers = magic === "answer"
    this.#simulates = magic === "simulate"
    this.#name = this.#answers ? `answer ${number}` : (caption?.textContent ?? "node.py").trim().split("/").at(-1)
    this.#output = listing.closest(".cell")?.querySelector(".cell_output")
    if (missing) {
      listing.append(make("p", { className: "live-missing", textContent: missing }))
      return
    }
    this.#made = made(listing)
    this.#build(listing)
    const edited = this.#stored()
    if (edited !== null) {
      this.#show(edited)
      this.#showMade(false)
    }
    this.solved = this.#stored(SOLVED) !== null
    if (this.#answers) exercises.push(this)
    this.#say([this.#before, edited !== null && "as you edited it"].filter(Boolean).join(", "))
  }

  #build(listing) {
    const button = (text, act) => {
      const element = make("button", { type: "button", textContent: text })
      element.setAttribute("aria-label", `${text} ${this.#name}`)
      element.addEventListener("click", () => element.ariaDisabled !== "true" && act())
      return element
    }
    this.run = button("Run", () => this.#run())
    for (const sign of ["pointerenter", "focus"]) this.run.addEventListener(sign, () => this.#warmUp())
    this.stop = button("Stop", () => this.#stop())
    this.edit = button("Edit", () => this.#edit())
    this.reset = button("Reset", () => this.#reset())
    this.share = button("Share", () => this.#share())
    this.pin = button("Copy as test", () => this.#copy(this.#test, "the test is copied: save it in a file for pytest"))
    this.pin.hidden = true
    this.seconds = make("input", { type: "number", min: "0", max: "3600", step: "any", value: SECONDS })
    this.args = make("input", { type: "text", spellcheck: false, autocomplete: "off", autocapitalize: "off" })
    this.arguments = make("label", { className: "live-arguments" }, "Arguments ", this.args)
    this.args.addEventListener("keydown", (event) => event.key === "Enter" && this.#run())
    this.args.addEventListener("input", () => this.#offer())
    this.speed = make("select", {})
    for (const [text, speed] of [["real time", 1], ["10 times as fast", 10], ["instantly", 0]]) {
      this.speed.append(make("option", { textContent: text, value: speed }))
    }
    this.speed.ariaLabel = "Speed"
    this.status = make("span", { className: "live-status" })
    this.status.role = "status"
    const bar = make("div", { className: "live-bar" }, this.run, this.stop, this.edit, this.reset, this.share, this.pin)
    bar.role = "group"
    bar.ariaLabel = `Run ${this.#name} in this page`
    if (!this.#answers && !this.#simulates) bar.append(make("label", {}, this.seconds, " s"))
    if (!this.#answers) bar.append(this.speed)
    if (!this.#answers && !this.#simulates) bar.append(this.arguments)
    bar.append(this.status)
    const file = this.#answers ? "" : this.#name
    this.console = new Console(`Console of ${this.#name}`, file, (line) => this.#edit(line))
    this.plot = new Plot(`Ticks of ${this.#name}`, (chunks) => this.console.mark(chunks))
    this.notice = make("p", { className: "live-notice", hidden: true })
    this.copied = make("textarea", { readOnly: true, hidden: true, rows: 4 })
    this.copied.ariaLabel = "To be copied"
    const parts = [this.notice, bar, this.copied, this.console.element, this.plot.element, this.#made].filter(Boolean)
    listing.append(make("div", { className: "live-cell" }, ...parts))
    this.#offer()
    this.#pre.addEventListener("click", () => getSelection().isCollapsed && this.#edit())
  }

  /** The text as it is now. */
  get #text() {
    return this.#editor ? this.#editor.text() : this.#pre.textContent
  }

  /** Offer what can be done with the text as it is: arguments for a node that reads some, Reset for one that was changed. */
  #offer() {
    this.arguments.hidden = !READS_ARGUMENTS.test(this.#text) && !this.args.value
    this.args.placeholder = EXAMPLE[this.#text.match(/\b(rospy|rclpy)\b/)?.[1]] ?? ""
    this.reset.ariaDisabled = String(this.#untouched && this.console.empty)
  }

  get #untouched() {
    return this.#text === this.#original && this.seconds.value === SECONDS && !this.args.value
  }

  /** What there is to say of earlier visits. */
  get #before() {
    return this.solved ? "solved" : ""
  }

  /** Say where the cell is; its buttons follow. */
  #say(status) {
    this.status.textContent = status
    this.stop.ariaDisabled = String(this.#worker === null)
    this.#offer()
  }

  // --- the text ---

  /** Show a text of the reader's in place of the original. The Copy button copies what stands here. */
  #show(text) {
    this.#pre.textContent = text
  }

  /** Show or hide what was made of the original when the site was built. */
  #showMade(shown) {
    for (const element of [this.#output, this.#made]) if (element) element.hidden = !shown
  }

  #stored(what = "") {
    try {
      return localStorage.getItem(this.#key + what)
    } catch {
      return null // the reader does not let pages keep anything
    }
  }

  #store(text, what = "") {
    if (this.#shared && !what) return // what the reader has written before stays
    try {
      if (text === this.#original) localStorage.removeItem(this.#key)
      else localStorage.setItem(this.#key + what, text)
    } catch {
      // It lasts as long as the page.
    }
  }

  /** Open the editor, at a line if one is given. */
  async #edit(line) {
    this.#warmUp()
    if (!this.#editor) {
      const { open } = await import(`${this.#base}editor.js`).catch(() => ({}))
      if (!open) return this.#say("error: the editor could not be loaded. Is the site still there?")
      if (this.#editor) return
      this.#editor = open(this.#text, `Code of ${this.#name}. Escape leaves the editor.`, {
        changed: (text) => {
          this.#show(text)
          this.#store(text)
          this.#offer()
        },
        run: () => this.#run(),
        leave: () => this.run.focus(),
      })
      this.#pre.before(this.#editor.element)
      this.#pre.hidden = true
    }
    if (line) this.#editor.goTo(line)
    else this.#editor.focus()
  }

  #reset() {
    this.#restore()
    this.#store(this.#original)
    if (this.#shared) history.replaceState(null, "", location.pathname + location.search)
    this.#shared = false
    this.notice.hidden = true
    this.#say(this.#before)
  }

  /** Show the cell as it came with the page. */
  #restore() {
    this.#end()
    this.#editor?.element.remove()
    this.#editor = null
    this.#pre.replaceChildren(...this.#highlighted)
    this.#pre.hidden = false
    this.seconds.value = SECONDS
    this.args.value = ""
    this.#clear(false)
  }

  // --- links and copies ---

  /** Show a text that came with a link, and the fields beside it. It is not run. */
  receive({ text, seconds, args }) {
    this.#restore()
    this.#shared = true
    this.#show(text)
    this.#showMade(text === this.#original)
    this.seconds.value = seconds
    this.args.value = args
    this.notice.textContent =
      "This code came with the link that you opened, not with the page. Read it before you run it. What you change " +
      "is not kept. Reset brings the page's own code back."
    this.notice.hidden = false
    this.#say("as it came with the link")
    this.notice.scrollIntoView({ block: "center" })
  }

  async #share() {
    const link = new URL(location.href)
    for (let tab = this.#pre.closest(".sd-tab-content"); tab; tab = tab.parentElement.closest(".sd-tab-content")) {
      const { syncGroup, syncId } = tab.previousElementSibling.dataset
      link.searchParams.set(syncGroup, syncId)
    }
    const seconds = this.seconds.valueAsNumber || 0
    const { pack } = await import(`${this.#base}share.js`)
    try {
      link.hash = await pack({ cell: this.#index, text: this.#text, seconds, args: this.args.value })
    } catch {
      this.#say("error: the listing is too long for a link")
      return
    }
    await this.#copy(link.href, "the link is copied; the code is in it")
  }

  /** Copy a text, or where the browser does not let us, let the reader copy it. */
  async #copy(text, said) {
    try {
      await navigator.clipboard.writeText(text)
      this.copied.hidden = true
      this.#say(said)
    } catch {
      this.copied.hidden = false
      this.copied.value = text
      this.copied.select()
      this.#say("copy the selected text")
    }
  }

  // --- runs ---

  /** Take away what the last run showed. What was made when the site was built makes way for a run. */
  #clear(runs) {
    this.console.clear()
    this.plot.clear()
    this.copied.hidden = this.pin.hidden = true
    this.#showMade(!runs)
  }

  #warmUp() {
    warmUp(this.#base)
  }

  async #run() {
    this.#end()
    const number = ++this.#runs
    const seconds = this.seconds.valueAsNumber
    this.#clear(true)
    if (this.#answers && !this.#text.startsWith(`%%${this.#name}\n`)) {
      this.#say(`error: the first line must be %%${this.#name}`)
      return
    }
    if (!this.seconds.checkValidity() || Number.isNaN(seconds)) {
      this.#say("error: seconds must be a number from 0 to 3600")
      return
    }
    const args = this.args.value
    const job = { source: this.#text, filename: this.#name, seconds, args, speed: Number(this.speed.value) }
    this.#worker = start(this.#base, job, (message) => number === this.#runs && this.#hear(message))
    this.#say("starting Python")
  }

  #hear(message) {
    if (message.kind === "begun") {
      this.#say("running")
    } else if (message.kind === "batch") {
      this.console.print(message.chunks, message.leftOut)
      this.plot.add(message.ticks)
    } else if (message.kind === "end") {
      release(this.#worker)
      this.#worker = null
      const { status, errors, verdict, count, ticks, chunks, alternative, end } = message.result
      this.#test = message.result.test
      this.pin.hidden = !this.#test
      if (count) this.plot.finish(ticks, alternative, chunks, end)
      const ticked = count ? `: ${count} tick${count === 1 ? "" : "s"}` : ""
      if (verdict) this.#say(verdict + this.#progress(message.result.solved))
      else if (status === 0 && errors) this.#say("done, but with an error: see the console")
      else if (status === 0) this.#say(`done${ticked}`)
      else if (status === BY_CTRL_C) this.#say(`done${ticked}, ended by Ctrl-C with a traceback`)
      else this.#say("error: see the console")
    } else {
      this.#end()
      this.console.print([[true, `${message.reason}\n`]], 0)
      this.#say("error: Python stopped")
    }
  }

  /** What to say of all exercises when one has been answered. */
  #progress(solved) {
    if (!solved) return ""
    this.solved = true
    this.#store("yes", SOLVED)
    showProgress()
    return ` You have solved ${exercises.filter((cell) => cell.solved).length} of ${exercises.length}.`
  }

  #stop() {
    this.#end()
    this.plot.stop()
    this.#say("stopped")
  }

  /** End the run, if there is one, at once. */
  #end() {
    this.#runs++
    this.#worker?.end()
    this.#worker = null
  }
}
