// What the compiler says of a node in C++, as places in it; the first of these explained, where it is one of the mistakes that
// are made most.

/** @typedef {{line: number, column: number, text: string}} Fault in a listing, counted from 1 */

/**
 * The errors in a node that the compiler has named.
 *
 * @param {string} said
 * @param {string} filename
 * @returns {Fault[]}
 */
export function faults(said, filename) {
  /** @type {Fault[]} */
  const found = []
  let text = "" // of an error in a header, until its place in the node is named
  for (const line of said.split("\n")) {
    const [, file, at, column, kind, what] = line.match(/^(.*?):(\d+):(\d+): (?:fatal )?(error|note): (.*)$/) ?? []
    if (kind === "error") text = what
    const lambda = kind === "error" && file !== filename ? what.split("(lambda at ")[1]?.split(")")[0].split(":") : undefined
    const [where, number, place] = lambda ?? [file, at, column]
    if (!text || where !== filename) continue
    found.push({ line: Number(number), column: Number(place), text })
    text = ""
  }
  return found
}

/**
 * What the first error means; "" if that is none of those.
 *
 * @param {string} said
 */
export function advice(said) {
  const [, first = ""] = said.split(/^.*:\d+: (?:fatal )?error: /m) // with the notes on it
  return RULES.cpp.advice.find(([pattern]) => new RegExp(pattern).test(first))?.[1] ?? ""
}
