// The answers of a student, as the browser keeps them: by exercise, whichever page, tab or link shows it.
//
// An answer is a list of versions, newest first. Typing continues in the newest one; a new one begins where another page
// or tab wrote that, after Reset, and where a text that solved the exercise is changed. So no text is written over
// unseen. A version whose text is null is the cell as it comes with its page.

import { isText, LONGEST, PREFIX, TOO_LONG, why } from "./kept.js"
import { valuesIn } from "./limits.js"
import { named, nameOf, withName } from "./names.js"

/** So many versions are kept, and the newest that solved the exercise. */
const MOST = 6

/**
 * What is read at most, whoever wrote it, since pages of other sites can have the same storage: of a record (characters,
 * values of JSON), of the names in it (characters), and so many records.
 */
const READ = { record: 3 * MOST * LONGEST, values: 1000, name: 100, records: 1000 }

/**
 * A text, or with null the cell as it comes with its page, with a name that no other has, and when (ms) it was begun.
 *
 * @typedef {{id: string, time: number, text: string | null, solved?: boolean}} Version
 * @typedef {{solved: boolean, versions: Version[]}} Known of an answer: whether some text has solved it, and the versions,
 *   newest first
 *
 * What a browser has; `page` is a name that no other page has, and `begun` counts what it has named.
 * @typedef {{storage(): Storage, now(): number, page: string}} Browser
 * @typedef {Browser & {begun: number}} Browsing
 */

/** How the key of an answer in C++ ends. */
const CPP = ".cpp"

/** @type {Known} */
const NONE = { solved: false, versions: [] }

/** How the keys of earlier versions of the site end: number of the listing on its page, fingerprint; solved or not. */
const OLD = /:\d+:([0-9a-f]+)(:solved)?$/

/**
 * Versions in their order, each text once, without those that are too many.
 *
 * @param {Version[]} versions
 */
function inOrder(versions) {
  /** @type {Version[]} */
  const found = []
  for (const version of [...versions].sort((one, other) => other.time - one.time)) {
    const same = found.find(({ id, text }) => id === version.id || text === version.text)
    if (same?.text === version.text) same.solved ||= version.solved
    else if (!same && (version.text !== null || !found.length)) found.push({ ...version })
  }
  const solved = found.find((version) => version.solved)
  return found.filter((version, number) => number < MOST || version === solved)
}

/**
 * A record as it was written; null if that is none.
 *
 * @param {string | null} written
 * @returns {Known | null}
 */
function parsed(written) {
  if (!written || written.length > READ.record || valuesIn(written) > READ.values) return null
  try {
    const { solved, versions } = JSON.parse(written)
    const right = (/** @type {any} */ { id, time, text }) =>
      typeof id === "string" &&
      id.length <= READ.name &&
      typeof time === "number" &&
      Math.abs(time) <= Number.MAX_SAFE_INTEGER &&
      (text === null || isText(text))
    return { solved: solved === true, versions: inOrder(versions.filter(right)) }
  } catch {
    return null
  }
}

/** The answer to one exercise. */
export class Answer {
  #key
  #browser
  #known = NONE // the record, as this page knows it
  /** @type {string | null} */
  #draft = null // the version that typing continues in
  /** @type {(string | null)[] | null} */
  #round = null // the texts that Restore earlier version goes through, the one that is shown first

  /** Why the browser does not keep it, in words; "" if it does. */
  unkept = ""

  /** @type {(said: string) => void} is called when another tab has changed it, with what there is to say of that */
  changed = () => {}

  /**
   * @param {string} key
   * @param {Browsing} browser
   */
  constructor(key, browser) {
    this.#key = key
    this.#browser = browser
    this.#known = this.#latest()
  }

  /** What the student wrote; null if the cell is as it comes with its page. */
  get text() {
    return this.#known.versions[0]?.text ?? null
  }

  /** When (ms) that was begun. */
  get time() {
    return this.#known.versions[0]?.time ?? 0
  }

  /** Whether this very text has solved the exercise. */
  get solved() {
    return this.#known.versions[0]?.solved === true
  }

  /** Whether some text has. */
  get wasSolved() {
    return this.#known.solved
  }

  /** Whether one of the texts that can be brought back has solved it, and this one has not. */
  get wasBetter() {
    return !this.solved && this.#known.versions.some(({ solved }) => solved)
  }

  /** Whether there is another text to bring back. */
  get hasEarlier() {
    return (this.#round ?? this.#known.versions).length > 1
  }

  get #state() {
    return JSON.stringify([this.solved, this.unkept])
  }

  /** What there is to say of it. */
  get said() {
    const edited = this.text !== null && "as you edited it"
    if (this.solved) return ["solved", edited].filter(Boolean).join(", ")
    return [edited, this.wasSolved && "an earlier version was solved"].filter(Boolean).join("; ")
  }

  /**
   * Keep what the student has written, or with null that the cell was reset. Whether `solved` or `unkept`
   * is another now.
   *
   * @param {string | null} text
   */
  write(text) {
    const before = this.#state
    this.#round = null
    this.#known = this.#latest()
    if (text !== this.text) this.#add(text)
    return before !== this.#state
  }

  /** @param {string | null} text */
  #add(text) {
    const { solved, versions } = this.#known
    const [newest] = versions
    const goesOn = newest && newest.id === this.#draft && !newest.solved && text !== null
    const id = goesOn ? newest.id : this.#newId()
    this.#draft = text === null || versions.some((version) => version.text === text) ? null : id
    // A clock that was set back makes no text older than the one that it was written after.
    const time = Math.max(this.#browser.now(), (newest?.time ?? 0) + 1)
    this.#save({ solved, versions: inOrder([{ id, time, text }, ...versions]) })
  }

  /**
   * Keep that a text, with null the page's, has solved the exercise. It may have been changed since.
   *
   * @param {string | null} text
   */
  solve(text) {
    const { versions } = this.#latest()
    const time = versions.length ? versions[0].time - 1 : this.#browser.now()
    const version = versions.find((other) => other.text === text) ?? { id: this.#newId(), time, text }
    this.#save({ solved: true, versions: inOrder([...versions, { ...version, solved: true }]) })
  }

  /** Bring back the text before this one, and after the first of all the newest. What there is to say of it. */
  bringBack() {
    const { versions } = this.#latest()
    const round = this.#round ?? versions.map(({ text }) => text)
    round.push(...round.splice(0, 1))
    this.#draft = null // the text that is there stays a version
    const time = versions.find(({ text }) => text === round[0])?.time
    this.write(round[0])
    this.#round = round
    const when = time ? `last changed ${new Date(time).toLocaleString("sv")}` : ""
    const what = round[0] === null ? "as it came with the page" : "an earlier version"
    return [what, when, this.solved && "solved"].filter(Boolean).join(", ")
  }

  /** See what other tabs have made of it. */
  refresh() {
    const before = JSON.stringify([this.#known, this.unkept])
    const latest = this.#latest()
    const written = this.#read()
    const { text } = this
    if (this.unkept || (written && written !== JSON.stringify(latest))) this.#save(latest)
    else this.#known = latest
    if (before === JSON.stringify([this.#known, this.unkept])) return
    this.#round = null
    this.changed(text === this.text ? this.said : "as you changed it in another tab")
  }

  /**
   * Take over texts, newest first, from before there were records, and whether one solved. Whether that is kept.
   *
   * @param {string[]} texts
   * @param {boolean} solved
   */
  adopt(texts, solved) {
    return this.take({ solved, versions: texts.map((text) => ({ id: this.#newId(), time: 0, text })) })
  }

  /**
   * Take over a record that was kept in another place. Whether it is kept here.
   *
   * @param {Known} record
   */
  take({ solved, versions }) {
    const latest = this.#latest()
    const taken = versions.map((version) => ({ ...version, text: version.text && withName(version.text) }))
    this.#save({ solved: latest.solved || solved, versions: inOrder([...taken, ...latest.versions]) })
    const isKept = !this.unkept
    this.unkept = "" // it still is where it was before
    return isKept
  }

  #newId() {
    return `${this.#browser.page}.${this.#browser.begun++}`
  }

  #read() {
    try {
      return this.#browser.storage().getItem(this.#key)
    } catch {
      return null
    }
  }

  /** The record that is kept, with what this page wrote at the same moment as another; if there is none, as known. */
  #latest() {
    const kept = parsed(this.#read())
    if (!kept) return this.#known
    const own = this.#known.versions.filter(({ id }) => id.startsWith(`${this.#browser.page}.`))
    return { solved: kept.solved || this.#known.solved, versions: inOrder([...kept.versions, ...own]) }
  }

  /** @param {Known} record */
  #save(record) {
    this.#known = record
    const versions = record.versions.filter(({ text }) => text === null || isText(text))
    try {
      this.#browser.storage().setItem(this.#key, JSON.stringify({ ...record, versions }))
      this.unkept = this.text === null || isText(this.text) ? "" : TOO_LONG
    } catch (error) {
      this.unkept = why(error)
    }
  }
}

/** The answers to all exercises of the site. */
export class Store {
  #before // what the keys of all answers begin with
  #old // what keys of earlier versions of the site begin with
  #browser
  /** @type {Map<string, Answer>} */
  #answers = new Map()

  /**
   * @param {string} root the path beneath which all pages of the site are
   * @param {Browser} browser its storage, which may throw, the time (ms), and a name that no other page has
   */
  constructor(root, { storage, now, page }) {
    this.#old = PREFIX + root
    this.#before = `${this.#old}:answer:`
    this.#browser = { storage, now, page, begun: 0 }
    this.#rename()
  }

  /**
   * The answer to an exercise. One in C++ is kept besides that in Python.
   *
   * @param {string} exercise
   */
  of(exercise, language = "python") {
    const id = language === "cpp" ? exercise + CPP : exercise
    const answer = this.#answers.get(id) ?? new Answer(this.#before + id, this.#browser)
    this.#answers.set(id, answer)
    return answer
  }

  /** Whether some text has solved an exercise, in whichever language. */
  isSolved(/** @type {string} */ exercise) {
    return ["python", "cpp"].some((language) => this.of(exercise, language).wasSolved)
  }

  /**
   * The answers to each exercise that was answered, the one that counts first: one that has solved it, or the newest.
   *
   * @returns {[exercise: string, Answer[]][]}
   */
  #answered() {
    const exercises = new Set([...this.#answers.keys()].map((id) => id.replace(CPP, "")))
    return [...exercises].map((exercise) => {
      const both = [exercise, exercise + CPP].flatMap((id) => this.#answers.get(id) ?? []).filter(({ text }) => text !== null)
      return [exercise, both.sort((one, other) => Number(other.solved) - Number(one.solved) || other.time - one.time)]
    })
  }

  /**
   * All answers, as pairs of an exercise and what was written: of two languages what counts.
   *
   * @returns {[id: string, text: string][]}
   */
  texts() {
    this.#rename()
    const ids = this.#ids()
    /** @type {[string, string | null][]} */
    const old = this.#oldTexts().map(({ id, text }) => [String(id), withName(text)])
    ids.forEach((id) => this.of(id))
    this.refresh()
    /** @type {[string, string | null][]} */
    const mine = this.#answered().map(([exercise, [answer]]) => [exercise, answer?.text ?? null])
    const has = new Set(mine.map(([id]) => id))
    return [...old.filter(([id]) => !has.has(id)), ...mine].flatMap(([id, text]) => (text === null ? [] : [[id, text]]))
  }

  /** The exercises that were solved with a text that is kept, but is not the newest one. */
  solvedBefore() {
    const better = [...this.#answers].filter(([, answer]) => answer.wasBetter).map(([id]) => id.replace(CPP, ""))
    const solved = new Set(this.#answered().flatMap(([exercise, [answer]]) => (answer?.solved ? [exercise] : [])))
    return [...new Set(better)].filter((exercise) => !solved.has(exercise))
  }

  /** See what other tabs have made of all answers. */
  refresh() {
    for (const answer of this.#answers.values()) answer.refresh()
  }

  /**
   * See what another tab has made of the answer under a key.
   *
   * @param {string} key
   */
  heard(key) {
    if (!key.startsWith(this.#before)) return
    this.#rename()
    this.#answers.get(key.slice(this.#before.length))?.refresh()
  }

  /** Give the answers to exercises that had numbers, as earlier versions of the site keep them, their names. */
  #rename() {
    for (const id of this.#ids()) {
      const [name, key] = [nameOf(id), this.#before + id]
      const record = name !== id && parsed(this.#browser.storage().getItem(key))
      if (record && this.of(name).take(record)) this.#browser.storage().removeItem(key)
    }
  }

  /**
   * Take over what earlier versions of the site kept of an exercise, first what belongs to its cell as it is now.
   *
   * @param {string} id
   * @param {string} fingerprint of that cell
   */
  adopt(id, fingerprint) {
    const isOfCell = (/** @type {string} */ key) => key.match(OLD)?.[1] === fingerprint
    const texts = this.#oldTexts(isOfCell).filter((old) => old.id === id || isOfCell(old.key))
    texts.sort((one, other) => Number(isOfCell(other.key)) - Number(isOfCell(one.key)))
    const keys = texts.map(({ key }) => key)
    const solved = this.#oldKeys().filter((key) => key.endsWith(":solved"))
    const ticks = solved.filter((key) => isOfCell(key) || keys.includes(key.replace(/:solved$/, "")))
    if (!keys.length && !ticks.length) return
    if (this.of(id).adopt(texts.map(({ text }) => text), ticks.length > 0)) {
      for (const key of [...keys, ...ticks]) this.#browser.storage().removeItem(key)
    }
  }

  #keys() {
    try {
      return Object.keys(this.#browser.storage())
    } catch {
      return [] // the reader does not let pages keep anything
    }
  }

  /** The exercises of which a record is kept. */
  #ids() {
    const keys = this.#keys().filter((key) => key.startsWith(this.#before) && key.length <= this.#before.length + READ.name)
    return keys.slice(0, READ.records).map((key) => key.slice(this.#before.length))
  }

  #oldKeys() {
    return this.#keys().filter((key) => key.startsWith(this.#old) && OLD.test(key)).slice(0, READ.records)
  }

  #oldTexts(isOfCell = (/** @type {string} */ _key) => false) {
    return this.#oldKeys()
      .filter((key) => !key.endsWith(":solved"))
      .map((key) => ({ key, text: this.#browser.storage().getItem(key) ?? "" }))
      .filter(({ text }) => isText(text))
      .map((old) => ({ ...old, id: named(old.text) }))
      .filter(({ key, id }) => id || isOfCell(key))
  }
}
