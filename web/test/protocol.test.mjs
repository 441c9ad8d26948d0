// What the page takes from a sandbox, whatever is said there: see protocol.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import { LONGEST, PER_SECOND, room, SHOWN } from "../src/limits.js"
import { read } from "../src/protocol.js"

const BATCH = { kind: "batch", chunks: [[false, "a\n", 0, 0]], leftOut: 0, ticks: [["timer", 1, 0.5, 0.5, 0]] }
const RUN = {
  status: 0, errors: 0, count: 1, hints: 0, ticks: [["t", 1, 0.5, 0.5, 0]], lost: [["t", 1]], chunks: [[0]], end: 1, alternative: "a", scenes: null, drive: [],
}
const SCENES = {
  threads: ["MainThread"],
  groups: ["Default group"],
  callbacks: [["slow", 0]],
  steps: [[0.5, "said", [0], [[0, -1, 3]], ["runs"]]],
  rings: [{ links: [["slow", "waits"]], to: 0 }],
}
const VERDICT = { verdict: "solved", solved: true, status: "right", console: "", said: "", why: "", hint: "", off: null, drive: [] }
const FAULT = { title: "Late", certain: "sure", evidence: ["It is."], page: "docs/a-b.html#c-d", series: ["a: #"] }
const SERIES = {
  name: "a: #", part: 0, count: 2, period: 0.1, chosen: 0.1, drift: 0, usual: 0.001, lost: 1,
  times: [0, 0.2], late: [0, 0.001], missing: [0.1],
}
const LOOK = {
  problem: "", kind: "console", entries: 2, seconds: 0.2, notes: [], verdicts: [FAULT], series: [SERIES], files: [["a.py", ""]],
}
const end = (result) => ({ kind: "end", result })

const RIGHT = [
  [null, { kind: "ready" }],
  [null, { kind: "need", name: "rosspin.zip" }],
  [null, { kind: "failed", reason: "why" }],
  ["run", BATCH],
  ["run", end(RUN)],
  ["run", end({ ...RUN, scenes: SCENES })],
  ["trace", end({ trace: "{}" })],
  ["judge", end(VERDICT)],
  ["look", end(LOOK)],
  ["look", end({ ...LOOK, series: [{ ...SERIES, period: 0, late: [] }], verdicts: [{ ...FAULT, page: "notebooks/drift.html" }] })],
  ["judge", end({ ...VERDICT, verdict: "to read", solved: false })],
  ["pin", end({ test: "def test_node(): ..." })],
]
for (const [job, message] of RIGHT) {
  test(`is read: ${message.kind} of ${job}`, () => {
    assert.deepEqual(read(JSON.stringify(message), job), message)
    assert.deepEqual(read(JSON.stringify({ ...message, more: 1, __proto__: { kind: "x" } }), job), message)
  })
}

test("a run that went wrong says no more than its status", () => {
  const { result } = read('{"kind": "end", "result": {"status": 1}}', "run")
  assert.deepEqual(result, { status: 1, errors: 0, count: 0, hints: 0, ticks: [], lost: [], chunks: [], end: 0, alternative: "", scenes: null, drive: [] })
})

test("a reason is short", () => {
  assert.equal(read(JSON.stringify({ kind: "failed", reason: "x".repeat(5000) }), "run").reason.length, 1000)
})

const WRONG = [
  ...[
    { problem: "both" },
    { verdicts: [] },
    { verdicts: null },
    { notes: [5] },
    { files: [["a.py"]] },
    { series: [{ ...SERIES, late: [0] }] },
    { series: [{ ...SERIES, times: ["0", "1"] }] },
    ...["https://example.org/a.html", "docs/../../a.html", "javascript:alert(1)", "//docs/a.html", "docs/a.html?b"].map(
      (page) => ({ verdicts: [{ ...FAULT, page }] }),
    ),
  ].map((odd) => ["look", JSON.stringify(end({ ...LOOK, ...odd }))]),
  ["run", "", "no JSON"],
  ["run", "null"],
  ["run", "[]"],
  ["run", '"ready"'],
  ["run", "{}"],
  ["run", '{"kind": "toString"}'],
  ["run", '{"kind": "__proto__"}'],
  ["run", '{"kind": "constructor", "result": {}}'],
  ["run", '{"kind": "batch"}'],
  ["run", JSON.stringify({ ...BATCH, chunks: [[false, 5, 0, 0]] })],
  ["run", JSON.stringify({ ...BATCH, chunks: [[false, "a", 0]] })],
  ["run", JSON.stringify({ ...BATCH, leftOut: "1" })],
  ["run", JSON.stringify({ ...BATCH, ticks: [["timer", 1, 0.5, "0.5", 0]] })],
  ["run", JSON.stringify({ ...BATCH, ticks: [["timer", 1, 0.5]] })],
  ["run", JSON.stringify({ kind: "need" })],
  ["run", JSON.stringify({ kind: "failed", reason: { toString: 1 } })],
  ["run", JSON.stringify(end())],
  ["run", JSON.stringify(end({}))],
  ["run", JSON.stringify(end({ ...RUN, status: "0" }))],
  ["run", JSON.stringify(end({ ...RUN, count: 0 }))],
  ["run", JSON.stringify(end({ ...RUN, ticks: [] }))],
  ["run", JSON.stringify(end({ ...RUN, chunks: [0] }))],
  ["pin", JSON.stringify(end({ test: 5 }))],
  ["run", JSON.stringify(end({ ...RUN, lost: [["t"]] }))],
  ...[
    { threads: [5] },
    { groups: null },
    { callbacks: [["a", 1]] },
    { callbacks: undefined },
    { steps: [[0.5, "said", [1], [[0, 0, 3]], ["runs"]]] },
    { steps: [[0.5, "said", [0], [[1, 0, 3]], ["runs"]]] },
    { steps: [[0.5, "said", [0], [[0, 1, 3]], ["runs"]]] },
    { steps: [[0.5, "said", [0], [[0, 0, 3]], ["runs", "runs"]]] },
    { steps: [[0.5, 7, [], [], []]] },
    { steps: [[0.5, "said", [], []]] },
    { rings: [{ links: [], to: -1 }] },
    { rings: [{ links: [["a", "waits"]], to: 1 }] },
    { rings: [null] },
  ].map((wrong) => ["run", JSON.stringify(end({ ...RUN, scenes: { ...SCENES, ...wrong } }))]),
  ["run", JSON.stringify(end({ ...RUN, scenes: "" }))],
  ["run", JSON.stringify(end(VERDICT))],
  ["trace", JSON.stringify(end(VERDICT))],
  ["trace", JSON.stringify(end({ trace: {} }))],
  ["judge", JSON.stringify(end({ trace: "" }))],
  ["judge", JSON.stringify(end({ ...VERDICT, solved: false }))],
  ["judge", JSON.stringify(end({ ...VERDICT, verdict: "not yet" }))],
  ["judge", JSON.stringify(end({ ...VERDICT, verdict: "no such verdict", solved: false }))],
  ["judge", JSON.stringify(end({ ...VERDICT, said: 5 }))],
  [null, JSON.stringify(end(VERDICT))],
  ["judge", JSON.stringify(end({ ...VERDICT, said: "x".repeat(LONGEST.judge.characters) }))],
  ["run", JSON.stringify({ ...end(RUN), kind: ["end"] })],
  ["run", JSON.stringify({ kind: "failed", reason: ["why"] })],
  // No number is infinite, nor so large that adding 1 to it changes nothing; no list is endless, nor a name.
  ...["1e999", "-1e999", "1e17", "-1e17", "null", '"1"', "[1]"].flatMap((number) => [
    ["run", JSON.stringify(end(RUN)).replace("[[\"t\",1,0.5", `[["t",1,${number}`)],
    ["run", JSON.stringify(end(RUN)).replace("0.5,0.5,0", `0.5,${number},0`)],
    ["run", JSON.stringify(end(RUN)).replace("0.5,0.5,0", `0.5,0.5,${number}`)],
    ["run", JSON.stringify(end(RUN)).replace('"end":1', `"end":${number}`)],
    ["run", JSON.stringify(end(RUN)).replace('"lost":[["t",1]]', `"lost":[["t",${number}]]`)],
    ["run", JSON.stringify(BATCH).replace("0.5,0.5,0", `${number},0.5,0`)],
    ["run", JSON.stringify(BATCH).replace('"leftOut":0', `"leftOut":${number}.5`)],
    ["look", JSON.stringify(end(LOOK)).replace('"seconds":0.2', `"seconds":${number}`)],
    ["look", JSON.stringify(end(LOOK)).replace('"times":[0,', `"times":[${number},`)],
    ["look", JSON.stringify(end(LOOK)).replace('"period":0.1', `"period":${number}`)],
  ]),
  ["run", JSON.stringify(end({ ...RUN, ticks: [["t", 1, 0.5, 0.5, -1]] }))],
  ["run", JSON.stringify(end({ ...RUN, count: 2e6, ticks: Array(SHOWN.ticks + 1).fill(RUN.ticks[0]) }))],
  ["run", JSON.stringify(end({ ...RUN, ticks: [...RUN.ticks, ...RUN.ticks] }))], // more than there were
  ["run", JSON.stringify(end({ ...RUN, lost: Array(SHOWN.ticks + 1).fill(["t", 1]) }))],
  ["run", JSON.stringify(end({ ...RUN, ticks: [["t".repeat(201), 1, 0.5, 0.5, 0]] }))],
  ["run", JSON.stringify(end({ ...RUN, scenes: { ...SCENES, steps: Array(501).fill(SCENES.steps[0]) } }))],
  ["run", JSON.stringify(end({ ...RUN, scenes: { ...SCENES, rings: Array(21).fill(SCENES.rings[0]) } }))],
  ["run", JSON.stringify({ ...BATCH, chunks: [["yes", "a", 0, 0]] })],
  ["run", JSON.stringify({ ...BATCH, chunks: [[true, "a", 0, 1.5]] })],
  ["run", JSON.stringify({ ...BATCH, chunks: Array(SHOWN.chunks + 1).fill(BATCH.chunks[0]) })],
  ["run", JSON.stringify({ ...BATCH, chunks: [[true, "a".repeat(SHOWN.characters + 1), 0, 0]] })],
  ["run", JSON.stringify({ ...BATCH, ticks: Array(SHOWN.ticks + 1).fill(BATCH.ticks[0]) })],
  ["look", JSON.stringify(end({ ...LOOK, series: Array(101).fill(SERIES) }))],
  ["look", JSON.stringify(end({ ...LOOK, notes: ["a".repeat(501)] }))],
]
for (const [job, text] of WRONG) {
  test(`is none: ${text.slice(0, 100)} of ${job}`, () => assert.equal(read(text, job), null))
}

test("a verdict that came with a trace is not passed on", () => {
  assert.deepEqual(read(JSON.stringify(end({ ...VERDICT, trace: "" })), "trace").result, { trace: "" })
})

test("the room that a message takes grows with its length and its values, which are not read for that", () => {
  const empty = room("[]", "run")
  assert.ok(empty > 10_000 && empty < PER_SECOND / 50) // so many may come in each second
  assert.equal(room(`[${" ".repeat(1000)}]`, "run"), empty + 1000)
  const value = room("[[]]", "run") - empty - 2
  const texts = ["[1,2 ,3 ]", "[[],{} ]", '["a",1,5]', '["[,{",{}]', '["\\",[",[]]', '["\\\\",[ ]]', "[[[    ]]]"]
  for (const text of texts) {
    const values = count(JSON.parse(text))
    const [least, most] = [values - 1, values + 1].map((many) => empty - 2 + text.length + value * (many - 1))
    assert.ok(least <= room(text, "run") && room(text, "run") <= most, text)
  }
})
const count = (part) => (typeof part === "object" ? Object.values(part).reduce((sum, one) => sum + count(one), 1) : 1)

test("no message has more room than one on its job needs", () => {
  assert.equal(room({ kind: "end" }, "run"), Infinity)
  for (const [job, { characters, values }] of Object.entries(LONGEST)) {
    const kind = job || null
    assert.ok(room(`"${"[".repeat(characters - 2)}"`, kind) <= characters + PER_SECOND, job)
    assert.equal(room(" ".repeat(characters + 1), kind), Infinity, job)
    assert.equal(room(`[${"[],".repeat(values)}0]`, kind), Infinity, job)
    assert.equal(room(`[${"0,".repeat(values)}0]`, kind), Infinity, job)
  }
})

test("what a worker may show at a time fits", () => {
  const chunk = [true, `${"x".repeat(SHOWN.characters / SHOWN.chunks - 1)}\n`, 999_999, 99]
  const tick = ["a_node.a_callback_of_it", 99_999, 1234.567891, 1234.567891, 0]
  const batch = { ...BATCH, chunks: Array(SHOWN.chunks).fill(chunk), ticks: Array(SHOWN.ticks).fill(tick) }
  assert.ok(room(JSON.stringify(batch), "run") < PER_SECOND / 2)
  assert.deepEqual(read(JSON.stringify(batch), "run"), batch)
})
