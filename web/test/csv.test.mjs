// No cell of the teachers' table is a formula, whichever spreadsheet opens it.

import assert from "node:assert/strict"
import { test } from "node:test"

import { csv } from "../src/csv.js"

/** What a field becomes, read as CSV. */
function field(text) {
  const written = csv([[text]])
  assert.match(written, /^\ufeff".*"\r\n$/su)
  return written.slice(2, -3).replaceAll('""', '"')
}

/** The fields of a line, as a spreadsheet reads it that separates by this character. */
function cells(line, separator) {
  const found = [""]
  let quoted = false
  for (const [index, character] of [...line].entries()) {
    if (character === '"' && (quoted || !found.at(-1) || [...line][index - 1] === '"')) quoted = !quoted
    else if (character === separator && !quoted) found.push("")
    else found[found.length - 1] += character
  }
  return found
}

const PLAIN = [
  "",
  "Ada",
  "Zoë Müller",
  "O'Neill",
  "Anna-Lena Groß-Gerau",
  "Nguyễn Thị Minh",
  "李雷",
  "علی‌رضا",
  'Zoë "Z", jr.',
  "Sam, Al",
  "rosspin-answers-Ada (2).json",
  "1+1=2.json",
  "a@b.org.json",
  "a; b.json",
  "C++",
  "5",
  "2026-11-21 22:05",
  "exercise 1: The first ticks",
  "refused: it is 2.0 MB; the limit is 1 MB",
]
for (const text of PLAIN) {
  test(`stays as it is: ${text}`, () => assert.equal(field(text), text))
}

const FORMULAS = [
  // each sign, also full-width, small, and the one of mathematics
  ["=1+1", "'=1+1"],
  ["+1", "'+1"],
  ["-1", "'-1"],
  ["@SUM(A1)", "'@SUM(A1)"],
  ["=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"],
  ["＝1", "'＝1"],
  ["＋1", "'＋1"],
  ["－1", "'－1"],
  ["＠A", "'＠A"],
  ["−1", "'−1"],
  ["﹦1", "'﹦1"],
  // after what is white or not seen
  [" =1", " '=1"],
  ["\u00a0=1", "\u00a0'=1"],
  ["\u3000＝1", "\u3000'＝1"],
  ["\ufeff=1", "\ufeff'=1"],
  ["\u200b=1", "\u200b'=1"],
  ["\u2060\u200d=1", "\u2060\u200d'=1"],
  ["\u202e=1", "\u202e'=1"],
  ["\u00ad=1", "\u00ad'=1"],
  ["\u034f=1", "\u034f'=1"],
  ["\u3164=1", "\u3164'=1"],
  ["\ufe0f=1", "\ufe0f'=1"],
  ["\t=1", " '=1"],
  ["\r=1", " '=1"],
  ["\n=1", " '=1"],
  ["\r\n\0=1", " '=1"],
  ["\u0085=1", " '=1"],
  ["\u2028=1", " '=1"],
  // in the middle, where cells may be separated
  ["Ada;=1", "Ada;'=1"],
  ["Ada; =1", "Ada; '=1"],
  ["Ada;;＝1;-2", "Ada;;'＝1;'-2"],
  ["Ada,=1", "Ada,'=1"],
  ["Ada|@x", "Ada|'@x"],
  ["Ada；＝1", "Ada；'＝1"],
  ["Ada;\ufeff=1", "Ada;\ufeff'=1"],
  ["Ada\t=1", "Ada =1"],
  ["Ada\n=1", "Ada =1"],
  ["Ada;\t=1", "Ada; '=1"],
  // with quotes that end the cell's own
  ['"=1', `"'=1`],
  ['Ada";"=1', `Ada";"'=1`],
  ['Ada;""=1', `Ada;""'=1`],
]
for (const [text, expected] of FORMULAS) {
  test(`is no formula: ${JSON.stringify(text)}`, () => {
    assert.equal(field(text), expected)
    const [line] = csv([["Ada", text, "solved"]]).slice(1).split("\r\n")
    for (const separator of [",", ";", "\t", "|"]) {
      for (const cell of cells(line, separator)) {
        assert.doesNotMatch(cell.replace(/^[\s"\p{C}\p{DI}]+/u, "").normalize("NFKC"), /^[=+\-@\u2212]/u)
      }
    }
  })
}

test("rows are lines, whatever is in their cells", () => {
  const written = csv([["name", "file"], ["a\r\nb", "c\u2029d"]])
  assert.equal(written, '\ufeff"name","file"\r\n"a b","c d"\r\n')
})
