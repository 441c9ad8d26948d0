// What a plain start of Python shares with one from a memory snapshot, which web/snapshot.mjs makes.

/** What loadPyodide is told; `info` is that of Pyodide's lock file, whose packages are not here. */
export function options(info) {
  return { lockFileContents: JSON.stringify({ info, packages: {} }), checkAPIVersion: false }
}

/** Write the files of rosspin.json (path -> text) where Python looks for packages. */
export function install(python, texts) {
  const folder = python.runPython("import site; site.getsitepackages()[0]")
  for (const [name, text] of Object.entries(texts)) {
    const path = `${folder}/${name}`
    python.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")))
    python.FS.writeFile(path, text)
  }
}
