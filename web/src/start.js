// What a plain start of Python shares with one from a memory snapshot, which web/snapshot.mjs makes.

/**
 * What loadPyodide is told; `info` is from Pyodide's lock file, whose packages are not here.
 *
 * @param {object} info
 */
export function options(info) {
  return { lockFileContents: JSON.stringify({ info, packages: {} }), checkAPIVersion: false }
}

/** The folders in which Python has its standard library and what is installed. */
export const LIBRARY = "/lib"
export const PACKAGES = `${LIBRARY}/python3.14/site-packages`

/**
 * Put the bytes of rosspin.zip where Python finds it. In a snapshot it is known already.
 *
 * @param {import("pyodide/pyodide.mjs").PyodideAPI} python
 * @param {Uint8Array} zip
 */
export function install(python, zip) {
  const file = `${PACKAGES}/rosspin.zip`
  python.FS.writeFile(file, zip)
  const { path } = python.pyimport("sys")
  if (!path.includes(file)) path.append(file)
}
