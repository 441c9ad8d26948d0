// Loaded with the page "Show your log": has a log looked at by the page's Python, in a sandbox, and shows what was found.
// Nothing leaves the computer, and all that comes from a log is shown as text.

import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { SIGN, pack, unpack } from "./log-link.js"
import { find, here, make, save } from "./make.js"
import { IS_IT_THERE, load, notHere, warmUp } from "./python.js"
import { HEIGHT, WIDTH, chosen, describe, dots, driftOf, nameOf, part, rateOf, rowsIn, say } from "./series.js"
import { COLOURS, MARGIN, draw, drawTimeline, percent } from "./svg.js"

const base = new URL("../live/", here()).href
const examples = new URL("examples/", here())
const root = new URL("../../", here())

/** So much (bytes) of a log is read here, and for so long (ms). */
const MOST = 5_000_000
const TIME = 60_000

/** The logs to try. Each is the console of a node on the real ROS 2: see tests/look. */
const EXAMPLES = {
  "a healthy timer": "r2_timer_10.log",
  "a sleep after the work": "r2_sleep_10_work_5.log",
  "a slow neighbour": "r2_blocks_two.log",
}

/** @typedef {import("./protocol.js").LookResult} LookResult */

/** @type {{name: string, log: ArrayBuffer, isCut: boolean} | null} the log that is shown */
let current = null

/** @type {import("./runs.js").Run | null} */
let run = null
let number = 0 // of the log that was given last

/** End what is running; the number of what begins now. */
function begin() {
  run?.end()
  run = null
  results.hidden = true
  problem.textContent = notice.textContent = ""
  return ++number
}

/** @param {string} text */
function fail(text) {
  begin()
  status.textContent = ""
  problem.textContent = text
}

/**
 * Look at a log.
 *
 * @param {string} name
 * @param {Blob} blob
 */
async function look(name, blob) {
  const mine = begin()
  status.textContent = `Reading ${name}.`
  const log = await blob.slice(0, MOST).arrayBuffer().catch(() => null)
  if (mine !== number) return
  if (!log) return fail(`${name} cannot be read. Is it a folder, or has it changed?`)
  const isCut = blob.size > MOST
  const runs = await load(base).catch(() => null)
  if (mine !== number) return
  if (!runs) return fail(`Python could not be loaded. ${IS_IT_THERE}`)
  /** @type {number | undefined} */
  let timer
  run = runs.look(log, name, (message) => {
    if (mine !== number) return
    clearTimeout(timer)
    if (message.kind === "begun") {
      status.textContent = `Looking at ${name}.`
      timer = setTimeout(fail, TIME, `${name}: not read in ${TIME / 1000} s. Give a part of it, or use rosspin look FILE.`)
    } else if (message.kind === "failed") {
      fail(message.reason)
    } else if (message.kind === "end") {
      if (message.result.problem) return fail(`${name}: ${message.result.problem}.`)
      current = { name, log, isCut }
      show(message.result)
    }
  })
}

// --- what was found ---

/** @param {LookResult} result */
function show(result) {
  const { verdicts, series, entries, seconds } = result
  const [{ title, certain }] = verdicts
  const more = verdicts.length > 1 ? `, and ${verdicts.length - 1} more` : ""
  const { name = "", isCut = false } = current ?? {}
  status.textContent = `${name}: ${entries} entries in ${say(seconds)}. ${title} (${certain})${more}.`
  const notes = isCut ? [`Only the first ${MOST / 1e6} MB were read; rosspin look FILE reads more.`] : []
  const drawn = chosen(result)
  results.replaceChildren(
    make("h2", { textContent: "What it looks like" }),
    ...verdicts.map(card),
    ...list([...notes, ...result.notes]),
    ...(drawn.length ? pictures(drawn, series.length, seconds) : []),
    ...(series.length ? [make("h2", { textContent: "What repeats" }), table(series)] : []),
    make("h2", { textContent: "Take it with you" }),
    sharing(),
    ...(result.files.length ? testing(result.files) : []),
  )
  results.hidden = false
}

/** @param {string[]} sentences */
function list(sentences) {
  const items = sentences.map((textContent) => make("li", { textContent }))
  return items.length ? [make("ul", {}, ...items)] : []
}

/** @param {import("./protocol.js").Fault} verdict */
function card({ title, certain, evidence, page }) {
  const link = make("a", { href: new URL(page, root).href, textContent: `What explains it: ${title}` })
  const head = make("p", {}, make("strong", { textContent: title }), ` (${certain})`)
  return make("div", { className: "look-verdict" }, head, ...list(evidence), make("p", {}, link))
}

/**
 * How late the series were all along, and a timeline of a part.
 *
 * @param {import("./protocol.js").Series[]} rows
 * @param {number} count of all series
 * @param {number} seconds
 */
function pictures(rows, count, seconds) {
  const [first, span] = part(rows, seconds)
  const most = innerWidth < 600 ? 22 : 60 // characters of a name
  const regular = rows.filter(({ period }) => period)
  const strips = regular.map((series) => strip(series, rows.indexOf(series), seconds, most))
  const axis = drawTimeline([], { first: 0, span: seconds || 1, kinds: 1, title: "time (s)" }, "")
  axis.setAttribute("aria-hidden", "true")
  const others = count > rows.length ? ` The table has all ${count} series.` : ""
  const textContent =
    "How late each came, by the grid that fits best; strokes at the foot: missing. The box is the part that the " +
    `timeline shows.${others}`
  const late = make("figure", { className: "rosspin-plot" })
  late.append(...strips.map(({ element }) => element), axis, make("figcaption", { textContent }))

  const stage = make("div")
  const slider = make("input", { type: "range", min: "0", max: `${Math.max(0, seconds - span)}`, step: "any" })
  const value = make("output")
  const paint = () => {
    const from = slider.valueAsNumber
    const found = rowsIn(rows, from, span, most)
    const scale = { first: from, span, kinds: 3, title: "time (s); line: expected, mark: came, cross: missing" }
    const reach = `${from.toFixed(2)} s to ${(from + span).toFixed(2)} s`
    stage.replaceChildren(drawTimeline(found, scale, `Timeline from ${reach}. ${describe(found)}`))
    value.textContent = slider.ariaValueText = reach
    for (const { box } of strips) box.setAttribute("x", `${(from / (seconds || 1)) * WIDTH}`)
  }
  for (const { box } of strips) box.setAttribute("width", `${(span / (seconds || 1)) * WIDTH}`)
  slider.value = `${first}` // once it has its bounds
  slider.addEventListener("input", paint)
  slider.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }
    const by = steps[/** @type {keyof typeof steps} */ (event.key)]
    if (!by) return
    event.preventDefault()
    slider.value = `${slider.valueAsNumber + (by * span) / 4}`
    paint()
  })
  paint()
  const label = make("label", { className: "look-from" }, "Show the part from ", slider, " ", value)
  const heading = make("h2", { textContent: "When it came" })
  const timeline = make("figure", { className: "rosspin-plot" }, stage)
  return [heading, ...(strips.length ? [late] : []), ...(span < seconds ? [label] : []), timeline]
}

/**
 * How late one series was.
 *
 * @param {import("./protocol.js").Series} series
 * @param {number} row
 * @param {number} seconds
 * @param {number} most
 */
function strip(series, row, seconds, most) {
  const { path, lost, zero, low, high } = dots(series, seconds)
  const colour = COLOURS[row % COLOURS.length]
  const line = { fill: "none", "vector-effect": "non-scaling-stroke" }
  const box = draw("rect", { y: 0, height: HEIGHT, fill: "currentColor", "fill-opacity": 0.12 })
  const reach = `${say(low)} to ${say(high)}`
  const missing = series.lost ? `; ${series.lost} missing` : ""
  const place = { x: percent(100 * MARGIN), y: 16, width: percent(100 - 200 * MARGIN), height: 60 }
  const picture = draw(
    "svg",
    { ...place, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", overflow: "visible" },
    box,
    draw("path", { ...line, d: `M0 ${zero}h${WIDTH}`, stroke: "currentColor", "stroke-opacity": 0.55 }),
    draw("path", { ...line, d: path, stroke: colour, "stroke-width": 4, "stroke-linecap": "round" }),
    draw("path", { ...line, d: lost, stroke: "currentColor", "stroke-width": 1.5 }),
  )
  const words = { y: 10, fill: "currentColor" }
  const label = `Lateness of ${nameOf(series)}: ${reach}${missing}.`
  const element = draw(
    "svg",
    { width: "100%", height: 84, role: "img", "aria-label": label, "font-size": 13, fill: "currentColor" },
    draw("text", { ...words, x: 2, "font-weight": 700 }, nameOf(series, most)),
    draw("text", { ...words, x: "100%", dx: -2, "text-anchor": "end" }, reach),
    picture,
  )
  return { element, box }
}

/** @param {import("./protocol.js").Series[]} rows */
function table(rows) {
  const heads = ["Line", "Entries", "Rate", "Period", "Drift", "Late, 98%", "Missing"]
  const head = make("tr", {}, ...heads.map((textContent) => make("th", { scope: "col", textContent })))
  const body = rows.map((series) => {
    const { count, period, usual, lost } = series
    const numbers = period ? [say(period), driftOf(series), say(usual), `${lost}`] : ["", "", "", ""]
    const cells = [`${count}`, rateOf(series), ...numbers].map((textContent) => make("td", { textContent }))
    return make("tr", {}, make("th", { scope: "row", textContent: nameOf(series) }), ...cells)
  })
  const element = make("table", { className: "table" }, make("thead", {}, head), make("tbody", {}, ...body))
  return make("div", { className: "look-scroll", role: "region", ariaLabel: "What repeats", tabIndex: 0 }, element)
}

// --- what can be taken away ---

/**
 * A line of buttons, and what was done.
 *
 * @param {[name: string, act: (copy: (text: string, said: string) => Promise<void>) => void][]} acts
 */
function bar(acts) {
  const said = make("span", { role: "status" })
  const copied = make("textarea", { readOnly: true, hidden: true, rows: 3, ariaLabel: "To copy" })
  const copy = async (/** @type {string} */ text, /** @type {string} */ done) => {
    try {
      if (text) await navigator.clipboard.writeText(text)
      copied.hidden = true
      said.textContent = done
    } catch {
      copied.hidden = false
      copied.value = text
      copied.select()
      said.textContent = "Copy the selected text."
    }
  }
  const buttons = acts.map(([name, act]) => button(name, () => act(copy)))
  return make("div", { className: "look-bar" }, ...buttons, said, copied)
}

function sharing() {
  return bar([
    [
      "Copy a link to this",
      async (copy) => {
        if (!current) return
        try {
          if (current.isCut) throw new Error("The log was cut off, so it is too long for a link.")
          const link = new URL(location.href)
          link.hash = await pack(current.name, current.log)
          await copy(link.href, "The link is copied. The whole log is in it, and whoever has the link can read that.")
        } catch (error) {
          await copy("", /** @type {Error} */ (error).message)
        }
      },
    ],
  ])
}

/** @param {LookResult["files"]} files */
function testing(files) {
  const shown = files.flatMap(([name, text]) => [
    make("h3", { textContent: name }),
    bar([
      ["Copy", (copy) => copy(text, `${name} is copied.`)],
      ["Save", () => save(name, "text/x-python", text)],
    ]),
    make("pre", { textContent: text }),
  ])
  const how =
    "This node logs the lines as they should come, and the test checks their periods in simulated time. Save both in one " +
    "folder and run pytest there. Then put the path of your own node into the test."
  const region = make("div", { hidden: true, tabIndex: -1 }, make("p", { textContent: how }), ...shown)
  const open = button("Make it a test", () => {
    region.hidden = !region.hidden
    open.ariaExpanded = `${!region.hidden}`
    if (!region.hidden) region.focus()
  })
  open.ariaExpanded = "false"
  return [make("div", { className: "look-bar" }, open), region]
}

// --- what is given ---

/**
 * @param {string} text
 * @param {() => void} act
 */
function button(text, act) {
  const element = make("button", { type: "button", textContent: text })
  element.addEventListener("click", act)
  return element
}

/** @param {FileList | File[]} files */
function open(files) {
  if (files.length > 1) return fail("Give one log at a time.")
  if (files.length) look(files[0].name, files[0])
}

function lookAtText() {
  if (!text.value.trim()) return fail("Paste a log first.")
  look("the pasted text", new Blob([text.value]))
}

/** @param {string} file */
async function tryExample(file) {
  const mine = begin()
  status.textContent = `Loading ${file}.`
  const response = await fetch(new URL(file, examples)).catch(() => null)
  if (mine !== number) return
  if (!response?.ok) return fail(`The example could not be loaded. ${IS_IT_THERE}`)
  look(file, await response.blob())
}

/** Show the log that came with the link, if there is one, or say why not. */
async function receive() {
  if (!location.hash.startsWith(SIGN)) return
  try {
    const { name, log } = await unpack(location.hash)
    text.value = new TextDecoder().decode(log)
    look(name, new Blob([log])) // reading runs nothing of it
    notice.textContent = "This log came with the link that you opened."
  } catch (error) {
    fail(/** @type {Error} */ (error).message)
  }
}

const input = make("input", { type: "file" })
input.addEventListener("change", () => {
  open([...(input.files ?? [])])
  input.value = "" // the same file can be chosen again
})
const text = make("textarea", { rows: 5, spellcheck: false, autocomplete: "off" })
const pasted = make("label", {}, "Or paste it here:", text)
const drop = make("div", { className: "look-drop" })
drop.append(
  make("label", {}, "Drop a log anywhere on this page, or choose a file: ", input),
  pasted,
  button("Look at this text", lookAtText),
)
const tries = Object.entries(EXAMPLES).map(([name, file]) => button(name, () => tryExample(file)))
const status = make("p", { role: "status" })
const problem = make("p", { role: "alert", className: "look-problem" })
const notice = make("p")
const results = make("div", { hidden: true, className: "look-results" })

/** Why no log can be read here, in a sentence; "" if it can. */
const missing = notHere("read a log") || (HAS_JSPI ? "" : `This browser cannot read a log here: ${LACKS_JSPI}`)

const place = find(".rosspin-look")
if (missing) {
  place.replaceChildren(make("p", { textContent: missing }))
} else {
  const bars = make("div", { className: "look-bar" }, "Or try an example: ", ...tries)
  place.replaceChildren(drop, bars, notice, status, problem, results)
  place.addEventListener("focusin", () => warmUp(base, false, ""), { once: true })
  text.addEventListener("paste", () => setTimeout(lookAtText)) // when it is there
  for (const kind of /** @type {const} */ (["dragenter", "dragover", "dragleave", "drop"])) {
    addEventListener(kind, (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return
      event.preventDefault() // the browser would leave the page to show the file
      drop.classList.toggle("look-over", kind === "dragenter" || kind === "dragover")
      if (kind === "drop") open(event.dataTransfer.files)
    })
  }
  addEventListener("hashchange", receive)
  receive()
}
