// Values as a program and its host exchange them (see runtime/host.cpp), in text of which each character is a byte. Integers
// are bigints; all other numbers are real.

/** The codes of a terminal for colours, which roscpp prints wherever it runs, and no page shows. */
export const COLOURS = /\x1b\[[\d;]*m/g

export class Bytes {
  constructor(text) {
    this.text = text
  }
}

export function packed(value) {
  if (value === null || value === undefined) return "n"
  if (value instanceof Bytes) return `b${value.text.length}:${value.text}`
  if (Array.isArray(value)) return `l${value.map(packed).join("")}e`
  switch (typeof value) {
    case "boolean":
      return value ? "t" : "f"
    case "bigint":
      return `i${value};`
    case "number":
      return `d${String(value).replace("Infinity", "inf").replace("NaN", "nan")};`
    case "string":
      return `s${value.length}:${value}`
    default:
      return `m${Object.entries(value).flat().map(packed).join("")}e`
  }
}

/** Read all values of a text. */
export function unpacked(text) {
  let at = 0
  const until = (end) => {
    const from = at
    at = text.indexOf(end, from) + 1
    return text.slice(from, at - 1)
  }
  const list = () => {
    const items = []
    while (text[at] !== "e") items.push(read())
    at++
    return items
  }
  const read = () => {
    const kind = text[at++]
    if (kind === "n") return null
    if (kind === "t" || kind === "f") return kind === "t"
    if (kind === "i") return BigInt(until(";"))
    if (kind === "d") return Number(until(";").replace("inf", "Infinity"))
    if (kind === "l") return list()
    if (kind === "m") {
      const items = list()
      const pairs = items.flatMap((name, place) => (place % 2 ? [] : [[name, items[place + 1]]]))
      return Object.fromEntries(pairs)
    }
    const length = Number(until(":"))
    const content = text.slice(at, (at += length))
    return kind === "b" ? new Bytes(content) : content
  }
  const values = []
  while (at < text.length) values.push(read())
  return values
}
