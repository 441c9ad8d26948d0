// What is judged when, and how rows are sorted: the teachers' table, without a browser. What Python says is in tests/hand_ins.

import assert from "node:assert/strict"
import { beforeEach, test } from "node:test"

import "./rules.mjs"

import { Table } from "../src/table.js"

globalThis.EXERCISES = Object.fromEntries(
  Array.from({ length: 12 }, (_, n) => [`e-${String.fromCharCode(97 + n)}`, { number: n + 1, title: "" }]),
)

/** In place of Python: hand-ins as they would be read, and the texts of their answers. */
let given, told
const handedIn = (name, { number = given.length, late = false, note = "", answers = { "e-a": "solved" } } = {}) =>
  given.push({ number, name, student: "", file: `${name}.json`, date: "", note, late, others: [], namesakes: [], texts: answers })
async function ask(job) {
  if (job.kind === "answer") return { text: given.find(({ number }) => number === job.number).texts[job.exercise], why: "" }
  if (job.kind === "report") return (told = job.verdicts) && { csv: "", hard: [] }
  const exercises = [...new Set(given.flatMap(({ texts }) => Object.keys(texts)))].sort()
  const rows = given.map(({ texts, ...row }) => ({ ...row, answers: Object.keys(texts).map((name) => exercises.indexOf(name)) }))
  return { exercises, rows, problems: [], unlisted: 0, refused: job.files.length }
}

/** Judges an answer by what it says: its text is the verdict; one that says "endless" is judged until it is stopped. */
function judge(exercise, text, stopped) {
  judged.push(exercise)
  const said = `said of ${exercise}`
  if (text !== "endless") return Promise.resolve({ verdict: text, said, why: text === "not yet" ? "why" : "" })
  return new Promise((resolve) => stopped.addEventListener("abort", () => resolve({ verdict: "stopped", said: "" })))
}

let table, judged, changes

beforeEach(() => {
  given = []
  judged = []
  changes = []
  table = new Table(ask, judge, 2, (answer) => changes.push(answer?.title ?? "rows"))
})

/** Drop files, and let all be judged that will be. */
async function drop(...files) {
  await table.add(files)
  for (let turn = 0; turn < 10; turn++) await new Promise(setImmediate)
}

const verdicts = () => table.answers.map(({ title }) => title)
const names = () => table.rows.map(({ name }) => name).join("")

// --- which rows there are ---

test("rows that are new are judged, and others keep what was said of them", async () => {
  handedIn("a", { answers: { "e-a": "solved" } })
  await drop()
  handedIn("b", { answers: { "e-b": "not yet" } })
  await drop()
  assert.deepEqual(judged, ["e-a", "e-b"])
  assert.deepEqual(verdicts(), ["a, exercise 1: solved", "b, exercise 2: not yet"])
  given[0] = { ...given[0], number: 7, texts: { "e-c": "open" } } // another file has its place
  await drop()
  assert.deepEqual(verdicts(), ["a, exercise 3: open", "b, exercise 2: not yet"])
})

test("what waits of a row that is gone is not judged", async () => {
  handedIn("a", { answers: { "e-a": "endless", "e-b": "endless", "e-c": "solved" } })
  await drop()
  given = []
  handedIn("b", { number: 1, answers: { "e-d": "solved" } })
  await drop()
  table.stop()
  await drop()
  assert.deepEqual(judged, ["e-a", "e-b"])
})

test("rows are sorted by what is solved and by an exercise, and each again the other way", async () => {
  const answers = { a: { "e-a": "solved" }, b: { "e-a": "not yet", "e-b": "solved", "e-c": "solved" }, c: { "e-b": "open" } }
  for (const name in answers) handedIn(name, { answers: answers[name] })
  await drop()
  for (const [by, order] of [["solved", "bac"], ["solved", "cab"], ["e-a", "cba"], ["e-a", "abc"], ["name", "abc"], ["name", "cba"]]) {
    table.sort(by)
    assert.equal(names(), order, by)
  }
  handedIn("d")
  await drop()
  assert.equal(names(), "dcba")
})

test("a row says that it came late, and why it has no answer", async () => {
  handedIn("a", { late: true, note: "refused: it is no file of answers", answers: {} })
  await drop()
  assert.equal(table.rows[0].note, "late; refused: it is no file of answers")
})

// --- what is judged ---

test("answers are judged one after the other, so many at a time", async () => {
  let [most, now] = [0, 0]
  const texts = []
  const counted = async (_, text) => {
    texts.push(text)
    most = Math.max(most, ++now)
    await new Promise(setImmediate)
    now--
    return { verdict: "solved", said: "" }
  }
  table = new Table(ask, counted, 2, () => {})
  handedIn("Ada", { answers: { "e-a": "%%answer e-a\nx = 1", "e-b": "x", "e-c": "", "e-d": "y" } })
  await table.add([])
  assert.equal(table.said, "Judging the answers of 1 file")
  await drop()
  assert.deepEqual(texts, ["%%answer e-a\nx = 1", "x", "", "y"])
  assert.equal(most, 2)
  assert.equal(table.said, "Done: 4 judged")
})

test("an answer that cannot be had, or is too long, is not judged, and it is said why", async () => {
  const odd = (job) => (job.kind !== "answer" ? ask(job) : job.exercise === "e-a" ? Promise.reject(new Error("gone")) : { text: "", why: "long" })
  table = new Table(odd, judge, 2, () => {})
  handedIn("a", { answers: { "e-a": "solved", "e-b": "solved" } })
  await drop()
  assert.deepEqual(table.answers.map(({ verdict, said }) => [verdict, said]), [["not judged", "Error: gone"], ["not judged", "long"]])
  assert.equal(table.said, "Done: 0 judged, 2 not judged")
})

test("Stop ends what is judged and what waits; files that were refused are counted", async () => {
  handedIn("Eve", { answers: { "e-a": "solved", "e-b": "to read", "e-c": "endless", "e-d": "endless", "e-e": "solved", "e-f": "solved" } })
  await drop()
  assert.equal(table.said, "Judging the answers of 1 file")
  table.stop()
  await drop("refused", "refused")
  assert.equal(table.said, "Done: 1 judged, 1 to read, 4 stopped; 2 files refused")
  assert.deepEqual(judged, ["e-a", "e-b", "e-c", "e-d"])
  assert.match(table.answers.at(-1).said, /^Stopped before it was judged/)
})

test("each change is told, and that there are other rows", async () => {
  handedIn("Ada", { answers: { "e-a": "solved", "e-b": "open" } })
  await drop()
  const [first, ...others] = changes
  assert.equal(first, "rows")
  assert.deepEqual(others.toSorted(), [
    "Ada, exercise 1: being judged",
    "Ada, exercise 1: solved",
    "Ada, exercise 2: being judged",
    "Ada, exercise 2: open",
  ])
})

test("what is reported are the verdicts, with the reasons, on the rows that are there", async () => {
  handedIn("a", { answers: { "e-a": "not yet", "e-b": "endless" } })
  await drop()
  await table.report()
  assert.deepEqual(told, [[0, "e-a", "not yet", "why", "", null]])
  table.stop()
  await drop()
})
