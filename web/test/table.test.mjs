// Which files count, who is who, what is judged when, and what is saved: the teachers' table, without a browser.

import assert from "node:assert/strict"
import { beforeEach, test } from "node:test"

globalThis.EXERCISES = Object.fromEntries(
  Array.from({ length: 12 }, (_, n) => [`e-${String.fromCharCode(97 + n)}`, { number: n + 1, title: "" }]),
)

import { Table } from "../src/table.js"

/** A file that a student hands in. */
function handedIn(name, { as = `${name}.json`, id = "a1", student, date, answers = { "e-a": "solved" } } = {}) {
  return new File([JSON.stringify({ format: "rosspin-answers", version: 2, name, student, id, date, answers })], as)
}

/** Judges an answer by what it says: its text is the verdict; one that says "endless" is judged until it is stopped. */
function judge(exercise, text, stopped) {
  judged.push(exercise)
  const said = `said of ${exercise}`
  if (text !== "endless") return Promise.resolve({ verdict: text, said })
  return new Promise((resolve) => stopped.addEventListener("abort", () => resolve({ verdict: "stopped", said: "" })))
}

let table, judged, changes

beforeEach(() => {
  judged = []
  changes = []
  table = new Table(judge, 2, (answer) => changes.push(answer?.title ?? "rows"))
})

/** Drop files, and let all be judged that will be: what is said. */
async function drop(...files) {
  const said = await table.add(files)
  await new Promise(setImmediate)
  return said
}

const verdicts = () => table.answers.map(({ title }) => title)
const day = (number) => `2026-11-${number}T12:00:00.000Z`

// --- which files count ---

test("of one student's files the newest counts, whichever comes last", async () => {
  await drop(handedIn("Sam", { as: "b.json", date: day(21), answers: { "e-a": "solved" } }))
  const older = await drop(handedIn("Sam", { as: "a.json", date: day(20), answers: { "e-b": "solved" } }))
  assert.deepEqual(older, ["a.json is left out: Sam handed in b.json after it."])
  const newer = await drop(handedIn("Sam", { as: "c.json", date: day(22), answers: { "e-c": "not yet" } }))
  assert.deepEqual(newer, ["c.json takes the place of b.json, which Sam handed in before."])
  assert.deepEqual(verdicts(), ["Sam, exercise 3: not yet"])
})

test("the same file again takes its own place, and seconds count", async () => {
  await drop(handedIn("Sam", { date: "2026-11-21T12:00:30.000Z" }))
  assert.match((await drop(handedIn("Sam", { date: "2026-11-21T12:00:30.000Z" })))[0], /takes the place of/)
  assert.match((await drop(handedIn("Sam", { date: "2026-11-21T12:00:00.000Z" })))[0], /is left out/)
  assert.equal(table.rows.length, 1)
})

test("what waits of a file whose place was taken is not judged", async () => {
  const answers = { "e-a": "endless", "e-b": "endless", "e-c": "solved" }
  await drop(handedIn("Sam", { date: day(20), answers }))
  await drop(handedIn("Sam", { date: day(21), answers: { "e-d": "solved" } }))
  table.stop()
  await drop(handedIn("Al", { id: "b" }))
  assert.deepEqual(judged, ["e-a", "e-b", "e-a"])
})

test("students of the same name or in the same browser stay apart, and are told of", async () => {
  await drop(handedIn("Sam"), handedIn("Sam", { as: "other.json", id: "a2" }), handedIn("Al"))
  assert.deepEqual(table.rows.map(({ name, file }) => [name, file]), [["Al", "Al.json"], ["Sam", "Sam.json"], ["Sam", "other.json"]])
  const [al, sam, other] = table.rows
  assert.deepEqual([al, sam, other].map((row) => table.others(row)), [["Sam"], ["Al"], []])
  assert.deepEqual([al, sam, other].map((row) => table.namesakes(row)), [[], ["other.json"], ["Sam.json"]])
})

test("rows are in the order of their names, numbers by their size", async () => {
  await drop(...["Team 10", "team 9", "Ada", "Zoë"].map((name) => handedIn(name, { id: name })))
  assert.deepEqual(table.rows.map(({ name }) => name), ["Ada", "team 9", "Team 10", "Zoë"])
})

test("a file that is refused is said, counted and saved, and the others are read", async () => {
  const said = await drop(new File(["null"], "odd.json"), handedIn("Ada"), new File(["PK\x03\x04"], "all.zip"))
  assert.deepEqual(said, [
    "odd.json is refused: it is not a file of answers to these exercises.",
    "all.zip is refused: it is a zip archive; unpack it first.",
  ])
  assert.equal(table.said, "Done: 1 judged; 2 files refused")
  const [head, , ...refused] = table.save(String)
  const rest = Array(head.length - 4).fill("")
  assert.deepEqual(refused, [
    ["", "", "odd.json", "refused: it is not a file of answers to these exercises", ...rest],
    ["", "", "all.zip", "refused: it is a zip archive; unpack it first", ...rest],
  ])
})

test("rows are sorted by what is solved and by an exercise, and each again the other way", async () => {
  const answers = { a: { "e-a": "solved" }, b: { "e-a": "not yet", "e-b": "solved", "e-c": "solved" }, c: { "e-b": "open" } }
  await drop(...Object.entries(answers).map(([name, answers]) => handedIn(name, { id: name, answers })))
  const names = () => table.rows.map(({ name }) => name).join("")
  for (const [by, order] of [["solved", "bac"], ["solved", "cab"], ["e-a", "cba"], ["e-a", "abc"], ["name", "abc"], ["name", "cba"]]) {
    table.sort(by)
    assert.equal(names(), order, by)
  }
  await drop(handedIn("d", { id: "d" }))
  assert.equal(names(), "dcba")
})

test("what was hard: the hardest first, with what was told how often", async () => {
  table = new Table(async (exercise, text) => ({ verdict: text, said: "", hint: text === "not yet" ? `hint ${exercise}` : "" }), 2, () => {})
  const answers = [{ "e-a": "solved", "e-b": "not yet" }, { "e-a": "not yet", "e-b": "not yet" }, { "e-a": "solved", "e-b": "open", "e-c": "solved" }]
  await drop(...answers.map((answers, id) => handedIn("x", { id: `${id}`, answers })))
  assert.deepEqual(table.hard, [
    { exercise: "e-b", answered: 3, solved: 0, hints: [["hint e-b", 2]] },
    { exercise: "e-a", answered: 3, solved: 2, hints: [["hint e-a", 1]] },
  ])
})

// --- how much there is room for ---

const many = (count, answersOf) => Array.from({ length: count }, (_, n) => handedIn(`s${n}`, { id: "x", answers: answersOf(n) }))
const FULL = "this table has room for 1000 files, 10000 answers and 100 exercises; rosspin judge, on your computer, takes more"

test("there are so many rows, answers and exercises, and what is more is refused and told", async () => {
  table = new Table(() => new Promise(() => {}), 2, () => {})
  const one = await table.add(many(1003, () => ({ "e-a": "" })))
  assert.equal(table.rows.length, 1000)
  assert.deepEqual(one, ["s1000", "s1001", "s1002"].map((name) => `${name}.json is refused: ${FULL}.`))
  table = new Table(() => new Promise(() => {}), 2, () => {})
  const answers = Object.fromEntries(Array.from({ length: 50 }, (_, n) => [`a-${n}`, ""]))
  assert.equal((await table.add(many(300, () => answers))).length, 100)
  assert.equal(table.answers.length, 10_000)
  assert.deepEqual(await table.add(many(1, () => ({ "a-1": "", "a-2": "" }))), ["s0.json takes the place of s0.json, which s0 handed in before."])
  table = new Table(() => new Promise(() => {}), 2, () => {})
  assert.equal((await table.add(many(150, (n) => ({ [`a-${n}`]: "" })))).length, 50)
  assert.equal(table.exercises.length, 100)
})

test("while files are read and taken, other things happen, and it is told how far that is", async () => {
  table = new Table(() => new Promise(() => {}), 2, () => {})
  let turns = 0
  const clicks = setInterval(() => turns++)
  const told = []
  await table.add(many(900, () => ({ "e-a": "" })), (done) => told.push(done))
  clearInterval(clicks)
  assert.ok(turns >= 9, String(turns))
  assert.deepEqual([told.length, told.at(-1)], [900, 900])
})

test("of many in the same browser some are named", async () => {
  await table.add(many(9, () => ({ "e-a": "solved" })))
  assert.deepEqual(table.others(table.rows[0]), ["s1", "s2", "s3", "s4", "s5", "3 more"])
})

// --- what is judged ---

test("answers are judged one after the other in so many lanes, without their first line", async () => {
  let most = 0
  let now = 0
  const texts = []
  table = new Table(
    async (_, text) => {
      texts.push(text)
      most = Math.max(most, ++now)
      await new Promise(setImmediate)
      now--
      return { verdict: "solved", said: "" }
    },
    2,
    () => {},
  )
  await table.add([handedIn("Ada", { answers: { "e-a": "%%answer 1\nx = 1\ny", "e-b": "x", "e-c": "%%answer 9", "e-d": "" } })])
  assert.equal(table.said, "Judging the answers of 1 file")
  for (let turn = 0; turn < 10; turn++) await new Promise(setImmediate)
  assert.deepEqual(texts, ["\nx = 1\ny", "x", "\n", ""])
  assert.equal(most, 2)
  assert.equal(table.said, "Done: 4 judged")
})

test("Stop ends what is judged and what waits; a file that is dropped again is judged again", async () => {
  const answers = { "e-a": "solved", "e-b": "to read", "e-c": "endless", "e-d": "endless", "e-e": "solved", "e-f": "solved" }
  await drop(handedIn("Eve", { answers }))
  assert.equal(table.said, "Judging the answers of 1 file")
  table.stop()
  await drop()
  assert.equal(table.said, "Done: 1 judged, 1 to read, 4 stopped")
  assert.deepEqual(judged, ["e-a", "e-b", "e-c", "e-d"])
  assert.match(table.answers.at(-1).said, /^Stopped before it was judged/)
  await drop(handedIn("Eve", { answers: { "e-a": "not yet" } }))
  assert.deepEqual(verdicts(), ["Eve, exercise 1: not yet"])
  assert.equal(table.said, "Done: 1 judged")
})

test("files are dropped while others are judged, and one is slow to read", async () => {
  await drop(handedIn("Slow", { id: "s", answers: { "e-a": "endless", "e-b": "solved" } }))
  const late = handedIn("Late", { id: "c" })
  const { promise, resolve } = Promise.withResolvers()
  const { text } = late
  late.text = () => promise.then(() => text.call(late))
  const adding = drop(handedIn("Al", { id: "b" }), late)
  table.stop()
  await drop()
  resolve()
  await adding
  assert.deepEqual(verdicts(), [
    "Al, exercise 1: solved",
    "Late, exercise 1: solved",
    "Slow, exercise 1: stopped",
    "Slow, exercise 2: solved",
  ])
})

test("each change is told, and that there are other rows", async () => {
  await drop(handedIn("Ada", { answers: { "e-a": "solved", "e-b": "open" } }))
  const [first, ...others] = changes
  assert.equal(first, "rows")
  assert.deepEqual(others.toSorted(), [
    "Ada, exercise 1: being judged",
    "Ada, exercise 1: solved",
    "Ada, exercise 2: being judged",
    "Ada, exercise 2: open",
  ])
})

// --- what is saved ---

test("what is saved has a line for each student, and a column for each exercise that somebody answered", async () => {
  assert.equal(table.isSaved, true)
  await drop(
    handedIn("Ada", { student: "s1", date: day(21), answers: { "e-j": "not yet", "e-d": "solved" } }),
    handedIn("Zoë", { id: "a2", answers: { "e-a": "not judged" } }),
  )
  assert.equal(table.isSaved, false)
  const [head, ada, zoe] = table.save((name) => `exercise ${name}`)
  assert.equal(table.isSaved, true)
  const marks = ["same browser as", "same name in another browser"]
  const exercises = ["exercise e-a", "exercise e-d", "exercise e-j"]
  assert.deepEqual(head, ["name", "student ID", "file", "note", "date", ...marks, "answers", "solved", ...exercises])
  assert.match(ada[4], /^2026-11-2\d \d\d:\d\d$/)
  assert.deepEqual(ada.toSpliced(4, 1), ["Ada", "s1", "Ada.json", "", "", "", 2, 1, "", "solved", "not yet"])
  assert.deepEqual(zoe, ["Zoë", "", "Zoë.json", "", "", "", "", 1, 0, "not judged", "", ""])
})
