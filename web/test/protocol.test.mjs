// What the page takes from a sandbox, whatever is said there: see protocol.js.

import assert from "node:assert/strict"
import { test } from "node:test"

import { LONGEST, read } from "../src/protocol.js"

const BATCH = { kind: "batch", chunks: [[false, "a\n", 0, 0]], leftOut: 0, ticks: [["timer", 1, 0.5, 0.5, 0]] }
const RUN = {
  status: 0, errors: 0, count: 1, ticks: [["t", 1, 0.5, 0.5, 0]], lost: [["t", 1]], chunks: [[0]], end: 1, alternative: "a", test: "", scenes: null,
}
const SCENES = {
  threads: ["MainThread"],
  groups: ["Default group"],
  callbacks: [["slow", 0]],
  steps: [[0.5, "said", [0], [[0, -1, 3]], ["runs"]]],
  rings: [{ links: [["slow", "waits"]], to: 0 }],
}
const VERDICT = { verdict: "solved", solved: true, status: "right", console: "", said: "", why: "", hint: "" }
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
]
for (const [job, message] of RIGHT) {
  test(`is read: ${message.kind} of ${job}`, () => {
    assert.deepEqual(read(JSON.stringify(message), job), message)
    assert.deepEqual(read(JSON.stringify({ ...message, more: 1, __proto__: { kind: "x" } }), job), message)
  })
}

test("a run that went wrong says no more than its status", () => {
  const { result } = read('{"kind": "end", "result": {"status": 1}}', "run")
  assert.deepEqual(result, { status: 1, errors: 0, count: 0, ticks: [], lost: [], chunks: [], end: 0, alternative: "", test: "", scenes: null })
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
  ["run", JSON.stringify(end({ ...RUN, test: 5 }))],
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
  ["judge", JSON.stringify(end({ ...VERDICT, said: "x".repeat(LONGEST) }))],
]
for (const [job, text] of WRONG) {
  test(`is none: ${text.slice(0, 100)} of ${job}`, () => assert.equal(read(text, job), null))
}

test("a verdict that came with a trace is not passed on", () => {
  assert.deepEqual(read(JSON.stringify(end({ ...VERDICT, trace: "" })), "trace").result, { trace: "" })
})
