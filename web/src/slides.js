// A page as slides. "?slides" in its address shows it section by section, "?slides=notes" shows the notes in a window of
// the speaker's own; the two follow each other. No key is a letter, which someone who speaks to the computer could not
// keep from being pressed.

import { find, make } from "./make.js"

const asked = new URLSearchParams(location.search).get("slides")
const root = find("article section")

/** What the keys do that clickers send, too, and those that a field or a handle may need itself. */
const PAGES = new Map([["PageDown", 1], ["PageUp", -1]])
const ARROWS = new Map([["ArrowRight", 1], ["ArrowLeft", -1], ["Home", -Infinity], ["End", Infinity]])

/** @param {string} textContent @param {() => void} onclick */
const button = (textContent, onclick) => make("button", { type: "button", textContent, onclick })

function begin() {
  const first = make("div", { className: "slide", id: root.id })
  root.removeAttribute("id")
  root.prepend(first)
  first.append(...[...root.children].filter((part) => part !== first && part.tagName !== "SECTION"))
  const slides = [first, .../** @type {HTMLElement[]} */ ([...root.children].slice(1))]
  const titles = slides.map((slide) => titleOf(find("h1, h2", slide)))
  const minutes = slides.map((slide) => Number(slide.querySelector("[data-minutes]")?.getAttribute("data-minutes") ?? 0))
  const channel = new BroadcastChannel(`slides ${location.pathname}`)
  document.documentElement.classList.add("slides", ...(asked === "notes" ? ["speaker"] : []))

  let now = 0
  let moved = false
  let started = Date.now()
  const place = make("output", {})
  const next = make("p", { className: "slides-next" })
  const list = make("ol", {})
  const contents = make("dialog", { ariaLabel: "Contents" })
  const bar = make("nav", { className: "slides-bar", ariaLabel: "Slides" })

  /** @param {number} number */
  function show(number, tell = true) {
    now = Math.min(Math.max(number, 0), slides.length - 1)
    slides.forEach((slide, index) => slide.classList.toggle("now", index === now))
    place.textContent = `${now + 1} of ${slides.length}`
    next.textContent = now + 1 < slides.length ? `Next: ${titles[now + 1]}` : "The last slide"
    history.replaceState(null, "", `#${slides[now].id}`)
    slides[now].focus()
    // As the theme does with what it sees when the page comes: what scrolls can be reached by Tab.
    // A long listing begins with the lines that are marked.
    for (const box of slides[now].querySelectorAll("pre")) {
      const marked = box.querySelector(".hll")
      if (marked) box.scrollTop += marked.getBoundingClientRect().top - box.getBoundingClientRect().top
      box.tabIndex = box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight ? 0 : -1
    }
    tellTime()
    if (tell) {
      moved = true
      channel.postMessage(now)
    }
  }

  const clock = make("p", { className: "slides-clock" })
  function tellTime() {
    const sum = (/** @type {number} */ end) => minutes.slice(0, end).reduce((total, one) => total + one, 0)
    const gone = Math.floor((Date.now() - started) / 60_000)
    clock.textContent = `${gone} min gone; this slide: ${sum(now)} to ${sum(now + 1)} of ${sum(slides.length)} min`
  }

  const fromHash = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)))
    return Math.max(0, slides.findIndex((slide) => target && slide.contains(target)))
  }

  for (const [index, title] of titles.entries()) {
    const item = make("li", {})
    item.append(button(title, () => {
      contents.close()
      show(index)
    }))
    list.append(item)
  }
  contents.append(list, button("Close", () => contents.close()))
  slides.forEach((slide) => (slide.tabIndex = -1))
  bar.append(button("Previous", () => show(now - 1)), place, button("Next", () => show(now + 1)))
  bar.append(button("Contents", () => contents.showModal()))
  if (asked === "notes") {
    bar.append(button("Clock to 0", () => {
      started = Date.now()
      tellTime()
    }))
    root.append(next, clock)
    setInterval(tellTime, 1000)
  } else {
    bar.append(button("Notes", () => void open(`?slides=notes${location.hash}`, "_blank", "popup,width=800,height=600")))
    const leave = make("a", { textContent: "Leave" })
    leave.href = location.pathname
    bar.append(leave)
  }
  root.append(bar, contents)

  addEventListener("keydown", (event) => {
    const at = /** @type {Element} */ (event.target)
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey || contents.open) return
    if (at.closest(".cm-editor, textarea")) return
    const step = PAGES.get(event.key) ?? (at.closest("input, select, [role=slider]") ? undefined : ARROWS.get(event.key))
    if (step === undefined) return
    event.preventDefault()
    show(now + step)
  })
  // A window that has just come asks where the other one is. What has led meanwhile is newer than the answer.
  channel.onmessage = ({ data }) => {
    if (data === "where?") channel.postMessage({ answer: now })
    else if (!moved || data.answer === undefined) show(data.answer ?? data, false)
  }
  addEventListener("hashchange", () => show(fromHash()))
  addEventListener("beforeprint", () => slides.forEach((slide) => slide.classList.add("now")))
  addEventListener("afterprint", () => show(now, false))
  show(fromHash(), false)
  channel.postMessage("where?")
}

/** @param {Element} heading */
function titleOf(heading) {
  return [...heading.childNodes].filter((part) => !(part instanceof HTMLAnchorElement && part.matches(".headerlink")))
    .map((part) => part.textContent).join("").trim()
}

if (asked === null) {
  const link = make("a", { textContent: "Show as slides" })
  link.href = "?slides"
  const line = make("p", {})
  line.append(link, "; page keys, arrow keys or a clicker move forwards and back, F11 fills the screen, Notes opens a window for you.")
  find("h1", root).after(line)
} else begin()
