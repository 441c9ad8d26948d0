// The file of answers: what is written is read, and what is no such file is refused in words.

import assert from "node:assert/strict"
import { test } from "node:test"

import { MOST, read, write } from "../src/answers.js"

const MADE = { format: "rosspin-answers", version: 2, name: "Ada", id: "a1", answers: { "ten-hertz": "x" } }
const file = (text) => new File([text], "a.json")
const holding = (changed) => file(JSON.stringify({ ...MADE, ...changed }))

test("what is written is read", async () => {
  const found = await read(file(write("Ada <Lovelace>/2", "a1", { "ten-hertz": "%%answer ten-hertz\nä", "cpp-ticks": "" })))
  assert.ok(Math.abs(found.date - new Date()) < 60_000 * 60)
  assert.deepEqual({ ...found, date: null }, {
    file: "a.json",
    name: "Ada <Lovelace>/2",
    student: "",
    id: "a1",
    date: null,
    answers: [["ten-hertz", "%%answer ten-hertz\nä"], ["cpp-ticks", ""]],
  })
})

test("a file from before exercises had names is read, by the numbers that they had then", async () => {
  const answers = { 1: "a", 4: "%%answer 4\nb", 20: "c", 30: "d", 99: "e" }
  const names = ["first-ticks", "ten-hertz", "slow-timer", "cancel-a-goal", "99"]
  const found = await read(holding({ version: 1, answers }))
  assert.deepEqual(found.answers.map(([name]) => name), names)
  assert.deepEqual(found.answers[1], ["ten-hertz", "%%answer 4\nb"])
})

test("a student may have an ID", async () => {
  assert.equal((await read(file(write("Ada", "a1", {}, " s 1\n")))).student, "s 1")
  assert.equal((await read(holding({ student: 5 }))).student, "")
})

const NAMES = [
  ["a\n\u202eb\0 " + "c".repeat(200), `a b ${"c".repeat(MOST.name - 4)}`],
  ["  ", "(no name)"],
  ["\u200b", "(no name)"],
  ["<b>Zoë</b>", "<b>Zoë</b>"],
]
for (const [name, expected] of NAMES) {
  test(`names are one short line: ${JSON.stringify(name.slice(0, 20))}`, async () => {
    assert.equal((await read(holding({ name }))).name, expected)
  })
}

for (const date of [undefined, null, 5, "yesterday", {}]) {
  test(`a file may have no date: ${date}`, async () => assert.equal((await read(holding({ date }))).date, null))
}

const NOT_JSON = "it is not a file that Hand in saved (it is not JSON)"
const NOT_THESE = "it is not a file of answers to these exercises"
const LACKING = "its name or its answers are missing"
const NO_ANSWER = "one of its answers is not a text with the name of an exercise"
const REFUSED = [
  [file("x".repeat(3_000_000)), "it is 3.0 MB; the limit is 1 MB"],
  [file("PK\x03\x04" + "x".repeat(3_000_000)), "it is a zip archive; unpack it first"],
  [file(""), NOT_JSON],
  [file("%%answer 1\n"), NOT_JSON],
  [file("[".repeat(9000)), NOT_JSON],
  [file("[".repeat(900_000)), NOT_THESE], // which is seen before it is read
  [file(`[${"[],".repeat(300_000)}0]`), NOT_THESE],
  [file("null"), NOT_THESE],
  [file("[]"), NOT_THESE],
  [holding({ format: "other" }), NOT_THESE],
  [holding({ version: 3 }), "another version of this site wrote it"],
  [holding({ version: "constructor" }), "another version of this site wrote it"],
  [holding({ version: 1, answers: { "04": "x" } }), NO_ANSWER],
  [holding({ name: null }), LACKING],
  [holding({ id: 5 }), LACKING],
  [holding({ answers: null }), LACKING],
  [holding({ answers: { "One two": "x" } }), NO_ANSWER],
  [file(JSON.stringify(MADE).replace('"ten-hertz"', '"__proto__"')), NO_ANSWER],
  [holding({ answers: { "a--b": "x" } }), NO_ANSWER],
  [holding({ answers: { ["a".repeat(101)]: "x" } }), NO_ANSWER],
  [holding({ version: 1, answers: { 1.5: "x" } }), NO_ANSWER],
  [holding({ answers: { a: ["x"] } }), NO_ANSWER],
  [holding({ answers: Object.fromEntries(Array.from({ length: 101 }, (_, n) => [n + 1, ""])) }), "it has 101 answers, and at most 100 are read"],
]
for (const [number, [odd, said]] of REFUSED.entries()) {
  test(`is refused: ${said} (${number})`, () => assert.rejects(read(odd), new Error(said)))
}

test("a file that cannot be read is refused", () => {
  const gone = { slice: () => ({ text: () => Promise.reject(new DOMException("", "NotFoundError")) }) }
  return assert.rejects(read(gone), new Error("it cannot be read"))
})
