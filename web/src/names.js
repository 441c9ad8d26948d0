// The names by which answers are kept, handed in and judged; numbers are only shown. Records kept by older versions of
// the site use numbers.

/** The first line of an answer, which names the exercise. */
const FIRST_LINE = /^%%answer[ \t]+(\S+)[^\n]*(?:\n|$)/

/**
 * The name of an exercise that is known by that, or by its old number.
 *
 * @param {string} known
 */
export const nameOf = (known) => RULES.numbered[Number(known) - 1] ?? known

/** The number of an exercise, as it is shown now; its name if there is no such exercise. */
export const numberOf = (/** @type {string} */ name) => String(EXERCISES[name]?.number ?? name)

/**
 * The exercise that the first line of a text names; undefined if it names none.
 *
 * @param {string} text
 */
export function named(text) {
  const known = text.match(FIRST_LINE)?.[1]
  return known && nameOf(known)
}

/**
 * An answer whose first line has a name, where it had a number.
 *
 * @param {string} text
 */
export const withName = (text) => text.replace(/^%%answer (\d+)\n/, (_, number) => `%%answer ${nameOf(number)}\n`)

/**
 * An answer as it was before its exercise had a name.
 *
 * @param {string} text
 */
export const withNumber = (text) => text.replace(FIRST_LINE, (_, name) => `%%answer ${RULES.numbered.indexOf(name) + 1}\n`)
