// The names by which answers are kept, handed in and judged; numbers are only shown. Records kept by older versions of
// the site use numbers.

/** The exercises that had numbers before they had names, in that order: from 1 on. This list never changes. */
const NUMBERED = [
  ..."first-ticks after-a-slow-callback cpp-ticks ten-hertz fire-once stop-after-five loop-to-timer".split(" "),
  ..."frequency-parameter two-rates survive-an-overrun share-data stop-the-motor missing-ticks".split(" "),
  ..."name-the-fault what-is-heard publish-the-counter late-subscriber newest-position rostopic-hz".split(" "),
  ..."slow-timer call-back-once period-parameter move-to-ros-2 starving-neighbour wake-a-rate".split(" "),
  ..."end-without-a-traceback ask-without-hanging let-a-callback-wait slow-service cancel-a-goal".split(" "),
]

/** The first line of an answer, which names the exercise. */
const FIRST_LINE = /^%%answer[ \t]+(\S+)[^\n]*(?:\n|$)/

/**
 * The name of an exercise that is known by that, or by its old number.
 *
 * @param {string} known
 */
export const nameOf = (known) => NUMBERED[Number(known) - 1] ?? known

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
export const withNumber = (text) => text.replace(FIRST_LINE, (_, name) => `%%answer ${NUMBERED.indexOf(name) + 1}\n`)

/**
 * What of an answer is checked, in the same lines: its first line is not, if it begins with %%, and need not be there.
 *
 * @param {string} text
 */
export const code = (text) => (text.startsWith("%%") ? `\n${text.split("\n").slice(1).join("\n")}` : text)
