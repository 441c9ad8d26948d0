// A memory that was packed is what it was, wherever it is restored.

import assert from "node:assert/strict"
import { test } from "node:test"

import { filled, HEAD, pack, restore } from "../src/memory.js"

const SIZE = 5 * 2 ** 20
const JSON_AT = 240

/** Bytes drawn at random, the same ones for the same seed. */
function draw(bytes, seed) {
  for (let n = 0; n < bytes.length; n++) bytes[n] = seed = (seed * 1103515245 + 12345) & 0x7fffffff
  return bytes
}

/** A memory as it is before anything ran there. */
function fresh() {
  const bytes = new Uint8Array(SIZE)
  draw(bytes.subarray(1000, 900_000), 1)
  return bytes
}

/** The same after something ran there: what was filled is changed, made zero or left; some of the rest is filled. */
function used() {
  const bytes = fresh()
  draw(bytes.subarray(5000, 5010), 2)
  bytes.fill(0, 300_000, 400_000)
  draw(bytes.subarray(2_000_001, 2_500_000), 3)
  bytes[SIZE - 1] = 1
  return bytes
}

/** What Pyodide says of a memory, followed by it. */
function snapshot(memory) {
  const bytes = new Uint8Array(JSON_AT + memory.length)
  draw(bytes.subarray(0, JSON_AT), 4)
  new Uint32Array(bytes.buffer)[1] = JSON_AT
  bytes.set(memory, JSON_AT)
  return bytes
}

const file = pack(snapshot(used()), filled(fresh()))
const buffer = file.buffer.slice(file.byteOffset, file.byteOffset + file.length)

test("only what is not filled anyway is in the file", () => assert.ok(file.length < 620_000, file.length))

for (const [name, written] of [["untouched", fresh()], ["written to", draw(fresh(), 5)], ["empty", new Uint8Array(SIZE)]]) {
  test(`into a memory that is ${name}`, () => {
    const head = new Uint8Array(HEAD)
    restore(buffer, head, written, filled(fresh()))
    assert.equal(Buffer.compare(written, used()), 0)
    const known = snapshot(used()).subarray(0, JSON_AT)
    assert.deepEqual(head.subarray(8, JSON_AT), known.subarray(8))
    assert.equal(new Uint32Array(head.buffer)[1], HEAD) // no memory follows it
  })
}

test("what Pyodide says must have room", () => {
  const bytes = new Uint8Array(HEAD + 16)
  new Uint32Array(bytes.buffer)[1] = HEAD + 16
  assert.throws(() => pack(bytes, new Uint8Array()), RangeError)
})
