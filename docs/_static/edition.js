// A link that names an edition, as those of the home page do with "?ros=2", chooses it for the tabs of every later page.
// sphinx-design, which remembers tabs, heeds such a name only on pages that have these tabs themselves.
{
  const ros = new URLSearchParams(location.search).get("ros")
  try {
    if (ros) localStorage.setItem("sphinx-design-tab-id-ros", ros)
  } catch {
    // This browser stores nothing for us; the tabs can still be chosen by hand.
  }
}
