// The file of answers: what is written is read, and what is no such file is refused in words.

import assert from "node:assert/strict"
import { test } from "node:test"

import { MOST, read, write } from "../src/answers.js"

const MADE = { format: "rosspin-answers", version: 1, name: "Ada", id: "a1", answers: { 1: "x" } }
const file = (text) => new File([text], "a.json")
const holding = (changed) => file(JSON.stringify({ ...MADE, ...changed }))

test("what is written is read", async () => {
  const found = await read(file(write("Ada <Lovelace>/2", "a1", { 10: "%%answer 10\nä", 2: "" })))
  assert.ok(Math.abs(found.date - new Date()) < 60_000 * 60)
  assert.deepEqual({ ...found, date: null }, {
    file: "a.json",
    name: "Ada <Lovelace>/2",
    id: "a1",
    date: null,
    answers: [[2, ""], [10, "%%answer 10\nä"]],
  })
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
const NO_ANSWER = "one of its answers is not a text with the number of an exercise"
const REFUSED = [
  [file("x".repeat(3_000_000)), "it is 3.0 MB; the limit is 1 MB"],
  [file("PK\x03\x04" + "x".repeat(3_000_000)), "it is a zip archive; unpack it first"],
  [file(""), NOT_JSON],
  [file("%%answer 1\n"), NOT_JSON],
  [file("[".repeat(900_000)), NOT_JSON],
  [file("null"), NOT_THESE],
  [file("[]"), NOT_THESE],
  [holding({ format: "other" }), NOT_THESE],
  [holding({ version: 2 }), "another version of this site wrote it"],
  [holding({ name: null }), LACKING],
  [holding({ id: 5 }), LACKING],
  [holding({ answers: null }), LACKING],
  [holding({ answers: { one: "x" } }), NO_ANSWER],
  [file(JSON.stringify(MADE).replace('"1"', '"__proto__"')), NO_ANSWER],
  [holding({ answers: { 0: "x" } }), NO_ANSWER],
  [holding({ answers: { 1000: "x" } }), NO_ANSWER],
  [holding({ answers: { 1.5: "x" } }), NO_ANSWER],
  [holding({ answers: { 1: ["x"] } }), NO_ANSWER],
  [holding({ answers: Object.fromEntries(Array.from({ length: 101 }, (_, n) => [n + 1, ""])) }), "it has 101 answers, and at most 100 are read"],
]
for (const [number, [odd, said]] of REFUSED.entries()) {
  test(`is refused: ${said} (${number})`, () => assert.rejects(read(odd), new Error(said)))
}

test("a file that cannot be read is refused", () => {
  const gone = { slice: () => ({ text: () => Promise.reject(new DOMException("", "NotFoundError")) }) }
  return assert.rejects(read(gone), new Error("it cannot be read"))
})
