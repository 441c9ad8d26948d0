// What the worker of C++ in a page says of jobs, without a page: node programs_in_page.mjs, with the jobs as JSON on standard
// input, `program` the file of each one's. A line of JSON for each job: all that it says.

import { readFileSync } from "node:fs"

let hear
let said = []
globalThis.addEventListener = (_kind, listener) => (hear = listener)
globalThis.postMessage = (text) => said.push(JSON.parse(text))
await import("../../web/src/cpp.js")
for (const { program, ...job } of JSON.parse(readFileSync(0, "utf8"))) {
  said = []
  await hear({ data: { kind: "cpp", bytes: readFileSync(program), ...job } })
  process.stdout.write(`${JSON.stringify(said)}\n`)
}
process.exit()
