// Loaded with the teachers' page: judges the files that students hand in, and shows who solved what.

import { read } from "./answers.js"
import { csv } from "./csv.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { STOPPED, judge } from "./judging.js"
import { make, save } from "./make.js"
import { notHere } from "./python.js"
import { reveal } from "./unseen.js"

const base = new URL("../live/", document.currentScript.src).href

/** How many answers are judged at the same time. */
const LANES = Math.max(1, Math.min(4, navigator.hardwareConcurrency - 1))

/** The sign of each verdict in the table. */
const SIGNS = {
  solved: "✓",
  "not yet": "✗",
  open: "○",
  "did not end": "∞",
  "to read": "?",
  "not judged": "!",
  stopped: "■",
  waiting: "…",
  "being judged": "…",
}

/** Of these it is said how many there are, where there are any. */
const NOT_JUDGED = ["to read", "not judged", "stopped"]

/** A row of the table: what one student has handed in. */
class HandIn {
  constructor({ file, name, id, date, answers }) {
    Object.assign(this, { file, name, id, date: date ? local(date) : "", time: date?.getTime() ?? 0 })
    this.source = [this.date, file].filter(Boolean).join(", ")
    this.answers = new Map(answers.map(([number, text]) => [number, new Judged(this, number, text)]))
  }

  get solved() {
    return [...this.answers.values()].filter(({ verdict }) => verdict === "solved").length
  }

  /** Other names under which answers from the same browser were handed in. */
  get others() {
    return rows.filter(({ id, name }) => id === this.id && name !== this.name).map(({ name }) => name)
  }

  /** The files that were handed in under this name from other browsers. */
  get namesakes() {
    return rows.filter(({ id, name }) => id !== this.id && name === this.name).map(({ file }) => file)
  }
}

/** A time as in "2026-11-21 22:05", where the reader is. */
const local = (date) => date.toLocaleString("sv", { dateStyle: "short", timeStyle: "short" })

/** An answer and its verdict; its button in the table leads to what the checker said. */
class Judged {
  constructor({ name, source }, number, text) {
    Object.assign(this, { name, source, number, text })
    this.button = make("button", { type: "button" })
    this.button.addEventListener("click", () => show(this))
    this.becomes({ verdict: "waiting", said: "" })
  }

  get title() {
    return `${this.name}, exercise ${this.number}: ${this.verdict}`
  }

  becomes({ verdict, said }) {
    Object.assign(this, { verdict, said })
    this.button.textContent = SIGNS[verdict]
    this.button.className = `judge-${verdict.replaceAll(" ", "-")}`
    this.button.title = this.title
    this.button.ariaLabel = this.title
    if (shown === this) show(this, false)
  }

  /** What the checker is given: the first line only says which exercise it is, and that is known. */
  get code() {
    return this.text.startsWith("%%") ? `\n${this.text.split("\n").slice(1).join("\n")}` : this.text
  }
}

let rows = []
const refused = [] // files, each with a file name and why
let waiting = []
let lanes = 0
let stop = new AbortController()
let shown = null
let isSaved = true

// --- files ---

async function add(files) {
  const problems = []
  // All are read first: while one is being read, others are judged, which looks at the rows.
  const contents = await Promise.allSettled(files.map(read))
  for (const [number, { value, reason }] of contents.entries()) {
    if (reason) {
      refused.push({ file: files[number].name, why: reason.message })
      problems.push(`${files[number].name} is refused: ${reason.message}.`)
      continue
    }
    const row = new HandIn(value)
    const before = rows.find(({ name, id }) => name === row.name && id === row.id)
    if (before && before.time > row.time) {
      problems.push(`${row.file} is left out: ${row.name} handed in ${before.file} after it.`)
      continue
    }
    if (before) {
      remove(before)
      problems.push(`${row.file} takes the place of ${before.file}, which ${row.name} handed in before.`)
    }
    rows.push(row)
    waiting.push(...row.answers.values())
  }
  notes.append(...problems.map((said) => make("li", { textContent: said })))
  rows.sort((one, other) => one.name.localeCompare(other.name, undefined, { numeric: true }))
  isSaved = false
  draw()
  while (lanes < LANES && lanes < waiting.length) work()
}

function remove(row) {
  rows = rows.filter((other) => other !== row)
  waiting = waiting.filter((answer) => !answersOf([row]).includes(answer))
}

/** Judge what waits, one answer after the other. */
async function work() {
  lanes++
  for (let answer = waiting.shift(); answer; answer = waiting.shift()) {
    answer.becomes({ verdict: "being judged", said: "" })
    answer.becomes(await judge(base, answer.number, answer.code, stop.signal))
    isSaved = false
    tell()
  }
  lanes--
  tell()
}

function end() {
  for (const answer of waiting.splice(0)) answer.becomes(STOPPED)
  stop.abort()
  stop = new AbortController()
}

// --- what is shown ---

const answersOf = (of) => of.flatMap(({ answers }) => [...answers.values()])

function numbers() {
  return [...new Set(answersOf(rows).map(({ number }) => number))].sort((a, b) => a - b)
}

function draw() {
  const columns = numbers()
  const head = make("tr", {}, make("th", { scope: "col", textContent: "Name" }))
  head.append(make("th", { scope: "col", textContent: "Solved" }))
  const heading = (number) => make("th", { scope: "col", textContent: number, title: exercise(number, "Exercise") })
  head.append(...columns.map(heading))
  const body = rows.map((row) => {
    const said = [
      row.source,
      row.others.length && `same browser as ${row.others.join(", ")}`,
      row.namesakes.length && `same name as ${row.namesakes.join(", ")}, another browser`,
    ]
    const name = make("th", { scope: "row" }, row.name)
    name.append(...said.filter(Boolean).map((textContent) => make("small", { textContent })))
    row.count = make("td", {})
    const cells = columns.map((number) => make("td", {}, row.answers.get(number)?.button ?? nothing()))
    return make("tr", {}, name, row.count, ...cells)
  })
  table.replaceChildren(make("thead", {}, head), make("tbody", {}, ...body))
  results.hidden = rows.length + refused.length === 0
  scroll.hidden = legend.hidden = rows.length === 0
  tell()
}

const nothing = () => make("span", { textContent: "–", title: "no answer", role: "img", ariaLabel: "no answer" })

/** Say how far it is. */
function tell() {
  for (const row of rows) row.count.textContent = `${row.solved} of ${row.answers.size}`
  const all = answersOf(rows)
  const open = all.filter(({ verdict }) => verdict === "waiting" || verdict === "being judged").length
  progress.max = all.length || 1
  progress.value = all.length - open
  stopButton.ariaDisabled = String(open === 0)
  const said = open ? `Judging the answers of ${count(rows.length, "file")}` : `Done: ${outcome(all)}`
  if (status.textContent !== said) status.textContent = said // said once, not at each answer
}

/** How many answers were judged, and how many were not. */
function outcome(answers) {
  const kinds = NOT_JUDGED.map((kind) => [answers.filter(({ verdict }) => verdict === kind).length, kind])
  const judged = kinds.reduce((left, [number]) => left - number, answers.length)
  const said = [[judged, "judged"], ...kinds.filter(([number]) => number)].map((pair) => pair.join(" ")).join(", ")
  return refused.length ? `${said}; ${count(refused.length, "file")} refused` : said
}

/** An exercise with its title, if it has one. */
const exercise = (number, word = "exercise") => [`${word} ${number}`, TITLES[number]].filter(Boolean).join(": ")

const count = (number, what) => `${number} ${what}${number === 1 ? "" : "s"}`

/** Show what the checker said of an answer, and the answer. */
function show(answer, go = true) {
  shown = answer
  const text = reveal(answer.text.slice(0, 50_000))
  detail.replaceChildren(
    make("p", {}, make("strong", { textContent: `${answer.name}, ${exercise(answer.number)}: ${answer.verdict}` })),
    reveal(answer.said || "Nothing is known yet.").pre,
    make("p", { textContent: [`The answer, from ${answer.source}:`, text.said].filter(Boolean).join(" ") }),
    Object.assign(text.pre, { tabIndex: 0 }),
    button("Back to the table", () => answer.button.focus()),
  )
  detail.hidden = false
  if (go) detail.focus()
}

function saveTable() {
  const columns = numbers()
  const titles = columns.map((number) => exercise(number))
  const marks = ["same browser as", "same name in another browser"]
  const lines = [["name", "file", "note", "date", ...marks, "answers", "solved", ...titles]]
  for (const { name, file, date, others, namesakes, solved, answers } of rows) {
    const verdicts = columns.map((number) => answers.get(number)?.verdict ?? "")
    lines.push([name, file, "", date, others.join(", "), namesakes.join(", "), answers.size, solved, ...verdicts])
  }
  for (const { file, why } of refused) lines.push(["", file, `refused: ${why}`])
  isSaved = true
  save("answers.csv", "text/csv", csv(lines))
}

// --- the elements ---

function button(text, act) {
  const element = make("button", { type: "button", textContent: text })
  element.addEventListener("click", () => element.ariaDisabled !== "true" && act())
  return element
}

const input = make("input", { type: "file", multiple: true, accept: ".json,application/json" })
input.addEventListener("change", async () => {
  await add([...input.files])
  input.value = "" // the same file can be chosen again
})
const drop = make("div", { className: "judge-drop" })
drop.append(make("label", {}, "Drop the files of your students anywhere on this page, or choose them: ", input))

const status = make("span", { role: "status" })
const progress = make("progress", { ariaLabel: "Answers judged" })
const stopButton = button("Stop", end)
const bar = make("div", { className: "judge-bar" })
bar.append(progress, stopButton, button("Save as CSV", saveTable), status)
const notes = make("ul")
const table = make("table", { className: "table" })
const scroll = make("div", { className: "judge-scroll", role: "region", ariaLabel: "Who solved what", tabIndex: 0 }, table)
const words = ["solved", "not yet", "did not end", ...NOT_JUDGED].map((verdict) => `${SIGNS[verdict]} ${verdict}`)
const legend = make("p", {
  textContent:
    `${words.join(", ")}, – no answer. A sign leads to what the checker said. ` +
    "Use the table to see who needs help, not for marks.",
})
const detail = make("div", { className: "judge-said", role: "region", ariaLabel: "What the checker said", tabIndex: -1 })
detail.hidden = true
const results = make("div", { hidden: true }, bar, scroll, legend, detail)

/** Why nothing can be judged here, in a sentence; "" if it can. */
function missing() {
  return notHere("check answers") || (HAS_JSPI ? "" : `This browser cannot check answers: ${LACKS_JSPI}`)
}

const place = document.querySelector(".rosspin-judge")
const alert = make("div", { role: "alert", ariaAtomic: "false" }, notes)
place.replaceChildren(...(missing() ? [make("p", { textContent: missing() })] : [drop, alert, results]))
if (!missing()) {
  for (const kind of ["dragenter", "dragover", "dragleave", "drop"]) {
    addEventListener(kind, (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return
      event.preventDefault() // the browser would leave the page to show the file
      drop.classList.toggle("judge-over", kind === "dragenter" || kind === "dragover")
      if (kind === "drop") add([...event.dataTransfer.files])
    })
  }
  addEventListener("beforeunload", (event) => !isSaved && event.preventDefault())
}
