// What the compiler says of a node in C++, as places in it; the first of these explained, where it is one of the mistakes that
// are made most. See cpp/faults.py.

/** @typedef {{line: number, column: number, text: string}} Fault in a listing, counted from 1 */

/** What it says in one line, and of a warning the group. */
const SAID = /^(.*?):(\d+):(\d+): (?:fatal )?(error|warning|note): (.*?)(?: \[-W([\w+-]+)\])?$/

/**
 * What is shown of it: no warning that need not be of a fault, and no note that does not help.
 *
 * @param {string} said
 */
export function shown(said) {
  let [whole, part] = [true, true] // whether what is said of a place is shown, and this part of it
  const lines = said.replace(/^\d+ warnings? (generated\.\n|and )/gm, "").split(/^/m)
  return lines.filter((line) => {
    const [, , , , kind, what, group] = line.trimEnd().match(SAID) ?? []
    if (kind === "error" || kind === "warning") whole = kind === "error" || (RULES.cpp.warnings.includes(group) && !new RegExp(RULES.cpp.lengths).test(what))
    if (kind) part = whole && !(kind === "note" && new RegExp(RULES.cpp.notes).test(what))
    else if (new RegExp(`^(${RULES.cpp.ofNoPlace})`).test(line)) whole = part = true
    return part
  }).join("")
}

/**
 * The places in a node that the compiler has named, with what is wrong there.
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
    const [, file, at, column, kind, what] = line.match(SAID) ?? []
    if (kind === "error" || kind === "warning") text = what
    const lambda = kind === "error" && file !== filename ? what.split("(lambda at ")[1]?.split(")")[0].split(":") : undefined
    const [where, number, place] = lambda ?? [file, at, column]
    if (!text || where !== filename) continue
    found.push({ line: Number(number), column: Number(place), text })
    text = ""
  }
  return found
}

/**
 * What the first error means, if there is none the first warning; "" if that is none of those.
 *
 * @param {string} said
 */
export function advice(said) {
  const parts = said.split(/^(?=.*:\d+: (?:fatal )?(?:error|warning): )/m) // each with the notes on it
  const [warning, error] = [/:\d+: warning: /, /:\d+: (?:fatal )?error: /].map((sign) => parts.find((part) => sign.test(part)))
  const first = error ?? warning ?? ""
  return RULES.cpp.advice.find(([pattern]) => new RegExp(pattern).test(first))?.[1] ?? ""
}
