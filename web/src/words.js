// A command line in words, as a shell splits it.

const WORD = /((?:[^\s"'\\]|\\[^]|"(?:[^"\\]|\\[^])*"|'[^']*')+)|(\s+)|([^])/g

/**
 * The words of a text. Error: a quotation has no end, in words.
 *
 * @param {string} text
 */
export function split(text) {
  const words = []
  for (const [, word, , rest] of text.matchAll(WORD)) {
    if (rest) throw new Error(`arguments: no ${rest === "\\" ? "escaped character" : "closing quotation"}`)
    if (word) words.push(word.replace(/'([^']*)'|"((?:[^"\\]|\\[^])*)"|\\([^])/g, (_, plain, quoted, escaped) => plain ?? escaped ?? quoted.replace(/\\(["\\])/g, "$1")))
  }
  return words
}
