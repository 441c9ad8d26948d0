// What a reader has written in place of a listing, as the browser keeps it.

/** Before the keys of all that the site keeps. */
export const PREFIX = "rosspin:"

/**
 * Why the browser does not keep something, in words.
 *
 * @param {unknown} error what it has thrown
 */
export const why = (error) =>
  /quota/i.test(/** @type {Error} */ (error).name) ? "the browser's storage is full" : "this browser keeps nothing here"

/** No text is longer (characters) that is kept: a page would take long to show it. */
export const LONGEST = 100_000

/** Why a longer one is not kept. */
export const TOO_LONG = `it has more than ${LONGEST.toLocaleString("en-GB")} characters`

/**
 * Whether a text, or whatever else was found in its place, can be shown.
 *
 * @param {unknown} text
 * @returns {text is string}
 */
export const isText = (text) => typeof text === "string" && text.length <= LONGEST

/**
 * A short text that differs when the given one does (FNV-1a).
 *
 * @param {string} text
 */
export function fingerprint(text) {
  let hash = 0x811c9dc5
  for (const character of text) hash = Math.imul(hash ^ /** @type {number} */ (character.codePointAt(0)), 0x01000193)
  return (hash >>> 0).toString(16)
}

/**
 * What a cell shows, kept by the browser or not.
 *
 * @typedef {object} Keeping
 * @property {string | null} text what the reader wrote; null if the listing is as it comes with its page
 * @property {string} said what there is to say of it
 * @property {string} unkept why the browser does not keep it, in words; "" if it does
 * @property {(text: string | null) => boolean} write keep a text, or with null that the listing was reset; whether there is
 *   news to say
 * @property {(text: string | null) => string | void} [solve] hear that a text has solved the exercise; what to say of that
 *   in place of the count
 * @property {boolean} [hasEarlier] whether there is another text to bring back
 * @property {() => string} [bringBack] bring it back; what there is to say of it
 * @property {(said: string) => void} [changed] called when another tab has changed it
 */

/**
 * The text of a listing that is no exercise, at its place on its page. Exercises have store.js.
 *
 * @implements {Keeping}
 */
export class Kept {
  #key

  /** @type {string | null} */
  text = null

  unkept = ""

  /** @type {string | null} */
  #before = null // the last reset, until the page is left

  /**
   * @param {string} place of the listing: its page, and its number there
   * @param {string} original
   */
  constructor(place, original) {
    this.#key = `${PREFIX}${place}:${fingerprint(original)}`
    try {
      const kept = localStorage.getItem(this.#key)
      if (isText(kept)) this.text = kept
    } catch {
      // the reader does not let pages keep anything
    }
  }

  get said() {
    return this.text === null ? "" : "as you edited it"
  }

  get hasEarlier() {
    return this.text === null && this.#before !== null
  }

  /** Bring back what was there before the reset. What there is to say of it. */
  bringBack() {
    this.write(this.#before)
    return this.said
  }

  /**
   * Keep what the reader has written, or with null that the listing was reset. Whether `unkept` is another now.
   *
   * @param {string | null} text
   */
  write(text) {
    const { unkept } = this
    if (text === null) this.#before = this.text ?? this.#before
    this.text = text
    try {
      if (text === null) localStorage.removeItem(this.#key)
      else if (isText(text)) localStorage.setItem(this.#key, text)
      this.unkept = text === null || isText(text) ? "" : TOO_LONG
    } catch (error) {
      this.unkept = text === null ? "" : why(error)
    }
    return unkept !== this.unkept
  }
}
