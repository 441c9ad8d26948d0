// How the search of the site ranks what it finds: first the pages from which one learns, then those to look things up in.
const LATER = /^(docs\/(slides|reference|for-teachers|accessibility|architecture|status|paths|differences)|notebooks\/(ros2-)?exercises)/

// What Sphinx's own has, but for `score`; a result is [page, title, anchor, description, score, file, kind].
var Scorer = {
  score: ([page, , , , score, , kind]) =>
    score - (LATER.test(page) ? 20 : 0) - (kind === "object" ? 30 : 0) + (page.includes("ros2") ? 1 : 0),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
}
