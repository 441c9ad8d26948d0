// Which exercises the reader has solved, kept by the reader's browser.

const KEY = "rosspin:solved"
let kept = [] // where nothing can be kept, as long as the page

/** The numbers of the exercises that have been solved. */
export function solved() {
  try {
    return JSON.parse(localStorage.getItem(KEY)) ?? kept
  } catch {
    return kept
  }
}

/** Note that an exercise has been solved. */
export function solve(number) {
  kept = [...new Set([...solved(), number])]
  try {
    localStorage.setItem(KEY, JSON.stringify(kept))
  } catch {
    // The reader does not let pages keep anything.
  }
}
