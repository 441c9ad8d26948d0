// Loaded with each page of exercises, before live.js: lets the reader save the answers as a file to hand in.

import { MOST, write } from "./answers.js"
import { HAS_JSPI, LACKS_JSPI } from "./jspi.js"
import { make, save } from "./make.js"

/** Under this, for all pages, the reader's name and what tells readers of the same name apart. */
const KEY = "rosspin:hand-in"

const ANSWER = /^%%answer (\d+)\n/

/** The site, beneath which all of its pages are. */
const root = new URL("../../", document.currentScript.src).pathname

/** The answers of this page. live.js shows the reader's own text in place of the original, which is here until then. */
const places = [...document.querySelectorAll("div.live pre")]
  .map((pre) => ({ pre, original: pre.textContent, number: pre.textContent.match(ANSWER)?.[1] }))
  .filter(({ number }) => number)

/** What the browser keeps, as pairs. */
function kept() {
  try {
    return Object.entries(localStorage)
  } catch {
    return [] // the reader does not let pages keep anything
  }
}

/** What has been answered: number -> text. Of this page as it stands there, of others as the browser keeps it. */
function answers() {
  const here = new Set(places.map(({ number }) => number))
  const found = {}
  for (const [key, text] of kept()) {
    const number = key.startsWith(`rosspin:${root}`) && text.match(ANSWER)?.[1]
    if (number && !here.has(number)) found[number] = text
  }
  for (const { pre, original, number } of places) {
    if (pre.textContent !== original) found[number] = pre.textContent
  }
  return found
}

function known() {
  try {
    return JSON.parse(localStorage.getItem(KEY)) ?? {}
  } catch {
    return {}
  }
}

function handIn(event) {
  event.preventDefault()
  const name = field.value.trim()
  field.ariaInvalid = String(!name)
  if (!name) {
    status.textContent = "Write your name first."
    field.focus()
    return
  }
  const found = answers()
  const numbers = Object.keys(found)
  if (!numbers.length) {
    status.textContent = "There is nothing to hand in: you have not changed an answer yet."
    return
  }
  try {
    localStorage.setItem(KEY, JSON.stringify({ name, id }))
  } catch {
    // The next time, it has to be written again.
  }
  const file = `rosspin-answers-${name.replace(/[^\p{L}\p{N}]+/gu, "-")}.json`
  save(file, "application/json", write(name, id, found))
  const which = numbers.length === 1 ? `your answer to exercise ${numbers}` : `your answers to ${list(numbers)}`
  status.textContent = `Saved as ${file}, with ${which}. Give this file to your teacher.`
}

/** Some numbers of exercises, in words. */
function list(numbers) {
  return `exercises ${numbers.slice(0, -1).join(", ")} and ${numbers.at(-1)}`
}

const { name = "", id = Math.random().toString(36).slice(2) } = known()
const field = make("input", { value: name, maxLength: MOST.name, autocomplete: "name" })
const status = make("span", { role: "status" })
const form = make("form", { className: "hand-in", noValidate: true })
form.append(make("label", {}, "Your name ", field), make("button", { textContent: "Hand in" }), status)
form.addEventListener("submit", handIn)
const cannot = make("p", { textContent: `This browser cannot check answers, nor hand them in: ${LACKS_JSPI}` })
if (location.protocol !== "file:") document.querySelector("article h1").after(HAS_JSPI ? form : cannot)
