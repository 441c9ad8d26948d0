// Folders and archives, as learning platforms export them: what is in them, and what an odd one is called.

import assert from "node:assert/strict"
import { test } from "node:test"
import { crc32, deflateRawSync } from "node:zlib"

import { dropped, unpacked } from "../src/unpack.js"

const bytes = (/** @type {string | Buffer} */ data) => Buffer.from(data)

/** A zip archive; a name as bytes has no flag for UTF-8. */
function zip(name, entries, { method = 8, flags = 0, spoil = (packed) => packed } = {}) {
  const [parts, list] = [[], []]
  let at = 0
  for (const [path, data] of entries) {
    const [raw, plain] = [bytes(path), bytes(data)]
    const packed = spoil(method ? deflateRawSync(plain) : plain)
    const common = Buffer.alloc(26)
    common.writeUInt16LE(flags | (typeof path === "string" ? 0x800 : 0), 2)
    common.writeUInt16LE(method, 4)
    common.writeUInt32LE(crc32(plain), 10)
    common.writeUInt32LE(packed.length, 14)
    common.writeUInt32LE(plain.length, 18)
    common.writeUInt16LE(raw.length, 22)
    const local = Buffer.concat([bytes("PK\x03\x04"), common, raw, packed])
    const rest = Buffer.alloc(14)
    rest.writeUInt32LE(at, 10)
    list.push(Buffer.concat([bytes("PK\x01\x02"), Buffer.alloc(2), common, rest, raw]))
    parts.push(local)
    at += local.length
  }
  const directory = Buffer.concat(list)
  const end = Buffer.alloc(22)
  end.write("PK\x05\x06", "latin1")
  end.writeUInt32LE(directory.length, 12)
  end.writeUInt32LE(at, 16)
  return new File([...parts, directory, end], name)
}

const told = (files) => Promise.all(files.map(async (file) => [file.name, file.why ?? (await file.text())]))
const zipped = async (file) => bytes(await file.arrayBuffer())

test("files in archives, and in those within them, by their paths", async () => {
  const inner = await zipped(zip("", [["b.json", "2"], ["report.pdf", "x"]]))
  const all = zip("all.zip", [["Zoë_1_assignsubmission_file_/a.json", "1"], ["Ä/in.zip", inner], ["__MACOSX/._a.json", "x"], [".DS_Store", ""]])
  assert.deepEqual(await told(await unpacked([all, new File(["3"], "c.json"), new File(["x"], "odd.pdf")])), [
    ["all/Zoë_1_assignsubmission_file_/a.json", "1"],
    ["all/Ä/in/b.json", "2"],
    ["c.json", "3"],
    ["odd.pdf", "x"],
  ])
})

test("what is no hand-in is refused, but beside a student's own one", async () => {
  const alone = [["Wim_1_file_/make-it-10-hz.py", ""], ["Bo_2_file_/report.pdf", ""], ["Di_3_file_/", ""]]
  const beside = [["Ada_4_file_/a.json", "1"], ["Ada_4_file_/report.pdf", ""], ["Ada_4_file_/own.py", ""]]
  const flat = [["f/Cy_5_a.json", "2"], ["f/Ed_6_a.json", "3"], ["f/Flo_7_report.pdf", ""]]
  const names = (await unpacked([zip("z.zip", [...alone, ...beside, ...flat])])).map(({ name, why }) => [name.slice(2), Boolean(why)])
  assert.deepEqual(names, [
    ...[["Wim_1_file_/make-it-10-hz.py", true], ["Bo_2_file_/report.pdf", true]],
    ...[["Ada_4_file_/a.json", false], ["Ada_4_file_/own.py", true]],
    ...[["f/Cy_5_a.json", false], ["f/Ed_6_a.json", false], ["f/Flo_7_report.pdf", true]],
  ])
})

test("names without a code are those of macOS or of Windows, and lead nowhere", async () => {
  const names = [bytes("Müller/a.json"), Buffer.from([0x4d, 0x81, 0x2f, 0x62, ...bytes(".json")]), "../../c.json", "/d\\e.json"]
  const found = await unpacked([zip("z.zip", names.map((name) => [name, ""]))])
  assert.deepEqual(found.map(({ name }) => name), ["z/Müller/a.json", "z/Mü/b.json", "z/c.json", "z/d/e.json"])
})

test("what is stored plainly is read, too", async () => {
  assert.deepEqual(await told(await unpacked([zip("z.zip", [["a.json", "1"]], { method: 0 })])), [["z/a.json", "1"]])
})

test("of a bomb no more is unpacked than a hand-in may have", async () => {
  const [file] = await unpacked([zip("z.zip", [["a.json", Buffer.alloc(30_000_000)]])])
  assert.equal(file.size, 1_000_001)
})

const whys = (files) => files.filter(({ why }) => why === "there is too much in all").length

test("of all archives together no more is read than there is room for: files, names, bytes", async () => {
  const files = await unpacked([zip("z.zip", Array.from({ length: 3000 }, (_, n) => [`${n}.json`, "1"]))])
  assert.deepEqual([files.length, whys(files)], [2001, 1])
  const skipped = zip("z.zip", Array.from({ length: 30_000 }, (_, n) => [`.${n}/`, ""]))
  assert.deepEqual((await unpacked([skipped])).map(({ name, why }) => [name, why]), [["z.zip", "there is too much in all"]])
  const bomb = await zipped(zip("z.zip", [["a.json", Buffer.alloc(1_000_000)]]))
  const archives = zip("z.zip", Array.from({ length: 250 }, (_, n) => [`${n}.zip`, bomb]))
  const found = await unpacked([archives])
  assert.ok(whys(found) >= 50 && found.length - whys(found) <= 200, `${whys(found)} of ${found.length}`)
})

const nested = async (depth) => {
  let file = zip("z.zip", [["a.json", "1"]])
  for (; depth; depth--) file = zip("z.zip", [["z.zip", await zipped(file)]])
  return file
}
const ODD = [
  [zip("z.zip", [["a.json", "1"]], { flags: 1 }), "it is locked with a password"],
  [zip("z.zip", [["a.json", "1"]], { method: 12 }), "it is packed in a way that is not read here; unpack the archive first"],
  [zip("z.zip", [["a.json", "1"]], { spoil: () => bytes("\xff\xff") }), "it is damaged in its archive"],
  [new File(["PK\x03\x04"], "z.zip"), "it is no zip archive that can be read"],
  [new File([""], "z.zip"), "it is no zip archive that can be read"],
  [await nested(4), "it is an archive within 4 others"],
]
for (const [file, why] of ODD) {
  test(`is told: ${why}`, async () => assert.equal((await unpacked([file]))[0].why, why))
}

/** Folders as a browser has them. */
const entry = (name, inner) => ({
  name,
  isFile: typeof inner === "string",
  isDirectory: typeof inner !== "string",
  file: (/** @type {any} */ take) => take(new File([inner], name)),
  createReader() {
    const left = Object.entries(inner).map(([name, data]) => entry(name, data))
    return { readEntries: (/** @type {any} */ take) => take(left.splice(0, 2)) }
  },
})

test("folders are gone through, whatever is in them", async () => {
  const folder = { a: { "1.json": "1", "2.json": "2", "3.json": "3", "x.pdf": "" }, ".git": { "y.json": "" }, "b.json": "b" }
  const items = [{ webkitGetAsEntry: () => entry("all", folder) }]
  assert.deepEqual(await told(await dropped({ items, files: [] })), [
    ["all/a/1.json", "1"],
    ["all/a/2.json", "2"],
    ["all/a/3.json", "3"],
    ["all/a/x.pdf", "this page reads what Hand in saved, and rosspin judge node files and notebooks, too"],
    ["all/b.json", "b"],
  ])
})
