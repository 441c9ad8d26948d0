// Which exercises are solved, said on their list, on their pages, and next to each link to a list.

import { find, make } from "./make.js"

/** @type {Set<string>} the exercises of the page, and of the list that they are on */
export const exercises = new Set()

const isSolved = (/** @type {string} */ name) => window.rosspinStore?.isSolved(name) === true

/** How many of them are solved. */
export const progress = () => `${[...exercises].filter(isSolved).length} of ${exercises.size}`

/** Under this and the path of a page, how many of its exercises are solved. */
const PROGRESS = "rosspin:progress:"

/**
 * Say on a list of exercises, and on their pages, which are solved, and how many; the latter on every page, too, next to
 * the links to such lists. What leads on from an exercise is shown once that is solved.
 */
export function showProgress() {
  document.querySelectorAll(".live-progress").forEach((element) => element.remove())
  /** @type {NodeListOf<HTMLAnchorElement>} */
  const listed = document.querySelectorAll("[data-exercise]:not(.exercise-next *)")
  for (const { classList, dataset: { exercise = "" } } of listed) {
    exercises.add(exercise)
    classList.toggle("is-solved", isSolved(exercise))
  }
  /** @type {HTMLElement | null} */
  const next = document.querySelector(".exercise-next")
  if (next) next.hidden = !document.querySelector(".exercise-way [aria-current].is-solved")
  try {
    if (exercises.size) {
      /** @type {HTMLAnchorElement | null} */
      const list = document.querySelector(".exercise-way p a")
      const { pathname } = list ?? location
      localStorage.setItem(PROGRESS + pathname, `${progress()} solved`)
      sayProgress(list?.parentElement ?? find("article h1"), pathname)
    }
    /** @type {NodeListOf<HTMLAnchorElement>} */
    const links = document.querySelectorAll('.bd-docs-nav a[href$="exercises.html"], .bd-docs-nav a[aria-current]')
    links.forEach((link) => sayProgress(link, link.pathname))
  } catch {
    // the reader does not let pages keep anything
  }
}

/**
 * Say next to an element how many exercises of a page are solved, if that is known.
 *
 * @param {HTMLElement} place
 * @param {string} page
 */
function sayProgress(place, page) {
  const said = localStorage.getItem(PROGRESS + page) ?? ""
  if (/^\d{1,3} of \d{1,3} solved$/.test(said)) place.after(make("p", { className: "live-progress", textContent: said }))
}
