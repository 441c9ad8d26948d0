// A listing goes into a link and comes out of it as it was; of a broken or an endless link nothing does.

import assert from "node:assert/strict"
import { test } from "node:test"
import { deflateRawSync } from "node:zlib"

import { pack, unpack } from "../src/link.js"

const LISTING = { cell: 3, text: "print(1)", seconds: 2, args: "" }

/** A fragment that holds these bytes. */
const holding = (bytes) => `#code=${deflateRawSync(bytes).toString("base64url")}`
const link = (changed) => holding(JSON.stringify({ ...LISTING, ...changed }))

for (const text of ["", "print('<b>ä</b>')\n", "\u202e\u{1f600}", "x = 1\n".repeat(10_000)]) {
  test(`comes out as it went in: ${JSON.stringify(text.slice(0, 30))}`, async () => {
    const listing = { ...LISTING, text, args: "_word:='two words'", seconds: 0.5 }
    const fragment = await pack(listing)
    assert.match(fragment, /^#code=[\w-]+$/)
    assert.deepEqual(await unpack(fragment), listing)
    assert.deepEqual(await unpack(link({ ...listing, more: 1 })), listing)
  })
}

test("a listing that is too long goes into no link", async () => {
  await assert.rejects(pack({ ...LISTING, text: "x".repeat(100_001) }), { said: "the listing is too long for a link" })
})

const BROKEN = {
  "nothing": "#code=",
  "no base 64": "#code=%%%",
  "nothing packed": "#code=AAAA",
  "cut off": link().slice(0, -6),
  "a list": holding("[]"),
  "null": holding("null"),
  "no JSON": holding("{"),
  "no text": link({ text: 5 }),
  "text for a number": link({ seconds: "2" }),
  "less than no time": link({ seconds: -1 }),
  "more than an hour": link({ seconds: 3601 }),
  "no number": link({ seconds: null }),
  "arguments in a list": link({ args: ["a"] }),
  "text for a place": link({ cell: "0" }),
  "half a place": link({ cell: 0.5 }),
}
for (const [name, fragment] of Object.entries(BROKEN)) {
  test(`cannot be read: ${name}`, () => assert.rejects(unpack(fragment), /^Error: The code in this link cannot be read/))
}

const LONG = {
  "unpacked": link({ text: "x".repeat(1_000_000) }),
  "packed": `#code=${"A".repeat(1_000_000)}`,
  "without end": holding(Buffer.alloc(50_000_000)),
}
for (const [name, fragment] of Object.entries(LONG)) {
  test(`is too long: ${name}`, () => assert.rejects(unpack(fragment), /^Error: The code in this link is too long/))
}
