// Loaded with each page of exercises, before live.js: has the store of all answers, which live.js shows, and lets the
// reader save them as a file to hand in.

import { MOST, isTooLong, write } from "./answers.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { fingerprint, isText } from "./kept.js"
import { find, here, make, save } from "./make.js"
import { named, numberOf, withNumber } from "./names.js"
import { Store } from "./store.js"

/** Under this, for all pages, the reader's name, ID, and what tells readers of the same name apart. */
const KEY = "rosspin:hand-in"

/** The site, beneath which all of its pages are. */
const root = new URL("../../", here()).pathname

const random = () => Math.random().toString(36).slice(2)

const store = new Store(root, { storage: () => localStorage, now: Date.now, page: random() })
window.rosspinStore = store

// The cells are here as they came with the page: live.js shows the reader's own texts in their place later.
for (const { textContent } of document.querySelectorAll("div.live pre")) {
  const name = named(textContent)
  if (name) store.adopt(name, fingerprint(withNumber(textContent)))
}

addEventListener("storage", ({ key }) => key && store.heard(key))
// What other tabs wrote while this one was asleep, or was left and is shown again, no event has told.
for (const sign of ["pageshow", "visibilitychange"]) addEventListener(sign, () => store.refresh())

/** Where an address leads to an exercise on a list, as it did when they were all on one page, go to its own. */
function leadOn() {
  const entry = location.hash && document.getElementById(location.hash.slice(1))?.closest(".exercise-list > li")
  if (entry) location.replace(find("a", entry).getAttribute("href") + location.search)
}

leadOn()
addEventListener("hashchange", leadOn)

/** @returns {{name?: string, student?: string, id?: string}} */
function known() {
  try {
    const found = Object.entries(JSON.parse(localStorage.getItem(KEY) ?? "null") ?? {})
    return Object.fromEntries(found.flatMap(([key, value]) => (isText(value) ? [[key, value.slice(0, MOST.name)]] : [])))
  } catch {
    return {}
  }
}

/** @param {SubmitEvent} event */
function handIn(event) {
  event.preventDefault()
  const name = field.value.trim()
  field.ariaInvalid = String(!name)
  if (!name) {
    status.textContent = "Write your name first."
    field.focus()
    return
  }
  const found = Object.fromEntries(store.texts())
  const exercises = Object.keys(found)
  if (!exercises.length) {
    const nothing = store.solvedBefore().length ? "no answer is changed now." : "you have not changed an answer yet."
    status.textContent = [`There is nothing to hand in: ${nothing}`, ...doubts(found, "")].join(" ")
    return
  }
  const student = idField.value.trim()
  const { id = mine } = known() // another tab may have handed in meanwhile
  try {
    localStorage.setItem(KEY, JSON.stringify({ name, student, id }))
  } catch {
    // The next time, it has to be written again.
  }
  const file = `rosspin-answers-${name.replace(/[^\p{L}\p{N}]+/gu, "-")}.json`
  const text = write(name, id, found, student)
  save(file, "application/json", text)
  const which = `your answer${exercises.length === 1 ? "" : "s"} to ${list(exercises)}`
  const said = [`Saved as ${file}, with ${which}. Give this file to your teacher.`, ...doubts(found, text)]
  status.textContent = said.join(" ")
}

/**
 * What the student may not expect of the file.
 *
 * @param {Record<string, string>} found the answers
 * @param {string} text of the file
 */
function doubts(found, text) {
  const changed = store.solvedBefore()
  const long = Object.keys(found).filter((exercise) => isTooLong(found[exercise]))
  return [
    changed.length && `You have solved ${list(changed)} with another text, which Restore earlier version brings back.`,
    long.length && `Too long to be judged, with more than ${MOST.answer} characters: ${list(long)}.`,
    new Blob([text]).size > MOST.file && `The file is too large to be read: more than ${MOST.file / 1e6} MB.`,
  ].filter(Boolean)
}

/**
 * Some exercises by their numbers, in words.
 *
 * @param {string[]} names
 */
function list(names) {
  const numbers = names.map(numberOf)
  numbers.sort(new Intl.Collator("en", { numeric: true }).compare)
  if (numbers.length === 1) return `exercise ${numbers}`
  return `exercises ${numbers.slice(0, -1).join(", ")} and ${numbers.at(-1)}`
}

const { name = "", student: number = "", id: mine = random() } = known()
const field = make("input", { value: name, maxLength: 2 * MOST.name, autocomplete: "name" }) // of which emoji have two
const idField = make("input", { value: number, maxLength: 2 * MOST.name, autocomplete: "off" })
const status = make("span", { role: "status" })
const form = make("form", { className: "hand-in", noValidate: true })
form.append(make("label", {}, "Your name ", field), make("label", {}, "Student ID, if your teacher wants it ", idField))
form.append(make("button", { textContent: "Save answers" }), status)
form.addEventListener("submit", handIn)
const cannot = make("p", { textContent: `This browser cannot check answers, nor hand them in: ${LACKS_JSPI}` })
const shown = HAS_JSPI ? form : cannot
// A list begins with it. On the page of a single exercise it is last: for a text that the browser does not keep.
if (location.protocol === "file:") shown.remove()
else if (document.querySelector(".exercise-way")) find("article").append(shown)
else find("article h1").after(shown)
