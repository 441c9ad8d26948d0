// What is dropped on the teachers' page: files, and those in folders, by their paths.

import assert from "node:assert/strict"
import { test } from "node:test"

import "./rules.mjs"

import { dropped } from "../src/dropped.js"

/** Folders as a browser has them; null is a file that it does not give. */
const entry = (name, inner) => ({
  name,
  isFile: typeof inner === "string" || inner === null,
  isDirectory: typeof inner !== "string" && inner !== null,
  file: (take, fail) => (inner === null ? fail() : take(new File([inner], name))),
  createReader() {
    const left = Object.entries(inner).map(([name, data]) => entry(name, data))
    return { readEntries: (take) => take(left.splice(0, 2)) }
  },
})
const drop = (name, inner) => dropped({ items: [{ webkitGetAsEntry: () => entry(name, inner) }], files: [new File(["x"], name)] })
const told = (found) => Promise.all(found.map(async ({ path, file }) => [path, file && (await file.text())]))

test("folders are gone through, whatever is in them", async () => {
  const folder = { a: { "1.json": "1", "2.json": "2", "3.json": null }, "b.json": "b" }
  const expected = [["all/a/1.json", "1"], ["all/a/2.json", "2"], ["all/a/3.json", null], ["all/b.json", "b"]]
  assert.deepEqual(await told(await drop("all", folder)), expected)
})

test("files alone have their names", async () => assert.deepEqual(await told(await drop("a.json", "x")), [["a.json", "x"]]))

test("folders end, though one more is passed on than is read", async () => {
  const many = Object.fromEntries(Array.from({ length: RULES.handIns.entries + 9 }, (_, n) => [`${n}.json`, ""]))
  assert.equal((await drop("all", many)).length, RULES.handIns.entries + 1)
})
