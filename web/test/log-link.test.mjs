// A log goes into a link and comes out of it as it was, byte for byte; of a broken or an endless link nothing does.

import assert from "node:assert/strict"
import { randomBytes } from "node:crypto"
import { test } from "node:test"
import { deflateRawSync } from "node:zlib"

import { pack, unpack } from "../src/log-link.js"

const bytes = (data) => new Uint8Array(data).buffer
const line = (n) => `[INFO] [170000000${n % 10}.${n}]: <b>count ${n}</b>\n`

for (const data of [Buffer.from(""), Buffer.from("a\nb\n\n"), randomBytes(1000), Buffer.from([..."x".repeat(3000)].map((_, n) => line(n)).join(""))]) {
  test(`comes out as it went in: ${data.length} bytes`, async () => {
    const fragment = await pack("my\nlög.txt", bytes(data))
    assert.match(fragment, /^#log=[\w-]+$/)
    const { name, log } = await unpack(fragment)
    assert.equal(name, "my lög.txt")
    assert.ok(Buffer.from(log).equals(data))
  })
}

for (const data of [randomBytes(100_000), Buffer.alloc(2_000_001)]) {
  test(`is too long for a link: ${data.length} bytes`, () => assert.rejects(pack("a", bytes(data)), /too long for a link/))
}

const holding = (data) => `#log=${deflateRawSync(data).toString("base64url")}`
for (const fragment of ["#log=", "#log=%%", "#log=AAAA", holding("no name"), holding("a\nb").slice(0, -3), holding(Buffer.alloc(3_000_000))]) {
  test(`cannot be read: ${fragment.slice(0, 20)}`, () => assert.rejects(unpack(fragment), /the link is broken/))
}
