// Builds what runs in the reader's page: node build.mjs PACKAGES YAML OUT RULES, from web/src, src/rosspin, lessons, the npm
// packages in the folder PACKAGES and PyYAML, whose package is the folder YAML, into the folder OUT. RULES are the constants
// that Python has, too, as JSON: see rosspin/site/rules.py.

import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from "node:fs"
import { createHash } from "node:crypto"
import { createRequire } from "node:module"
import path from "node:path"
import { constants, zstdCompressSync, zstdDecompressSync } from "node:zlib"

import { snapshot } from "./snapshot.mjs"

const here = import.meta.dirname
const [packages, yaml, out] = process.argv.slice(2, 5).map((folder) => path.resolve(folder))
const rules = Object.fromEntries(leaves("", JSON.parse(process.argv[5])))
const pyodide = path.join(packages, "node_modules/pyodide")
const require = createRequire(path.join(packages, "package.json"))
const { build } = require("esbuild")
const { zipSync } = require("fflate")

/** What esbuild puts in place of the constants in an object, each by its own name: a script has those that it uses. */
function leaves(name, value) {
  const isGroup = name !== "EXERCISES" && typeof value === "object" && !Array.isArray(value)
  if (!isGroup) return [[name, JSON.stringify(value)]]
  return Object.entries(value).flatMap(([part, inner]) => leaves(name ? `${name}.${part}` : part, inner))
}

/** Write a file that is there as a whole or not at all: what is left of a disk that is full is not taken for it. */
function writeWhole(file, content) {
  const part = `${file}.part`
  writeFileSync(part, content)
  renameSync(part, file)
}

const sha256 = (content, form = "hex") => createHash("sha256").update(content).digest(form)

const folders = ["hand-in", "handles", "look", "slides", "stepper"]
for (const folder of [out, ...folders.map((name) => path.join(out, "..", name))]) {
  rmSync(folder, { recursive: true, force: true })
}
mkdirSync(out, { recursive: true })

const common = {
  bundle: true,
  minify: true,
  target: "es2022",
  outdir: out,
  nodePaths: [path.join(packages, "node_modules")],
  metafile: true,
  logLevel: "warning",
}
// Loaded with each page that has a figure to move, for that alone.
const moving = ["handles.js", "vehicle.js"].map((name) => path.join(here, "src", name))
await build({ ...common, define: rules, outdir: path.join(out, "../handles"), entryPoints: moving })
// Likewise where a run can be gone through step by step.
const stepping = ["steps.js", "stepper.css"].map((name) => path.join(here, "src", name))
await build({
  ...common,
  define: { ...rules, "import.meta.url": '""' }, // the latter for the part of stepper.js that live.js loads as a module
  outdir: path.join(out, "../stepper"),
  entryPoints: stepping,
})
// And where a page can be shown as slides.
const showing = ["slides.js", "slides.css"].map((name) => path.join(here, "src", name))
await build({ ...common, outdir: path.join(out, "../slides"), entryPoints: showing })
for (const name of ["pyodide.asm.wasm", "python_stdlib.zip"]) {
  cpSync(path.join(pyodide, name), path.join(out, name))
}

/** A module whose docstrings are empty: no page shows them, and the memory of a snapshot is bounded. Each line stays where it is. */
function withoutDocstrings(text) {
  return text.replace(/(^|:\n)( *)"""(?:(?!""")[^])*"""(?=\n)/g, (all, before, indent) => {
    const lines = all.slice(before.length).split("\n").length
    return `${before}${indent}""${"\n".repeat(lines - 1)}`
  })
}

// The stand-in, without what only Sphinx, Jupyter, matplotlib and bags need, and the one package that it needs: path -> bytes.
const files = {}
for (const folder of [path.join(here, "../src/rosspin"), yaml]) {
  for (const file of readdirSync(folder, { recursive: true }).sort()) {
    const name = file.split(path.sep).join("/")
    if (!/\.(py|txt)$/.test(name) || /^(cpp|faults|grading|orders|plots|real|site)\/|^look\/bags/.test(name)) continue
    files[`${path.basename(folder)}/${name}`] = Buffer.from(withoutDocstrings(readFileSync(path.join(folder, file), "utf8")))
  }
}
const lessons = path.join(here, "../lessons")
for (const name of existsSync(lessons) ? readdirSync(lessons).sort() : []) {
  if (name.endsWith(".py")) files[`rosspin/exercises/own/${name}`] = readFileSync(path.join(lessons, name))
}
// The answers come last, and are no one's business there. What the pages show of an exercise would only take memory.
for (const name of Object.keys(files).filter((name) => name.startsWith("rosspin/exercises/own/"))) {
  let text = files[name].toString().replace(/^(SOLUTION|RIGHT) = [^]*$/m, "RIGHT = WRONG = ()\n")
  text = text.replace(/^TEXT = ("""|''')[^]*?\1$/m, "").replace(/^REVEALS = (".*"|\([^]*?^\))$/m, "")
  files[name] = Buffer.from(/^HINT = /m.test(text) ? text.replace(/^(HINTS\w*) = \[[^]*?\]$/gm, "$1 = ()") : text)
}
writeFileSync(path.join(out, "rosspin.zip"), zipSync(files, { level: 9, mtime: new Date(1980, 0) }))

// The snapshot: rebuilt only when what is in it changes, which is also when readers need to load it again.
const inputs = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip"]
  .map((name) => path.join(pyodide, name))
  .concat(path.join(out, "rosspin.zip"))
  .concat(["snapshot.mjs", "snapshot.py", "src/memory.js", "src/start.js"].map((name) => path.join(here, name)))
const hash = createHash("sha256").update(process.version)
inputs.forEach((file) => hash.update(readFileSync(file)))
const made = hash.digest("hex").slice(0, 16)
function isWhole(file) {
  try {
    return zstdDecompressSync(readFileSync(file)).length > 0 // which has a checksum
  } catch {
    return false
  }
}
const keeping = path.join(out, "../..")
const kept = path.join(keeping, `snapshot-${made}.zst`)
for (const name of readdirSync(keeping)) {
  if (/^snapshot-.*\.(gz|zst)(\.part)?$/.test(name) && path.join(keeping, name) !== kept) rmSync(path.join(keeping, name))
}
if (!isWhole(kept)) {
  const { info } = JSON.parse(readFileSync(path.join(pyodide, "pyodide-lock.json"), "utf8"))
  const params = { [constants.ZSTD_c_compressionLevel]: 17, [constants.ZSTD_c_checksumFlag]: 1 }
  writeWhole(kept, zstdCompressSync(await snapshot(pyodide, path.join(out, "rosspin.zip"), info), { params }))
}
cpSync(kept, path.join(out, "snapshot.zst"))

// What runs in a sandbox: its workers, each of which is all one text, and its page, which has no address to load from, not even its
// own script. "blob:" is what it is sent.
await build({
  ...common,
  external: ["node:*", "ws"], // of which Pyodide has no need here
  define: { "import.meta.url": JSON.stringify("memory:/") }, // where it believes that its files are
  entryPoints: [path.join(here, "src/worker.js")],
})
const working = ["cpp.js", "clang.js", "unpack.js"].map((name) => path.join(here, "src", name))
const { metafile: ofWorkers } = await build({ ...common, entryPoints: working })
const { outputFiles } = await build({ ...common, write: false, entryPoints: [path.join(here, "src/sandbox.js")] })
const script = outputFiles[0].text
const policy = `default-src 'none'; script-src 'sha256-${sha256(script, "base64")}' blob: 'wasm-unsafe-eval'`
writeFileSync(
  path.join(out, "sandbox.html"),
  `<!doctype html>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>Sandbox</title>
<script>${script}</script>
`,
)

// Loaded when a listing is touched, or an answer judged. What runs code knows each file that it starts from.
const sealed = ["pyodide.asm.wasm", "python_stdlib.zip", "rosspin.zip", "snapshot.zst"]
  .concat(["sandbox.html", "worker.js", "cpp.js", "clang.js", "unpack.js"])
  .map((name) => [name, sha256(readFileSync(path.join(out, name)))])
const { metafile } = await build({
  ...common,
  format: "esm",
  define: { FILES: JSON.stringify(Object.fromEntries(sealed)), ...rules },
  external: ["./compiled.js", "./drive.js", "./sha256.js"],
  entryPoints: ["compiled.js", "drive.js", "editor.js", "runs.js", "sha256.js", "share.js", "stepper.js"].map((name) => path.join(here, "src", name)),
})
const version = JSON.stringify(sha256(readFileSync(path.join(out, "runs.js"))).slice(0, 16))

// Loaded with the pages of exercises and with that for teachers.
await build({
  ...common,
  outdir: path.join(out, "../hand-in"),
  define: { RUNS: version, ...rules },
  entryPoints: ["hand-in.js", "hand-in.css", "judge.js"].map((name) => path.join(here, "src", name)),
})
// Loaded with the page that looks at logs, with some to try.
const looking = path.join(out, "../look")
await build({
  ...common,
  outdir: looking,
  define: { RUNS: version, ...rules },
  entryPoints: ["look.js", "look.css"].map((name) => path.join(here, "src", name)),
})
for (const name of ["r2_timer_10.log", "r2_sleep_10_work_5.log", "r2_blocks_two.log"]) {
  cpSync(path.join(here, "../tests/look/recorded", name), path.join(looking, "examples", name))
}

// Loaded with the page, as a classic script: a page opened from a file has no modules, and has to say so.
const live = await build({
  ...common,
  define: { RUNS: version, ...rules },
  entryPoints: ["live.js", "live.css"].map((name) => path.join(here, "src", name)),
  write: false,
})

// What is bundled keeps its licence.
const used = new Set(["pyodide"])
for (const file of Object.keys({ ...metafile.inputs, ...ofWorkers.inputs })) {
  const found = file.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)
  if (found) used.add(found[1])
}
const licences = [...used].sort().map((name) => {
  const folder = path.join(packages, "node_modules", name)
  const { version, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"))
  const own = path.join(folder, "LICENSE")
  const file = existsSync(own) ? own : path.join(here, `licences/${license}.txt`)
  return `${name} ${version}: ${license}\n\n${readFileSync(file, "utf8")}`
})
// Pyodide is CPython, compiled, with its standard library.
licences.push(`Python: PSF-2.0\n\n${readFileSync(path.join(here, "licences/PSF-2.0.txt"), "utf8")}`)
// The compiler is LLVM, with its C++ library, which programs contain, too, and a C library, which comes from musl.
licences.push(`LLVM: Apache-2.0\n\n${readFileSync(path.join(here, "licences/Apache-2.0.txt"), "utf8")}`)
licences.push(`musl: MIT\n\n${readFileSync(path.join(here, "licences/musl-MIT.txt"), "utf8")}`)
const installed = path.dirname(yaml)
const [about] = readdirSync(installed).filter((name) => /^pyyaml-.*\.dist-info$/i.test(name))
licences.push(`PyYAML: MIT\n\n${readFileSync(path.join(installed, about, "licenses/LICENSE"), "utf8")}`)
writeFileSync(path.join(out, "licences.txt"), licences.join("\n\n"))

// Last comes live.js, as make takes it for the sign that all is there.
const isSign = ({ path: file }) => file.endsWith("live.js")
live.outputFiles.sort((one, other) => isSign(one) - isSign(other))
live.outputFiles.forEach(({ path: file, contents }) => writeWhole(file, contents))
