// The pages that the search of a built site finds, best first: node search.mjs SITE QUERY...
import { readFileSync } from "node:fs"
import { runInNewContext } from "node:vm"

const [site, ...queries] = process.argv.slice(2)
const page = { addEventListener() {}, getElementById: () => null, readyState: "loading" }
const context = { document: page, queries, SPHINX_HIGHLIGHT_ENABLED: false, _: (text) => text, _ready() {} }
context.window = context
const scripts = ["language_data.js", "searchtools.js"].map((name) => `_static/${name}`)
const text = [...scripts, "searchindex.js"].map((name) => readFileSync(`${site}/${name}`, "utf8")).join("\n")
const found = runInNewContext(
  `${text}\n;queries.map((query) => Search._performSearch(...Search._parseQuery(query)).reverse().map(([name]) => name))`,
  context,
)
console.log(JSON.stringify(Object.fromEntries(queries.map((query, at) => [query, [...new Set(found[at])]]))))
