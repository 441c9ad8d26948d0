// What the store promises, without a browser: two pages share a storage, as two tabs do.

import assert from "node:assert/strict"
import { beforeEach, test } from "node:test"

import "./rules.mjs"

import { Store } from "../src/store.js"

/** As localStorage: keys are its own properties. It can be full, or not be there. */
class Storage {
  getItem(key) {
    return Object.hasOwn(this, key) ? this[key] : null
  }
  setItem(key, value) {
    if (state.full && value.length > state.full) throw new DOMException("", "QuotaExceededError")
    this[key] = value
  }
  removeItem(key) {
    delete this[key]
  }
}

let storage, state, pages, clock

beforeEach(() => {
  storage = new Storage()
  state = { full: 0, gone: false }
  pages = 0
  clock = 1000
})

/** A tab in which a page of the site is open. */
function open(root = "/") {
  const found = () => {
    if (state.gone) throw new DOMException("", "SecurityError")
    return storage
  }
  return new Store(root, { storage: found, now: () => ++clock, page: `page${++pages}` })
}

/** Each text that Restore earlier version shows, up to the one that it began with, with which it ends. */
function round(answer) {
  const [texts, { text }] = [[], answer]
  do {
    answer.bringBack()
    texts.push(answer.text)
  } while (answer.text !== text)
  return texts
}

const handedIn = (store) => Object.fromEntries(store.texts())

/** Type a text, one character after the other. */
function type(answer, text) {
  for (let end = 1; end <= text.length; end++) answer.write(text.slice(0, end))
}

// --- one tab ---

test("an answer is there after a reload, whichever page asks, and only it is handed in", () => {
  const store = open()
  type(store.of("ten-hertz"), "mine")
  store.of("fire-once")
  const later = open()
  assert.equal(later.of("ten-hertz").text, "mine")
  assert.equal(later.of("ten-hertz").said, "as you edited it")
  assert.equal(later.of("fire-once").text, null)
  assert.equal(later.of("fire-once").said, "")
  assert.deepEqual(handedIn(open()), { "ten-hertz": "mine" })
})

test("typing makes no versions, a visit makes one", () => {
  type(open().of("ten-hertz"), "first")
  const answer = open().of("ten-hertz")
  assert.equal(answer.hasEarlier, false)
  type(answer, "second")
  assert.deepEqual(round(answer), ["first", "second"])
  type(open().of("ten-hertz"), "third")
  assert.deepEqual(round(open().of("ten-hertz")), ["second", "first", "third"])
})

test("Reset can be taken back, also after a reload", () => {
  const answer = open().of("ten-hertz")
  type(answer, "mine")
  answer.write(null)
  assert.equal(answer.text, null)
  assert.deepEqual(handedIn(open()), {})
  const later = open().of("ten-hertz")
  later.bringBack()
  assert.equal(later.text, "mine")
  assert.equal(open().of("ten-hertz").text, "mine")
})

test("what was typed back to an earlier text leaves that one alone", () => {
  open().of("ten-hertz").write("mine")
  const answer = open().of("ten-hertz")
  for (const text of ["mine!", "mine", "mine?"]) answer.write(text)
  assert.deepEqual(round(answer), ["mine", "mine?"])
})

test("not all versions are kept, but the newest that solved the exercise is", () => {
  const first = open().of("ten-hertz")
  first.write("solution")
  first.solve("solution")
  for (let visit = 0; visit < 20; visit++) open().of("ten-hertz").write(`attempt ${visit}`)
  const texts = round(open().of("ten-hertz"))
  assert.equal(texts.length, 7)
  assert.ok(texts.includes("solution"))
  assert.equal(texts.at(-1), "attempt 19")
})

test("a clock that is set back makes nothing newer older", () => {
  open().of("ten-hertz").write("first")
  clock = 0
  open().of("ten-hertz").write("second")
  assert.equal(open().of("ten-hertz").text, "second")
})

test("ids can be any names, and no two have the same key", () => {
  const store = open("/course/")
  for (const id of ["first-ticks", "first", "the-first-ticks", "constructor", "__proto__"]) store.of(id).write(`of ${id}`)
  open("/").of("first-ticks").write("another site's")
  assert.equal(open("/course/").texts().length, 5)
  for (const [id, text] of open("/course/").texts()) assert.equal(text, `of ${id}`)
})

// --- solved ---

test("solved is the text that solved it", () => {
  const answer = open().of("ten-hertz")
  answer.write("right")
  assert.equal(answer.solve("right"), undefined)
  assert.equal(answer.said, "solved, as you edited it")
  assert.equal(answer.write("wrong"), true)
  assert.equal(answer.said, "as you edited it; an earlier version was solved")
  assert.deepEqual([answer.solved, answer.wasSolved, answer.wasBetter], [false, true, true])
  assert.deepEqual(open().solvedBefore(), [])
  const later = open()
  assert.equal(later.of("ten-hertz").said, "as you edited it; an earlier version was solved")
  assert.deepEqual(later.solvedBefore(), ["ten-hertz"])
  assert.equal(answer.write("right"), true)
  assert.equal(answer.said, "solved, as you edited it")
  answer.write(null)
  assert.equal(open().of("ten-hertz").said, "an earlier version was solved")
})

test("the current text is handed in, not the one that solved it", () => {
  const answer = open().of("ten-hertz")
  answer.write("right")
  answer.solve("right")
  answer.write("wrong")
  assert.deepEqual(handedIn(open()), { "ten-hertz": "wrong" })
  assert.deepEqual(round(answer), ["right", "wrong"])
})

test("an answer in C++ is kept besides that in Python; the one that solved, or else the newer one, is handed in", () => {
  let store = open()
  store.of("ten").write("in Python")
  store.of("ten", "cpp").write("in C++")
  assert.deepEqual(store.texts(), [["ten", "in C++"]])
  assert.deepEqual([store.of("ten").text, store.of("ten", "cpp").text], ["in Python", "in C++"])
  store = open()
  assert.deepEqual(store.texts(), [["ten", "in C++"]])
  assert.equal(store.isSolved("ten"), false)
  store.of("ten").solve("in Python")
  assert.equal(store.isSolved("ten"), true)
  store.of("ten", "cpp").write("in C++, later")
  assert.deepEqual(open().texts(), [["ten", "in Python"]])
  store.of("ten").write("in Python, changed")
  assert.deepEqual(store.texts(), [["ten", "in Python, changed"]])
  assert.deepEqual(store.solvedBefore(), ["ten"])
  store.of("ten", "cpp").solve("in C++, later")
  assert.deepEqual(store.texts(), [["ten", "in C++, later"]])
  assert.deepEqual(store.solvedBefore(), [])
})

test("a text that was changed while it was checked is solved, the one in its place is not", () => {
  const answer = open().of("ten-hertz")
  answer.write("right")
  answer.write("right, and more")
  answer.solve("right")
  assert.equal(answer.text, "right, and more")
  assert.equal(answer.solved, false)
  answer.write("right, and more of it")
  answer.bringBack()
  assert.deepEqual([answer.text, answer.solved], ["right", true])
})

// --- several tabs ---

test("what one tab writes is seen in the other", () => {
  const [one, other] = [open(), open()]
  const said = []
  other.of("ten-hertz").changed = (words) => said.push(words)
  one.of("ten-hertz").write("one's")
  other.heard("rosspin:/:answer:ten-hertz")
  assert.equal(other.of("ten-hertz").text, "one's")
  one.of("ten-hertz").solve("one's")
  other.heard("rosspin:/:answer:ten-hertz")
  other.heard("rosspin:/:answer:ten-hertz")
  other.heard("rosspin:/:answer:fire-once")
  other.heard("another")
  assert.deepEqual(said, ["as you changed it in another tab", "solved, as you edited it"])
})

for (const asleep of [false, true]) {
  test(`of two tabs the newest text wins, and no text is lost${asleep ? ", even of one that was asleep" : ""}`, () => {
    const [one, other] = [open(), open()]
    for (const store of [one, other]) store.of("ten-hertz")
    const wake = () => asleep || [one, other].forEach((store) => store.refresh())
    type(one.of("ten-hertz"), "one's")
    wake()
    type(other.of("ten-hertz"), "other's")
    wake()
    type(one.of("ten-hertz"), "again one's")
    wake()
    const later = open()
    assert.equal(later.of("ten-hertz").text, "again one's")
    assert.deepEqual(round(later.of("ten-hertz")), ["other's", "one's", "again one's"])
    assert.deepEqual(handedIn(open()), { "ten-hertz": "again one's" })
  })
}

test("a tab that is open, that runs or is handed in from, writes nothing over", () => {
  const [one, other] = [open(), open()]
  one.of("ten-hertz").write("old")
  other.refresh()
  other.of("ten-hertz").write("new")
  one.of("ten-hertz").solve("old")
  assert.deepEqual(handedIn(one), { "ten-hertz": "new" })
  assert.deepEqual(handedIn(open()), { "ten-hertz": "new" })
  assert.deepEqual(round(open().of("ten-hertz")), ["old", "new"])
})

test("of two texts that are written at the same moment none is lost", () => {
  const [one, other] = [open(), open()]
  one.of("ten-hertz").write("one's")
  delete storage["rosspin:/:answer:ten-hertz"] // the other tab does not see it yet
  other.of("ten-hertz").write("other's")
  for (const store of [one, other, one, other]) store.heard("rosspin:/:answer:ten-hertz")
  assert.equal(one.of("ten-hertz").text, "other's")
  assert.equal(other.of("ten-hertz").text, "other's")
  assert.deepEqual(round(open().of("ten-hertz")), ["one's", "other's"])
})

test("tabs do not answer each other without end", () => {
  const stores = [open(), open(), open()]
  stores.forEach((store, number) => store.of("ten-hertz").write(`text ${number}`))
  let writes = 0
  storage.setItem = (key, value) => (writes++, (storage[key] = value))
  for (let times = 0; times < 10; times++) stores.forEach((store) => store.refresh())
  assert.ok(writes <= 3, String(writes))
})

test("a reset in one tab is one in the other, where it can be taken back", () => {
  const [one, other] = [open(), open()]
  one.of("ten-hertz").write("mine")
  other.of("ten-hertz").write(null)
  one.refresh()
  assert.equal(one.of("ten-hertz").text, null)
  one.of("ten-hertz").bringBack()
  assert.equal(open().of("ten-hertz").text, "mine")
})

// --- storage that is full, gone, cleared or spoilt ---

test("what is not kept is said, handed in from this page, and kept as soon as that can be", () => {
  const answer = open().of("ten-hertz")
  answer.write("kept")
  const store = open()
  state.full = 1000
  assert.equal(store.of("ten-hertz").write("x".repeat(2000)), true)
  assert.equal(store.of("ten-hertz").unkept, "the browser's storage is full")
  assert.deepEqual(handedIn(store), { "ten-hertz": "x".repeat(2000) })
  assert.deepEqual(handedIn(open()), { "ten-hertz": "kept" })
  state.full = 0
  store.refresh()
  assert.equal(store.of("ten-hertz").unkept, "")
  assert.deepEqual(handedIn(open()), { "ten-hertz": "x".repeat(2000) })
  assert.deepEqual(round(open().of("ten-hertz")), ["kept", "x".repeat(2000)])
})

test("without a storage answers last as long as the page", () => {
  state.gone = true
  const store = open()
  store.adopt("ten-hertz", "1a")
  assert.equal(store.of("ten-hertz").text, null)
  assert.equal(store.of("ten-hertz").write("mine"), true)
  assert.equal(store.of("ten-hertz").unkept, "this browser keeps nothing here")
  store.of("ten-hertz").solve("mine")
  assert.equal(store.of("ten-hertz").solved, true)
  assert.deepEqual(handedIn(store), { "ten-hertz": "mine" })
})

test("what is in view stays the student's when the storage is cleared", () => {
  const store = open()
  store.of("ten-hertz").write("mine")
  storage.removeItem("rosspin:/:answer:ten-hertz")
  store.refresh()
  assert.equal(store.of("ten-hertz").text, "mine")
  assert.deepEqual(handedIn(store), { "ten-hertz": "mine" })
  store.of("ten-hertz").write("mine, too")
  assert.equal(open().of("ten-hertz").text, "mine, too")
})

const SPOILT = ["", "{", "null", "5", '"text"', "{}", '{"versions": 5}', '{"versions": [null]}', '{"versions": [{}]}']
for (const spoilt of SPOILT) {
  test(`a record that is none is no answer: ${spoilt}`, () => {
    storage["rosspin:/:answer:ten-hertz"] = spoilt
    const store = open()
    assert.equal(store.of("ten-hertz").text, null)
    assert.deepEqual(handedIn(store), {})
    store.of("ten-hertz").write("mine")
    assert.equal(open().of("ten-hertz").text, "mine")
  })
}

// --- earlier versions of the site ---

const answered = (name, text) => `%%answer ${name}\n${text}\n`

test("what earlier versions of the site kept is taken over, first for the cell as it is now", () => {
  Object.assign(storage, {
    "rosspin:/notebooks/exercises.html:3:aa": answered(4, "oldest"),
    "rosspin:/notebooks/exercises.html:4:bb": answered(4, "newest"),
    "rosspin:/exercises.html:4:cc": answered(4, "other page's"),
    "rosspin:/notebooks/exercises.html:5:bb": "no first line",
    "rosspin:/notebooks/exercises.html:5:dd": answered(5, "another exercise's"),
    "rosspin:/notebooks/exercises.html:4:bb:solved": "yes",
    "rosspin:progress:/notebooks/exercises.html": "1 of 19 solved",
  })
  const store = open()
  store.adopt("ten-hertz", "bb")
  const answer = store.of("ten-hertz")
  assert.ok([answered("ten-hertz", "newest"), "no first line"].includes(answer.text))
  const texts = ["newest", "oldest", "other page's"].map((text) => answered("ten-hertz", text))
  assert.deepEqual(round(answer).sort(), [...texts, "no first line"])
  assert.equal(answer.wasSolved, true)
  assert.deepEqual(Object.keys(storage).sort(), [
    "rosspin:/:answer:ten-hertz",
    "rosspin:/notebooks/exercises.html:5:dd",
    "rosspin:progress:/notebooks/exercises.html",
  ])
  assert.deepEqual(open().of("ten-hertz").text, answer.text)
})

test("one that was solved and reset is still solved", () => {
  storage["rosspin:/notebooks/exercises.html:4:bb:solved"] = "yes"
  const store = open()
  store.adopt("fire-once", "cc")
  store.adopt("ten-hertz", "bb")
  assert.deepEqual([store.of("ten-hertz").said, store.of("fire-once").said], ["an earlier version was solved", ""])
  assert.deepEqual(handedIn(store), {})
})

test("answers of other pages are handed in before their page is opened, of other sites never", () => {
  storage["rosspin:/course/notebooks/ros2-exercises.html:0:1a"] = answered(20, "mine")
  storage["rosspin:/other/notebooks/ros2-exercises.html:0:1a"] = answered(21, "another site's")
  const store = open("/course/")
  assert.deepEqual(handedIn(store), { "slow-timer": answered("slow-timer", "mine") })
  store.of("slow-timer").write(null)
  assert.deepEqual(handedIn(store), {})
})

test("what is not kept again is not taken away", () => {
  const old = answered(4, "x".repeat(500))
  const text = answered("ten-hertz", "x".repeat(500))
  storage["rosspin:/notebooks/exercises.html:4:bb"] = old
  state.full = 100
  const store = open()
  store.adopt("ten-hertz", "bb")
  assert.equal(store.of("ten-hertz").text, text)
  assert.equal(store.of("ten-hertz").unkept, "")
  assert.equal(storage["rosspin:/notebooks/exercises.html:4:bb"], old)
})

test("an earlier version of the site in another tab continues to write: nothing is lost, no newer text hidden", () => {
  const key = "rosspin:/notebooks/exercises.html:4:bb"
  storage[key] = answered(4, "first")
  open().adopt("ten-hertz", "bb")
  storage[key] = answered(4, "second")
  let store = open()
  store.adopt("ten-hertz", "bb")
  assert.equal(store.of("ten-hertz").text, answered("ten-hertz", "second"))
  store.of("ten-hertz").write("third")
  storage[key] = answered(4, "fourth")
  store = open()
  store.adopt("ten-hertz", "bb")
  assert.equal(store.of("ten-hertz").text, "third")
  assert.deepEqual(round(store.of("ten-hertz")), [...["fourth", "second", "first"].map((text) => answered("ten-hertz", text)), "third"])
})

// --- before exercises had names ---

/** What an earlier version of the site keeps of an exercise that it knows by a number. */
function numbered(number, ...texts) {
  const versions = texts.map((text, place) => ({ id: `old.${place}`, time: 500 - place, text: answered(number, text) }))
  storage[`rosspin:/:answer:${number}`] = JSON.stringify({ solved: true, versions })
}

test("an answer that was kept by its number is there by its name, with its versions", () => {
  numbered(20, "newest", "oldest")
  const answer = open().of("slow-timer")
  assert.equal(answer.text, answered("slow-timer", "newest"))
  assert.equal(answer.wasSolved, true)
  assert.deepEqual(round(answer), ["oldest", "newest"].map((text) => answered("slow-timer", text)))
  assert.deepEqual(Object.keys(storage), ["rosspin:/:answer:slow-timer"])
  assert.deepEqual(handedIn(open()), { "slow-timer": answered("slow-timer", "newest") })
})

test("what an earlier version of the site writes in another tab is taken over, and hides no newer text", () => {
  const store = open()
  store.of("ten-hertz").write("newer")
  numbered(4, "older")
  store.heard("rosspin:/:answer:4")
  assert.deepEqual(round(store.of("ten-hertz")), [answered("ten-hertz", "older"), "newer"])
  assert.deepEqual(Object.keys(storage), ["rosspin:/:answer:ten-hertz"])
})

test("what cannot be kept by its name stays where it is, and is there all the same", () => {
  numbered(4, "x".repeat(500))
  state.full = 100
  assert.equal(open().of("ten-hertz").text, answered("ten-hertz", "x".repeat(500)))
  assert.deepEqual(Object.keys(storage), ["rosspin:/:answer:4"])
})

// --- what others have written there ---

const KEY = "rosspin:/:answer:a-b"
const version = (changed) => ({ id: "x.1", time: 5, text: "x", ...changed })

test("of a record no more is read than a page can bear, whoever wrote it", () => {
  const odd = [
    { id: "x".repeat(101) }, { id: 5 }, { time: 1e300 }, { time: "5" }, { time: null }, { text: "x".repeat(100_001) }, { text: ["x"] },
  ]
  storage.setItem(KEY, JSON.stringify({ solved: true, versions: [...odd.map(version), version({ text: "mine", time: 1 })] }))
  assert.deepEqual([open().of("a-b").text, open().of("a-b").hasEarlier, open().of("a-b").wasSolved], ["mine", false, true])
  for (const versions of [
    Array.from({ length: 20_000 }, (_, n) => version({ id: `x.${n}`, text: `${n}` })),
    [version({ more: "x".repeat(3_000_000) })],
  ]) {
    storage.setItem(KEY, JSON.stringify({ solved: true, versions }))
    assert.deepEqual([open().of("a-b").text, open().of("a-b").wasSolved], [null, false])
  }
})

test("so many answers are handed in, with names that are no longer than an exercise's", () => {
  for (let n = 0; n < 3000; n++) storage.setItem(`${KEY}-${n}`, JSON.stringify({ solved: false, versions: [version({})] }))
  storage.setItem(`rosspin:/:answer:${"a".repeat(101)}`, JSON.stringify({ solved: false, versions: [version({})] }))
  const ids = Object.keys(handedIn(open()))
  assert.ok(ids.length === 1000 && ids.every((id) => id.length <= 100))
})

test("a text that is too long to be shown again is not kept, which is said, until it is shorter", () => {
  const answer = open().of("a-b")
  answer.write("short")
  assert.equal(answer.write("x".repeat(100_001)), true)
  assert.equal(answer.unkept, "it has more than 100,000 characters")
  assert.equal(answer.text.length, 100_001)
  assert.equal(answer.write("x".repeat(100_000)), true)
  assert.equal(answer.unkept, "")
  assert.equal(open().of("a-b").text.length, 100_000)
})
