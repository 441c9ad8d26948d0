// A link that names an edition, as the home page's do with "?ros=2", chooses it for the tabs of every later page.
// sphinx-design, which remembers tabs, heeds such a name only on pages that have these tabs themselves. A link with
// "?path=evening" chooses a path, which the pages on it then say, and along which they lead.
{
  const asked = new URLSearchParams(location.search)
  const remembered = (name, key) => {
    const value = asked.get(name)
    try {
      if (value) localStorage.setItem(key, value)
      return value ?? localStorage.getItem(key)
    } catch {
      return value // This browser stores nothing for us; the tabs can still be chosen by hand.
    }
  }
  remembered("ros", "sphinx-design-tab-id-ros")
  const path = remembered("path", "rosspin:path")
  addEventListener("DOMContentLoaded", () => {
    const lines = [...document.querySelectorAll(".rosspin-path")]
    const own = lines.filter((line) => line.dataset.path === path)
    if (!own.length) return
    lines.forEach((line) => (line.hidden = !own.includes(line)))
    const [home, onward] = own.at(-1).querySelectorAll("a")
    const { previous, title } = own[0].dataset
    const back = document.querySelector(".left-prev")
    if (back) back.hidden = !previous
    if (back && previous) {
      back.href = previous
      back.querySelector(".prev-next-title").textContent = title
    }
    const [next, solved] = [".right-next", ".exercise-next a"].map((name) => document.querySelector(name))
    if (next) next.hidden = !onward
    if (solved) {
      solved.href = (onward ?? home).href
      solved.textContent = onward ? `Next: ${onward.textContent}` : `Finished: ${home.textContent}`
    }
    if (!next || !onward) return
    next.href = onward.href
    next.querySelector(".prev-next-title").textContent = onward.textContent
  })
}
