// What is dropped on the teachers' page, or chosen: files, and those in folders, each with its path. What is in them is read
// in Python.

/** @typedef {{path: string, file: File | null}} Dropped null: the browser does not give it */

/**
 * The files of a drop; it has to be asked while the event is handled.
 *
 * @param {DataTransfer} dropped
 * @returns {Promise<Dropped[]>}
 */
export async function dropped({ items, files }) {
  const entries = [...items].map((item) => item.webkitGetAsEntry())
  if (!entries.some((entry) => entry?.isDirectory)) return chosen(files)
  /** @type {Dropped[]} */
  const found = []
  // What is said to be in folders may be without end. The folder counts, and one that is too much, which Python says.
  const left = { entries: RULES.handIns.entries + 2 }
  for (const entry of entries) if (entry) await walk(entry, found, left)
  return found
}

/** @param {Iterable<File>} files */
export const chosen = (files) => [...files].map((file) => ({ path: file.name, file }))

/**
 * @param {FileSystemEntry} entry
 * @param {Dropped[]} found
 * @param {{entries: number}} left
 */
async function walk(entry, found, left, path = entry.name) {
  if (left.entries-- <= 0) return
  if (entry.isFile) {
    const file = await new Promise((resolve) => /** @type {FileSystemFileEntry} */ (entry).file(resolve, () => resolve(null)))
    found.push({ path, file })
    return
  }
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader()
  for (;;) {
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])))
    if (!some.length) return
    for (const inner of some) await walk(inner, found, left, `${path}/${inner.name}`)
  }
}
