// Code that someone else wrote shows what would not be seen: characters that have no look or turn the direction of a text,
// and what is far to the right.

import { make } from "./make.js"

/** Characters that are not seen: controls, format characters such as marks of direction, and letters that are blank. */
export const UNSEEN = /[\p{Cf}\p{Zl}\p{Zp}\u115f\u1160\u3164\uffa0]|(?![\t\n\r])\p{Cc}/gu

/** A line that is longer (characters) is wrapped. */
const LONG = 150

/**
 * The sign of such a character, as in "U+202E".
 *
 * @param {string} character
 */
export const sign = (character) => `U+${Number(character.codePointAt(0)).toString(16).toUpperCase().padStart(4, "0")}`

/**
 * What to show of a text: `pre`, an element whose textContent it is, and what should be `said` of it, maybe nothing. Its
 * `pieces` are that text, each with the class of its colour.
 *
 * @param {string} text
 * @param {[piece: string, colour: string][]} pieces
 */
export function reveal(text, pieces = [[text, ""]]) {
  const pre = make("pre")
  let found = 0
  for (const [piece, className] of pieces) {
    const span = make("span", { className })
    let from = 0
    for (const { 0: character, index } of piece.matchAll(UNSEEN)) {
      const mark = make("span", { className: "unseen" }, character)
      mark.dataset.sign = sign(character)
      span.append(piece.slice(from, index), mark)
      from = index + character.length
      found++
    }
    span.append(piece.slice(from))
    pre.append(...(className ? [span] : span.childNodes))
  }
  const isLong = text.split("\n").some((line) => line.length > LONG)
  if (isLong) pre.className = "wraps"
  const said = [
    found && "It has characters that are not seen or that turn the direction of the text: they are marked.",
    isLong && "Its long lines are wrapped.",
  ]
  return { pre, said: said.filter(Boolean).join(" ") }
}
