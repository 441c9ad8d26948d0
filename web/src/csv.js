// A table as a text that spreadsheets read.

/**
 * Where a cell might begin with the sign of a formula, whatever separates cells where the file is opened: at the start,
 * or after a separator in the middle. Spaces, quotes and what is not seen may stand before the sign, and signs may be
 * full-width, small, raised or lowered.
 */
const FORMULA = /(?<=^|[,;|；，])([\s"\p{C}\p{DI}\p{Z}]*)(?=[=＝﹦⁼₌+＋﹢⁺₊\-－﹣−⁻₋@＠﹫])/gu

/**
 * Rows of cells, as CSV. No cell is a formula, nor any part of one.
 *
 * @param {(string | number)[][]} rows
 */
export function csv(rows) {
  // With a byte order mark, without which Excel reads no UTF-8.
  return `\ufeff${rows.map((row) => `${row.map(field).join(",")}\r\n`).join("")}`
}

/** @param {string | number} value */
function field(value) {
  const line = String(value).replace(/[\p{Cc}\p{Zl}\p{Zp}]+/gu, " ")
  return `"${line.replace(FORMULA, "$1'").replaceAll('"', '""')}"`
}
