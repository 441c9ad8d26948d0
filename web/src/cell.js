// A listing that can be edited and run: its buttons, its status line, what its runs show.

import { ANSWER, LOADS_CLANG } from "./answers.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { Kept } from "./kept.js"
import { find, make } from "./make.js"
import { SEE_CONSOLE } from "./outcome.js"
import { exercises, progress, showProgress } from "./progress.js"
import { IS_IT_THERE, load, start, warmUp } from "./python.js"

/** For how long (s) a node runs, unless the reader says otherwise. */
const SECONDS = "10"

/** What a reader is told before a listing in C++ is changed. */
const CLANG = `To run a change, ${LOADS_CLANG}`

/** What a node has in it that reads its command line. */
const READS_ARGUMENTS = /\b(get_param|search_param|declare_parameters?|argv)\b|<arg /
const READS_ARGUMENTS_IN_CPP = /\bgetParam|\bparam(<\w+>)?\(|\bparam::|\bdeclare_parameters?\b/

/** @type {[RegExp, string][]} what a node of each ROS has in it, and an example of how a parameter of it is set */
const EXAMPLES = [[/\brospy\b|\bros\/ros\.h\b/, "_frequency:=5"], [/\brclpy\b|\brclcpp\//, "--ros-args -p frequency:=5.0"]]

/** @typedef {import("./kept.js").Keeping} Keeping */

/** @type {Cell[]} all of the page */
const cells = []

/**
 * Those whose nodes run together, if the reader wants it, in Python and in C++: the first two, the next two, and so on.
 *
 * @type {[Cell[], Cell[]]}
 */
const together = [[], []]

/**
 * The plot below a listing from when the site was built.
 *
 * @param {HTMLElement} listing
 */
function made(listing) {
  const next = /** @type {HTMLElement | null} */ ((listing.closest(".literal-block-wrapper") ?? listing).nextElementSibling)
  return next?.matches("figure.live-made") ? next : null
}

/**
 * The module share.js; `base` is the address of the folder that our files are in.
 *
 * @type {(base: string) => Promise<typeof import("./share.js")>}
 */
export const loadShare = (base) => import(`${base}share.js`)

export class Cell {
  #base
  #index
  #pre
  #original
  #highlighted
  /** @type {Keeping} */
  #kept // what the reader has written, or what came with a link
  /** @type {Keeping | null} */
  #own = null // what the reader has written, while the other is shown
  #name
  /** @type {string} */
  #program // of a node in C++: the SHA-256 of what was compiled with the page; else ""
  /** @type {string} */
  #launch // of a launch file: the SHA-256 of what it starts; else ""
  #simulates // whether its first line says for how long it runs
  /** @type {import("./plot.js").Plot | null} */
  #plot = null // of what runs have done, from the first one on
  /** @type {import("./console.js").Console | null} */
  #printed = null // what they have printed, likewise
  /** @type {HTMLElement | null} */
  #made = null // the plot that was made with the page, if there is one
  /** @type {HTMLElement | null | undefined} */
  #output // of a notebook's cell: what it printed when the site was built
  /** @type {(Omit<import("./protocol.js").PinJob, "kind">) | null} */
  #pinned = null // what the last run showed, if a test can pin it
  #ran = "" // what the last run ran
  #hasRun = false // whether what a run has shown, maybe nothing, is there still
  #offerBoth = () => {} // shows the buttons for running with another one
  #endSteps = () => {} // takes away what goes through it step by step
  /** @type {import("./editor.js").Editor | null} */
  #editor = null
  /** @type {import("./runs.js").Run | null} */
  #worker = null
  #runs = 0

  /**
   * @param {HTMLElement} listing what Sphinx made of a listing
   * @param {number} index its number on the page
   * @param {string} base the address of the folder that our files are in
   */
  constructor(listing, index, base) {
    this.#base = base
    this.#index = index
    this.#pre = find("pre", listing)
    this.#original = /** @type {string} */ (this.#pre.textContent)
    this.#highlighted = [...this.#pre.childNodes]
    this.#program = listing.className.match(/\bprogram-([\da-f]{64})\b/)?.[1] ?? ""
    this.#launch = listing.className.match(/\blaunch-([\da-f]{64})\b/)?.[1] ?? ""
    const caption = listing.parentElement?.querySelector(".code-block-caption .caption-text")
    this.exercise = this.#original.match(/^%%answer (\S+)/)?.[1] ?? "" // that it answers; a text is then checked rather than run
    this.#simulates = /^%%(simulate|drive) /.test(this.#original)
    // hand-in.js, which is on each page that has exercises, keeps the answers to all of them.
    const answer = this.exercise && window.rosspinStore?.of(this.exercise, this.language)
    this.#kept = answer || new Kept(`${location.pathname}:${index}`, this.#original)
    this.#kept.changed = (said) => this.#own || this.#follow(said)
    this.#name = this.exercise ? `answer ${this.exercise}` : (caption?.textContent ?? `node.${this.isCpp ? "cpp" : "py"}`).trim().replace(/.*\//, "")
    if (this.exercise && this.isCpp) this.#name += " in C++"
    this.#output = listing.closest(".cell")?.querySelector(".cell_output")
    this.#made = made(listing)
    const button = (/** @type {string} */ text, /** @type {() => void} */ act) => {
      const element = make("button", { type: "button", textContent: text, ariaLabel: `${text} ${this.#name}` })
      element.addEventListener("click", () => element.ariaDisabled !== "true" && act())
      return element
    }
    this.run = button("Run", () => this.#run())
    const own = Number(this.isCpp)
    const place = together[own].length
    const partners = () => [own, 1 - own].map((language) => together[language][place ^ 1])
    this.both = button("Run both", () => this.#run(partners()[0]))
    this.mixed = button(this.isCpp ? "Run with Python" : "Run with C++", () => this.#run(partners()[1]))
    this.both.hidden = this.mixed.hidden = true
    this.#offerBoth = () => {
      const [same, other] = partners()
      this.both.hidden = !same
      this.mixed.hidden = !other
      if (other) this.mixed.title = `Run ${this.#name} together with ${other.#name}`
    }
    for (const sign of ["pointerenter", "focus"]) {
      this.run.addEventListener(sign, () => this.#warmUp())
      for (const pair of [this.both, this.mixed]) pair.addEventListener(sign, () => warmUp(this.#base, false, ""))
    }
    if (listing.matches(".together")) {
      together[own].push(this)
      for (const cell of together.flat()) cell.#offerBoth()
    }
    this.stop = button("Stop", () => this.#stop())
    this.edit = button("Edit", () => this.#edit())
    this.reset = button("Reset", () => this.#reset())
    this.share = button("Copy link", () => this.#share())
    this.pin = button("Copy as test", () => this.#pin())
    this.earlier = button("Restore earlier version", () => this.#bringBack())
    this.copy = button("Copy text", () => this.#copy(this.#text, "copied"))
    this.seconds = make("input", { type: "number", min: "0", max: "3600", step: "any", value: SECONDS })
    this.args = make("input", { spellcheck: false, autocomplete: "off", autocapitalize: "off" })
    this.arguments = make("label", { className: "live-arguments" }, "Arguments ", this.args)
    this.args.addEventListener("keydown", (event) => event.key === "Enter" && this.#run())
    this.args.addEventListener("input", () => this.#offer())
    this.speed = make("select", { ariaLabel: "Speed" })
    for (const [textContent, value] of [["instantly", "0"], ["10 times as fast", "10"], ["real time", "1"]]) {
      this.speed.append(make("option", { textContent, value }))
    }
    this.status = make("span", { role: "status" })
    this.progress = make("progress", { hidden: true, max: 1, ariaLabel: "What is loaded" })
    this.pin.title = "Copy a test for pytest that expects what this run has shown"
    this.pin.hidden = true
    if (this.isCpp) this.edit.title = CLANG
    // The status line says how it went; read out, a flood would drown everything.
    const properties = { className: "live-console", role: "log", ariaLive: "off", ariaLabel: `Console of ${this.#name}` }
    this.console = make("div", { ...properties, tabIndex: 0, hidden: true })
    this.notice = make("p", { className: "live-notice", hidden: true })
    this.copied = make("textarea", { readOnly: true, hidden: true, rows: 4, ariaLabel: "To be copied" })
    listing.append(...this.#arranged())
    this.#pre.addEventListener("click", () => getSelection()?.isCollapsed && this.#edit())
    if (answer) exercises.add(this.exercise)
    cells.push(this)
    this.#showKept()
  }

  /** What the reader can press, which stays in view next to a long listing, and what comes of it. */
  #arranged() {
    const bar = make("div", { className: "live-bar", role: "group", ariaLabel: `Run ${this.#name} in this page` })
    bar.append(this.run, this.both, this.mixed, this.stop, this.edit, this.reset, this.earlier, this.share, this.copy, this.pin)
    const [seconds, speed, args] = [make("label", {}, this.seconds, " s"), this.speed, this.arguments]
    bar.append(...(this.exercise ? [] : this.#simulates ? [speed] : [seconds, speed, args]), this.progress, this.status)
    const parts = [this.notice, this.copied, this.#made ?? "", this.console]
    const onward = this.exercise && !this.#pre.closest(".sd-tab-set") ? document.querySelectorAll(".exercise-next") : []
    return [bar, make("div", { className: "live-cell" }, ...parts, ...onward)]
  }

  /** Show what came of a run to a reader who has pressed Run next to a listing that ends farther down. */
  #reveal() {
    const { bottom } = /** @type {HTMLElement} */ (this.run.parentElement).getBoundingClientRect()
    const isStuck = bottom > innerHeight - 1 && bottom < innerHeight + 1
    if (isStuck) this.console.parentElement?.scrollIntoView({ block: "nearest" })
  }

  /** Whether it is in C++. */
  get isCpp() {
    return this.#program !== ""
  }

  /** The name of its file, as a compiler or a traceback has it. */
  get #filename() {
    return this.exercise && this.isCpp ? ANSWER : this.#name
  }

  /** @type {import("./editor.js").Language} */
  get language() {
    return this.isCpp ? "cpp" : this.#launch ? "xml" : "python"
  }

  /** The text as it is now. */
  get #text() {
    return this.#editor?.text() ?? /** @type {string} */ (this.#pre.textContent)
  }

  /** Offer what can be done with the text as it is: arguments for a node that reads some, Reset for one that was changed. */
  #offer() {
    const reads = this.isCpp ? READS_ARGUMENTS_IN_CPP : READS_ARGUMENTS
    this.arguments.hidden = !reads.test(this.#text) && !this.args.value
    this.args.placeholder = EXAMPLES.find(([sign]) => sign.test(this.#text))?.[1] ?? ""
    const isUntouched = this.#text === this.#original && this.seconds.value === SECONDS && !this.args.value
    this.reset.ariaDisabled = String(isUntouched && !this.#own && !this.#hasRun)
    this.earlier.hidden = !this.#kept.hasEarlier
  }

  /**
   * Say where the cell is; its buttons follow. What is not kept is said until it is.
   *
   * @param {string} status
   */
  #say(status) {
    const { unkept } = this.#kept
    this.status.textContent = [status, unkept && `your text is not kept: ${unkept}`].filter(Boolean).join("; ")
    this.copy.hidden = !unkept
    this.stop.ariaDisabled = String(this.#worker === null)
    this.#offer()
  }

  // --- the text ---

  /**
   * Show a text in place of the one that is there. The Copy button of the listing copies it.
   *
   * @param {string} text
   */
  #show(text) {
    if (text === this.#original) this.#pre.replaceChildren(...this.#highlighted)
    else this.#pre.textContent = text
  }

  /** Show what is kept. */
  #showKept() {
    const { text, said } = this.#kept
    if (text !== null) {
      this.#show(text)
      this.#showMade(text === this.#original)
    }
    this.#say(said)
  }

  /**
   * Show or hide what was made of the original when the site was built.
   *
   * @param {boolean} shown
   */
  #showMade(shown) {
    for (const element of [this.#output, this.#made]) if (element) element.hidden = !shown
  }

  /**
   * Keep what the reader has written, and say what there is to say of that.
   *
   * @param {string} text
   */
  #keep(text) {
    const isNews = this.#kept.write(text === this.#original ? null : text)
    if (isNews && !this.#worker) this.#say(this.#kept.said)
  }

  /**
   * Show what is kept now, since another tab or the button for it has changed that.
   *
   * @param {string} said
   */
  #follow(said) {
    showProgress()
    const text = this.#kept.text ?? this.#original
    if (text !== this.#text && this.#editor) this.#editor.write(text)
    else this.#show(text)
    if (!this.#hasRun) this.#showMade(text === this.#original)
    if (!this.#worker) this.#say(said)
  }

  #bringBack() {
    this.#end()
    this.#clear(false)
    this.#follow(/** @type {string} */ (this.#kept.bringBack?.()))
    if (this.earlier.hidden) this.reset.focus()
  }

  /**
   * Open the editor, at a line if one is given.
   *
   * @param {number} [line]
   */
  async #edit(line) {
    this.#warmUp()
    if (!this.#editor) {
      /** @type {typeof import("./editor.js") | null} */
      const loaded = await import(`${this.#base}editor.js`).catch(() => null)
      if (!loaded) return this.#say(`error: the editor could not be loaded. ${IS_IT_THERE}`)
      if (this.#editor) return
      this.#editor = loaded.open(this.#text, `Code of ${this.#name}. Escape leaves the editor.`, {
        language: this.language,
        wraps: this.#pre.className !== "",
        changed: (text) => {
          this.#show(text)
          this.#keep(text)
          this.#offer()
        },
        run: () => this.#run(),
        leave: () => this.run.focus(),
      })
      this.#pre.before(this.#editor.element)
      this.#pre.hidden = true
    }
    if (this.isCpp && !this.#worker) this.#say(CLANG)
    if (line) this.#editor.goTo(line)
    else this.#editor.focus()
  }

  /** Back to the page's own text, or from one that came with a link to the reader's. */
  #reset() {
    this.#restore()
    if (this.#own) history.replaceState(null, "", location.pathname + location.search)
    else this.#kept.write(null)
    this.#kept = this.#own ?? this.#kept
    this.#own = null
    this.notice.hidden = true
    this.#showKept()
  }

  /** Show the cell as it came with the page. */
  #restore() {
    this.#end()
    this.#editor?.element.remove()
    this.#editor = null
    this.#show(this.#original)
    this.#pre.className = ""
    this.#pre.hidden = false
    this.seconds.value = SECONDS
    this.args.value = ""
    this.#clear(false)
  }

  // --- links and copies ---

  /**
   * Show a text that came with a link, which stands in for what is kept, and the fields next to it. It is not run. `shown`
   * is an element with the text as it should look.
   *
   * @param {{kept: Keeping, seconds: number, args: string, notice: string, shown: HTMLElement}} received
   */
  receive({ kept, seconds, args, notice, shown }) {
    this.#restore()
    this.#own ??= this.#kept
    this.#kept = kept
    this.seconds.value = `${seconds}`
    this.args.value = args
    this.notice.textContent = notice
    this.notice.hidden = false
    this.#showKept()
    if (kept.text !== this.#original) {
      this.#pre.replaceChildren(...shown.childNodes)
      this.#pre.className = shown.className
    }
    const fold = this.#pre.closest("details")
    if (fold) fold.open = true
    this.notice.scrollIntoView({ block: "center" })
  }

  async #share() {
    const seconds = this.seconds.valueAsNumber || 0
    const listing = { cell: this.#index, text: this.#text, seconds, args: this.args.value }
    try {
      const { address } = await loadShare(this.#base)
      await this.#copy(await address(this.#pre, listing), "the link is copied; the code is in it")
    } catch (error) {
      const { said = `the link could not be made. ${IS_IT_THERE}` } = /** @type {{said?: string}} */ (error)
      this.#say(`error: ${said}`)
    }
  }

  /**
   * Copy a text, or where the browser does not let us, let the reader copy it.
   *
   * @param {string} text
   * @param {string} said once it is copied
   */
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

  /** Copy a test that pins what the reader sees. It is made where nothing of the run is. */
  async #pin() {
    const [shown, number] = [this.#pinned, this.#runs]
    if (!shown) return
    this.#say("writing the test")
    const test = await load(this.#base).then((runs) => runs.pin(shown)).catch(() => "")
    if (number !== this.#runs) return
    if (test) await this.#copy(test, "the test is copied: save it in a file for pytest")
    else this.#say(`error: the test could not be written. ${IS_IT_THERE}`)
  }

  // --- runs ---

  /**
   * Take away what the last run showed. What was made when the site was built makes way for a run.
   *
   * @param {boolean} runs
   */
  #clear(runs) {
    this.#printed?.clear()
    this.#plot?.clear()
    this.#plot?.drive([])
    this.#endSteps()
    this.#endSteps = () => {}
    this.copied.hidden = this.pin.hidden = true
    this.#pinned = null
    this.#hasRun = runs
    this.#showMade(!runs)
  }

  #warmUp() {
    warmUp(this.#base, this.exercise !== "", this.exercise ? "" : this.#program)
  }

  /** @type {import("./runs.js").Node} */
  get #node() {
    const source = this.#text
    const ros = !this.isCpp ? 0 : /\brclcpp\//.test(source) ? 2 : 1
    return { source, filename: this.#filename, args: this.args.value, program: source === this.#original ? this.#program : "", ros }
  }

  /** @param {Cell} [other] whose node runs with this one's */
  async #run(other) {
    this.#end()
    const number = ++this.#runs
    const seconds = this.seconds.valueAsNumber
    this.#clear(true)
    if (!this.seconds.checkValidity() || !(seconds >= 0)) {
      return this.#say("error: seconds must be a number from 0 to 3600")
    }
    if (other && !HAS_JSPI) return this.#say(`error: this browser runs one node at a time: ${LACKS_JSPI}`)
    const node = this.#node
    this.#ran = node.source
    const beside = other ? [other.#node] : []
    const launch = this.#launch
    const listings = launch ? cells.filter(({ exercise }) => !exercise).map((cell) => ({ ...cell.#node, original: cell.#original })) : []
    const job = { ...node, seconds, speed: Number(this.speed.value), beside, exercise: this.exercise, launch, listings }
    const hear = (/** @type {import("./runs.js").Told} */ message) => this.#hear(message, job)
    this.#expect(seconds)
    this.#worker = start(this.#base, job, (message) => number === this.#runs && hear(message))
    this.#say(this.isCpp && !other && !this.exercise ? "starting" : "starting Python")
  }

  /**
   * Have a plot and a console ready, before anything comes of a run that should last so long.
   *
   * @param {number} seconds
   */
  #expect(seconds) {
    load(this.#base).then(
      ({ Console, Plot }) => {
        const file = this.exercise && !this.isCpp ? "" : this.#filename
        this.#printed ??= new Console(this.console, file, (line) => this.#edit(line))
        if (!this.#plot) {
          this.#plot = new Plot(`Ticks of ${this.#name}`, (chunks) => this.#printed?.mark(chunks))
          this.copied.after(this.#plot.driven, this.#plot.element)
        }
        this.#plot.expect(seconds)
      },
      () => {}, // the run will say so
    )
  }

  /**
   * @param {import("./runs.js").Told} message
   * @param {import("./runs.js").Text} job
   */
  #hear(message, job) {
    this.progress.hidden = message.kind !== "doing"
    if (message.kind === "begun") {
      this.#say("running")
    } else if (message.kind === "doing") {
      if (message.share < 0) this.progress.removeAttribute("value")
      else this.progress.value = message.share
      this.#say(message.said)
    } else if (message.kind === "faults") {
      if (message.filename === this.#filename) this.#blame(message.faults)
    } else if (message.kind === "batch") {
      this.#printed?.print(message.chunks, message.leftOut)
      this.#plot?.add(message.ticks)
    } else if (message.kind === "end") {
      this.#worker = null
      this.#printed?.finish()
      const { result } = message
      this.#plot?.drive(result.drive)
      if ("solved" in result) this.#say((result.verdict || SEE_CONSOLE) + this.#progress(result.solved))
      else this.#finish(result, job)
      if (!("scenes" in result && result.scenes)) this.#reveal()
    } else {
      this.#end()
      this.#printed?.print([[true, `${message.reason}\n`, 0, 0]], 0)
      this.#printed?.finish()
      this.#say(`error: ${this.#printed ? `${this.isCpp ? "it" : "Python"} stopped` : message.reason}`)
    }
  }

  /**
   * @param {import("./protocol.js").RunResult} result
   * @param {import("./runs.js").Text} job
   */
  async #finish(result, job) {
    const { count, ticks, lost, chunks, alternative, end, scenes } = result
    const number = this.#runs
    const { said, pinned } = (await load(this.#base)).outcome(result, job, this.#printed?.whole ?? null)
    if (number !== this.#runs) return
    this.#pinned = pinned
    this.pin.hidden = !pinned
    if (count) this.#plot?.finish(ticks, count, alternative, chunks, end, lost)
    if (scenes) this.#offerSteps(scenes) // below the plot, which is now as high as it will be
    this.#say(said)
  }

  /**
   * Let the reader go through what a run did, step by step. Who waits for whom is drawn immediately.
   *
   * @param {import("./protocol.js").Scenes} scenes
   */
  async #offerSteps(scenes) {
    /** @type {() => Promise<typeof import("./stepper.js")>} */
    const load = () => import(`${this.#base}stepper.js`)
    const steps = make("div", { className: "live-steps" })
    let end = () => {}
    this.#endSteps = () => {
      end()
      steps.remove()
    }
    this.console.before(steps)
    if (scenes.steps.length) {
      const [name, pre, ran] = [this.#name, this.#pre, this.#ran]
      const button = make("button", { type: "button", textContent: "Step through this run" })
      button.addEventListener("click", async () => {
        const { open } = await load()
        if (button.isConnected) end = open(button, name, scenes, pre, ran)
      })
      steps.append(button)
    }
    if (scenes.rings.length) steps.append(...(await load()).drawn(scenes.rings))
    this.#reveal()
  }

  /**
   * What to say of all exercises when one has been answered.
   *
   * @param {boolean} solved
   */
  #progress(solved) {
    if (!solved) return ""
    const said = this.#kept.solve?.(this.#ran === this.#original ? null : this.#ran)
    this.console.after(...document.querySelectorAll(".exercise-next"))
    showProgress()
    return said ?? ` You have solved ${progress()}.`
  }

  /**
   * Show in the listing what the compiler says of it.
   *
   * @param {import("./faults.js").Fault[]} faults
   */
  async #blame(faults) {
    if (!this.#editor) await this.#edit()
    this.#editor?.blame(faults)
  }

  #stop() {
    this.#end()
    this.#printed?.finish()
    this.#plot?.stop()
    this.#say("stopped")
  }

  /** End the run immediately, if there is one. */
  #end() {
    this.progress.hidden = true
    this.#runs++
    this.#worker?.end()
    this.#worker = null
  }
}
