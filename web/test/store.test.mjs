// What the store promises, without a browser: two pages share a storage, as two tabs do.

import assert from "node:assert/strict"
import { beforeEach, test } from "node:test"

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

/** Each text that Earlier version shows, up to the one that it began with, with which it ends. */
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
  type(store.of("4"), "mine")
  store.of("5")
  const later = open()
  assert.equal(later.of("4").text, "mine")
  assert.equal(later.of("4").said, "as you edited it")
  assert.equal(later.of("5").text, null)
  assert.equal(later.of("5").said, "")
  assert.deepEqual(handedIn(open()), { 4: "mine" })
})

test("typing makes no versions, a visit makes one", () => {
  type(open().of("4"), "first")
  const answer = open().of("4")
  assert.equal(answer.hasEarlier, false)
  type(answer, "second")
  assert.deepEqual(round(answer), ["first", "second"])
  type(open().of("4"), "third")
  assert.deepEqual(round(open().of("4")), ["second", "first", "third"])
})

test("Reset can be taken back, also after a reload", () => {
  const answer = open().of("4")
  type(answer, "mine")
  answer.write(null)
  assert.equal(answer.text, null)
  assert.deepEqual(handedIn(open()), {})
  const later = open().of("4")
  later.bringBack()
  assert.equal(later.text, "mine")
  assert.equal(open().of("4").text, "mine")
})

test("what was typed back to an earlier text leaves that one alone", () => {
  open().of("4").write("mine")
  const answer = open().of("4")
  for (const text of ["mine!", "mine", "mine?"]) answer.write(text)
  assert.deepEqual(round(answer), ["mine", "mine?"])
})

test("not all versions are kept, but the newest that solved the exercise is", () => {
  const first = open().of("4")
  first.write("solution")
  first.solve("solution")
  for (let visit = 0; visit < 20; visit++) open().of("4").write(`attempt ${visit}`)
  const texts = round(open().of("4"))
  assert.equal(texts.length, 7)
  assert.ok(texts.includes("solution"))
  assert.equal(texts.at(-1), "attempt 19")
})

test("a clock that is set back makes nothing newer older", () => {
  open().of("4").write("first")
  clock = 0
  open().of("4").write("second")
  assert.equal(open().of("4").text, "second")
})

test("ids need not be numbers, and nobody's key is another's", () => {
  const store = open("/course/")
  for (const id of ["1", "11", "the-first-ticks", "constructor", "__proto__"]) store.of(id).write(`of ${id}`)
  open("/").of("1").write("another site's")
  assert.equal(open("/course/").texts().length, 5)
  for (const [id, text] of open("/course/").texts()) assert.equal(text, `of ${id}`)
})

// --- solved ---

test("solved is the text that solved it", () => {
  const answer = open().of("4")
  answer.write("right")
  assert.equal(answer.solve("right"), undefined)
  assert.equal(answer.said, "solved, as you edited it")
  assert.equal(answer.write("wrong"), true)
  assert.equal(answer.said, "as you edited it; an earlier version was solved")
  assert.deepEqual([answer.solved, answer.wasSolved, answer.wasBetter], [false, true, true])
  assert.deepEqual(open().solvedBefore(), [])
  const later = open()
  assert.equal(later.of("4").said, "as you edited it; an earlier version was solved")
  assert.deepEqual(later.solvedBefore(), ["4"])
  assert.equal(answer.write("right"), true)
  assert.equal(answer.said, "solved, as you edited it")
  answer.write(null)
  assert.equal(open().of("4").said, "an earlier version was solved")
})

test("the current text is handed in, not the one that solved it", () => {
  const answer = open().of("4")
  answer.write("right")
  answer.solve("right")
  answer.write("wrong")
  assert.deepEqual(handedIn(open()), { 4: "wrong" })
  assert.deepEqual(round(answer), ["right", "wrong"])
})

test("a text that was changed while it was checked is solved, the one in its place is not", () => {
  const answer = open().of("4")
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
  other.of("4").changed = (words) => said.push(words)
  one.of("4").write("one's")
  other.heard("rosspin:/:answer:4")
  assert.equal(other.of("4").text, "one's")
  one.of("4").solve("one's")
  other.heard("rosspin:/:answer:4")
  other.heard("rosspin:/:answer:4")
  other.heard("rosspin:/:answer:5")
  other.heard("another")
  assert.deepEqual(said, ["as you changed it in another tab", "solved, as you edited it"])
})

for (const asleep of [false, true]) {
  test(`of two tabs the newest text wins, and no text is lost${asleep ? ", even of one that was asleep" : ""}`, () => {
    const [one, other] = [open(), open()]
    for (const store of [one, other]) store.of("4")
    const wake = () => asleep || [one, other].forEach((store) => store.refresh())
    type(one.of("4"), "one's")
    wake()
    type(other.of("4"), "other's")
    wake()
    type(one.of("4"), "again one's")
    wake()
    const later = open()
    assert.equal(later.of("4").text, "again one's")
    assert.deepEqual(round(later.of("4")), ["other's", "one's", "again one's"])
    assert.deepEqual(handedIn(open()), { 4: "again one's" })
  })
}

test("a tab that is open, that runs or is handed in from, writes nothing over", () => {
  const [one, other] = [open(), open()]
  one.of("4").write("old")
  other.refresh()
  other.of("4").write("new")
  one.of("4").solve("old")
  assert.deepEqual(handedIn(one), { 4: "new" })
  assert.deepEqual(handedIn(open()), { 4: "new" })
  assert.deepEqual(round(open().of("4")), ["old", "new"])
})

test("of two texts that are written at the same moment none is lost", () => {
  const [one, other] = [open(), open()]
  one.of("4").write("one's")
  delete storage["rosspin:/:answer:4"] // the other tab does not see it yet
  other.of("4").write("other's")
  for (const store of [one, other, one, other]) store.heard("rosspin:/:answer:4")
  assert.equal(one.of("4").text, "other's")
  assert.equal(other.of("4").text, "other's")
  assert.deepEqual(round(open().of("4")), ["one's", "other's"])
})

test("tabs do not answer each other without end", () => {
  const stores = [open(), open(), open()]
  stores.forEach((store, number) => store.of("4").write(`text ${number}`))
  let writes = 0
  storage.setItem = (key, value) => (writes++, (storage[key] = value))
  for (let times = 0; times < 10; times++) stores.forEach((store) => store.refresh())
  assert.ok(writes <= 3, String(writes))
})

test("a reset in one tab is one in the other, where it can be taken back", () => {
  const [one, other] = [open(), open()]
  one.of("4").write("mine")
  other.of("4").write(null)
  one.refresh()
  assert.equal(one.of("4").text, null)
  one.of("4").bringBack()
  assert.equal(open().of("4").text, "mine")
})

// --- storage that is full, gone, cleared or spoilt ---

test("what is not kept is said, handed in from this page, and kept as soon as that can be", () => {
  const answer = open().of("4")
  answer.write("kept")
  const store = open()
  state.full = 1000
  assert.equal(store.of("4").write("x".repeat(2000)), true)
  assert.equal(store.of("4").unkept, "the browser's storage is full")
  assert.deepEqual(handedIn(store), { 4: "x".repeat(2000) })
  assert.deepEqual(handedIn(open()), { 4: "kept" })
  state.full = 0
  store.refresh()
  assert.equal(store.of("4").unkept, "")
  assert.deepEqual(handedIn(open()), { 4: "x".repeat(2000) })
  assert.deepEqual(round(open().of("4")), ["kept", "x".repeat(2000)])
})

test("without a storage answers last as long as the page", () => {
  state.gone = true
  const store = open()
  store.adopt("4", "1a")
  assert.equal(store.of("4").text, null)
  assert.equal(store.of("4").write("mine"), true)
  assert.equal(store.of("4").unkept, "this browser keeps nothing here")
  store.of("4").solve("mine")
  assert.equal(store.of("4").solved, true)
  assert.deepEqual(handedIn(store), { 4: "mine" })
})

test("what is in view stays the student's when the storage is cleared", () => {
  const store = open()
  store.of("4").write("mine")
  storage.removeItem("rosspin:/:answer:4")
  store.refresh()
  assert.equal(store.of("4").text, "mine")
  assert.deepEqual(handedIn(store), { 4: "mine" })
  store.of("4").write("mine, too")
  assert.equal(open().of("4").text, "mine, too")
})

const SPOILT = ["", "{", "null", "5", '"text"', "{}", '{"versions": 5}', '{"versions": [null]}', '{"versions": [{}]}']
for (const spoilt of SPOILT) {
  test(`a record that is none is no answer: ${spoilt}`, () => {
    storage["rosspin:/:answer:4"] = spoilt
    const store = open()
    assert.equal(store.of("4").text, null)
    assert.deepEqual(handedIn(store), {})
    store.of("4").write("mine")
    assert.equal(open().of("4").text, "mine")
  })
}

// --- earlier versions of the site ---

const answered = (number, text) => `%%answer ${number}\n${text}\n`

test("what earlier versions of the site kept is taken over, that of the cell as it is now first", () => {
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
  store.adopt("4", "bb")
  const answer = store.of("4")
  assert.ok([answered(4, "newest"), "no first line"].includes(answer.text))
  const texts = ["newest", "oldest", "other page's"].map((text) => answered(4, text))
  assert.deepEqual(round(answer).sort(), [...texts, "no first line"])
  assert.equal(answer.wasSolved, true)
  assert.deepEqual(Object.keys(storage).sort(), [
    "rosspin:/:answer:4",
    "rosspin:/notebooks/exercises.html:5:dd",
    "rosspin:progress:/notebooks/exercises.html",
  ])
  assert.deepEqual(open().of("4").text, answer.text)
})

test("one that was solved and reset is still solved", () => {
  storage["rosspin:/notebooks/exercises.html:4:bb:solved"] = "yes"
  const store = open()
  store.adopt("5", "cc")
  store.adopt("4", "bb")
  assert.deepEqual([store.of("4").said, store.of("5").said], ["an earlier version was solved", ""])
  assert.deepEqual(handedIn(store), {})
})

test("those of other pages are handed in before their page is opened, and of other sites never", () => {
  storage["rosspin:/course/notebooks/ros2-exercises.html:0:1a"] = answered(20, "mine")
  storage["rosspin:/other/notebooks/ros2-exercises.html:0:1a"] = answered(21, "another site's")
  const store = open("/course/")
  assert.deepEqual(handedIn(store), { 20: answered(20, "mine") })
  store.of("20").write(null)
  assert.deepEqual(handedIn(store), {})
})

test("what is not kept anew is not taken away", () => {
  const text = answered(4, "x".repeat(500))
  storage["rosspin:/notebooks/exercises.html:4:bb"] = text
  state.full = 100
  const store = open()
  store.adopt("4", "bb")
  assert.equal(store.of("4").text, text)
  assert.equal(store.of("4").unkept, "")
  assert.equal(storage["rosspin:/notebooks/exercises.html:4:bb"], text)
})

test("an earlier version of the site in another tab goes on writing: nothing is lost, no newer text hidden", () => {
  const key = "rosspin:/notebooks/exercises.html:4:bb"
  storage[key] = answered(4, "first")
  open().adopt("4", "bb")
  storage[key] = answered(4, "second")
  let store = open()
  store.adopt("4", "bb")
  assert.equal(store.of("4").text, answered(4, "second"))
  store.of("4").write("third")
  storage[key] = answered(4, "fourth")
  store = open()
  store.adopt("4", "bb")
  assert.equal(store.of("4").text, "third")
  assert.deepEqual(round(store.of("4")), [...["fourth", "second", "first"].map((text) => answered(4, text)), "third"])
})
