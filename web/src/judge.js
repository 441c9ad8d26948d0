// Loaded with the teachers' page: judges the files that students hand in, and shows who solved what.

import { isCpp, LOADS_CLANG } from "./answers.js"
import { chosen, dropped } from "./dropped.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { ask, judge, rest } from "./judging.js"
import { find, here, make, save } from "./make.js"
import { numberOf } from "./names.js"
import { notHere } from "./python.js"
import { Painter } from "./painter.js"
import { NOT_JUDGED, Table } from "./table.js"
import { reveal } from "./unseen.js"

const base = new URL("../live/", here()).href

/** How many answers are judged at the same time. */
const AT_ONCE = Math.max(2, Math.min(4, navigator.hardwareConcurrency - 1))

/** So many cells are shown, which come piece by piece. */
const MOST_CELLS = 3000
const PIECE = 500
const LEAST_ROWS = 10 // in a piece

/** @type {Record<import("./table.js").Verdict, string>} the sign of each verdict in the table */
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

/** @typedef {import("./table.js").Answer} Answer */

/** @type {Answer | null} the one for which it is shown what the checker said */
let shown = null

/** @type {(exercise: string, text: string, stopped: AbortSignal) => Promise<import("./judging.js").Judgement>} */
function judgeOne(exercise, text, stopped) {
  if (isCpp(text)) loads.textContent = `To judge answers in C++, ${LOADS_CLANG}.`
  return judge(base, exercise, text, stopped)
}

const known = new Table((job) => ask(base, job), judgeOne, AT_ONCE, (answer) => {
  if (!answer) return draw()
  if (signs.has(answer)) mark(answer)
  if (shown === answer) show(answer, false)
  if (known.isDone) end()
  teller.soon()
})
const teller = new Painter(() => tell())

let reading = 0 // drops whose files are being read

/** @type {import("./protocol.js").Results["report"]["hard"]} what was hard, once all is judged */
let missed = []

/** @param {import("./dropped.js").Dropped[] | Promise<import("./dropped.js").Dropped[]>} coming */
async function add(coming) {
  reading++
  missed = []
  results.hidden = false
  progress.removeAttribute("value")
  status.textContent = "Reading the files"
  const problem = await known.add(await coming).catch((error) => String(error.message))
  reading--
  tell()
  const lines = known.problems.slice(notes.childElementCount)
  if (problem) lines.push(problem)
  notes.append(...lines.map((textContent) => make("li", { textContent })))
  const more = `${known.unlisted} more such lines are not shown. Save as CSV lists each file that is refused.`
  unshown.textContent = known.unlisted ? more : ""
  if (known.isDone) end()
}

/** All is judged. */
async function end() {
  rest()
  const { hard } = await known.report().catch(() => ({ hard: [] }))
  if (!known.isDone) return
  missed = hard
  teller.soon()
}

async function saveTable() {
  try {
    save("answers.csv", "text/csv", (await known.report()).csv)
    known.isSaved = true
  } catch (error) {
    notes.append(make("li", { textContent: `The table could not be written: ${error}` }))
  }
}

// --- what is shown ---

/** @type {WeakMap<Answer, HTMLButtonElement>} the buttons in the table, each of which leads to what the checker said */
const signs = new WeakMap()

/**
 * The button of an answer, with its verdict as it is now.
 *
 * @param {Answer} answer
 */
function mark(answer) {
  const sign = signs.get(answer) ?? button("", () => show(answer))
  signs.set(answer, sign)
  sign.textContent = SIGNS[answer.verdict]
  sign.className = `judge-${answer.verdict.replaceAll(" ", "-")}`
  sign.title = sign.ariaLabel = answer.title
  return sign
}

function draw() {
  const columns = known.exercises
  const focused = [...table.querySelectorAll("thead button")].indexOf(/** @type {Element} */ (document.activeElement))
  /** @type {(by: string, text: string, title?: string) => HTMLElement} */
  const heading = (by, text, title = "") => {
    const { isDown } = known.order
    const ariaSort = known.order.by !== by ? "none" : isDown ? "descending" : "ascending"
    return make("th", { scope: "col", title, ariaSort }, button(text, () => known.sort(by)))
  }
  const head = make("tr", {}, heading("name", "Name"), heading("solved", "Solved"))
  head.append(...columns.map((name) => heading(name, numberOf(name), titleOf(name, "Exercise"))))
  const made = (/** @type {(typeof known.rows)[number]} */ row) => {
    const { others, namesakes } = row
    const said = [row.source, row.student && `ID ${row.student}`, row.note]
    if (others.length) said.push(`same browser as ${others.join(", ")}`)
    if (namesakes.length) said.push(`same name as ${namesakes.join(", ")}, another browser`)
    const name = make("th", { scope: "row" }, row.name)
    name.append(...said.filter(Boolean).map((textContent) => make("small", { textContent })))
    const answers = columns.map((name) => row.answers.get(name))
    const solved = make("td", { textContent: solvedOf(row) })
    solvedCells.set(row, solved)
    return make("tr", {}, name, solved, ...answers.map((answer) => make("td", {}, answer ? mark(answer) : nothing())))
  }
  solvedCells.clear()
  const body = make("tbody")
  table.replaceChildren(make("thead", {}, head), body)
  const rows = known.rows.slice(0, Math.floor(MOST_CELLS / (columns.length + 2)))
  const size = Math.max(LEAST_ROWS, Math.floor(PIECE / (columns.length + 2)))
  const mine = ++drawing
  const append = (/** @type {number} */ from) => {
    if (mine !== drawing) return
    body.append(...rows.slice(from, from + size).map(made))
    if (from + size < rows.length) setTimeout(append, 0, from + size)
  }
  append(0)
  const again = /** @type {HTMLElement | undefined} */ (table.querySelectorAll("thead button")[focused])
  again?.focus()
  results.hidden = known.rows.length + known.refused === 0
  scroll.hidden = legend.hidden = known.rows.length === 0
  cut.textContent =
    rows.length < known.rows.length
      ? `The first ${rows.length} of ${known.rows.length} rows are shown; sort the table to see others. Save as CSV has all.`
      : ""
  tell()
}

let drawing = 0 // counts what is drawn: only the last is wanted

/** @type {Map<(typeof known.rows)[number], HTMLElement>} where it is said how many a row has solved */
const solvedCells = new Map()

const solvedOf = (/** @type {(typeof known.rows)[number]} */ row) => `${row.solved} of ${row.answers.size}`

const nothing = () => make("span", { textContent: "–", title: "no answer", role: "img", ariaLabel: "no answer" })

/** Say how far it is. */
function tell() {
  if (reading) return
  for (const [row, cell] of solvedCells) cell.textContent = solvedOf(row)
  const { answers, said } = known
  const open = answers.filter(({ isOpen }) => isOpen).length
  progress.max = answers.length || 1
  progress.value = answers.length - open
  stopButton.ariaDisabled = String(open === 0)
  if (status.textContent !== said) status.textContent = said // said once, not at each answer
  hard.hidden = !missed.length
  hard.replaceChildren(make("p", {}, make("strong", { textContent: "What was hard" })), make("ul", {}, ...missed.map(hardness)))
}

/** What was hard of an exercise: the hints say which belief has failed, and how often. */
function hardness(/** @type {(typeof missed)[number]} */ [exercise, answered, solved, hints]) {
  const told = hints.map(([hint, count]) => make("li", { textContent: `${count} × ${hint}` }))
  return make("li", {}, `${titleOf(exercise, "Exercise")}: ${solved} of ${answered} solved`, make("ul", {}, ...told))
}

/** An exercise with its title, if it has one. */
const titleOf = (/** @type {string} */ name, word = "exercise") =>
  [`${word} ${numberOf(name)}`, EXERCISES[name]?.title].filter(Boolean).join(": ")

/**
 * Show what the checker said of an answer, and the answer.
 *
 * @param {Answer} answer
 */
async function show(answer, go = true) {
  shown = answer
  const found = await known.text(answer).catch(() => ({ text: "" }))
  if (shown !== answer) return
  const focused = [...detail.children].indexOf(/** @type {Element} */ (document.activeElement))
  const { row, exercise, verdict, said } = answer
  const text = reveal(found.text)
  detail.replaceChildren(
    make("p", {}, make("strong", { textContent: `${row.name}, ${titleOf(exercise)}: ${verdict}` })),
    reveal(said || "Nothing is known yet.").pre,
    make("p", { textContent: [`The answer, from ${row.source}:`, text.said].filter(Boolean).join(" ") }),
    Object.assign(text.pre, { tabIndex: 0 }),
    button("Back to the table", () => mark(answer).focus()),
  )
  detail.hidden = false
  if (go) detail.focus()
  else /** @type {HTMLElement | undefined} */ (detail.children[focused])?.focus()
}

// --- the elements ---

/**
 * @param {string} text
 * @param {() => void} act
 */
function button(text, act) {
  const element = make("button", { type: "button", textContent: text })
  element.addEventListener("click", () => element.ariaDisabled !== "true" && act())
  return element
}

const input = make("input", { type: "file", multiple: true, accept: ".json,.zip,application/json,application/zip" })
input.addEventListener("change", async () => {
  await add(chosen(input.files ?? []))
  input.value = "" // the same file can be chosen again
})
const drop = make("div", { className: "judge-drop" })
drop.append(make("label", {}, "Drop the files of your students, or folders and zips of them, anywhere on this page, or choose them: ", input))

const status = make("span", { role: "status" })
const progress = make("progress", { ariaLabel: "Answers judged" })
const stopButton = button("Stop", () => known.stop())
const bar = make("div", { className: "judge-bar" })
const saveButton = button("Save as CSV", saveTable)
bar.append(progress, stopButton, saveButton, status)
const notes = make("ul")
const unshown = make("p")
const loads = make("p")
const cut = make("p")
const table = make("table", { className: "table" })
const scroll = make("div", { className: "judge-scroll", role: "region", ariaLabel: "Who solved what", tabIndex: 0 }, table)
const words = [.../** @type {const} */ (["solved", "not yet", "did not end"]), ...NOT_JUDGED]
const legend = make("p", {
  textContent:
    `${words.map((verdict) => `${SIGNS[verdict]} ${verdict}`).join(", ")}, – no answer. A sign leads to what the checker ` +
    "said. Use the table to see who needs help, not for marks.",
})
const detail = make("div", { className: "judge-said", role: "region", ariaLabel: "What the checker said", tabIndex: -1 })
detail.hidden = true
const hard = make("div", { className: "judge-hard", hidden: true })
const results = make("div", { hidden: true }, bar, scroll, cut, legend, detail, hard)

/** Why nothing can be judged here, in a sentence; "" if it can. */
const missing = notHere("check answers") || (HAS_JSPI ? "" : `This browser cannot check answers: ${LACKS_JSPI}`)

const alert = make("div", { role: "alert", ariaAtomic: "false" }, notes, unshown, loads)
find(".rosspin-judge").replaceChildren(...(missing ? [make("p", { textContent: missing })] : [drop, alert, results]))
if (!missing) {
  for (const kind of /** @type {const} */ (["dragenter", "dragover", "dragleave", "drop"])) {
    addEventListener(kind, (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return
      event.preventDefault() // the browser would leave the page to show the file
      drop.classList.toggle("judge-over", kind === "dragenter" || kind === "dragover")
      if (kind === "drop") add(dropped(event.dataTransfer))
    })
  }
  addEventListener("beforeunload", (event) => !known.isSaved && event.preventDefault())
}
