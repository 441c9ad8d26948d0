// What a reader has written in place of a listing, as the browser keeps it.

/** Before the keys of all that the site keeps. */
export const PREFIX = "rosspin:"

/** Why the browser does not keep something, in words. */
export const why = ({ name }) =>
  /quota/i.test(name) ? "the browser's storage is full" : "this browser keeps nothing here"

/** A short text that differs when the given one does (FNV-1a). */
export function fingerprint(text) {
  let hash = 0x811c9dc5
  for (const character of text) hash = Math.imul(hash ^ character.codePointAt(0), 0x01000193)
  return (hash >>> 0).toString(16)
}

/** The text of a listing that is no exercise, at its place on its page. Exercises have store.js. */
export class Kept {
  #key

  /** What the reader wrote; null if the listing stands as it comes with its page. */
  text = null

  /** Why the browser does not keep it, in words; "" if it does. */
  unkept = ""

  constructor(place, original) {
    this.#key = `${PREFIX}${place}:${fingerprint(original)}`
    try {
      this.text = localStorage.getItem(this.#key)
    } catch {
      // the reader does not let pages keep anything
    }
  }

  /** What there is to say of it. */
  get said() {
    return this.text === null ? "" : "as you edited it"
  }

  /** Keep what the reader has written, or with null that the listing was reset. Whether `unkept` is another now. */
  write(text) {
    const { unkept } = this
    this.text = text
    try {
      if (text === null) localStorage.removeItem(this.#key)
      else localStorage.setItem(this.#key, text)
      this.unkept = ""
    } catch (error) {
      this.unkept = text === null ? "" : why(error)
    }
    return unkept !== this.unkept
  }
}
