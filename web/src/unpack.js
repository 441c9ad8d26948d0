// What is dropped on the teachers' page: files, and those in folders and zip archives, each with its path as its name.

/** @typedef {{name: string, why: string}} Unread a file that cannot be read, and why */
/** @typedef {File | Unread} Dropped */

/** What is read at most: of archives so many within each other, and of a hand-in so much (bytes). */
const MOST = { depth: 4, file: 1_000_001 }

/** What is read of all that is dropped at the same time: so many files, so many names, and so much of archives (bytes). */
const ALL = { files: 2000, names: 20_000, bytes: 200_000_000 }
const TOO_MUCH = "there is too much in all"

/** No list of what is in an archive is longer (bytes): that has room for all names. */
const MOST_LIST = 8_000_000

/** What systems and programs leave in folders and archives. */
const LEFT_BEHIND = /(^|\/)(\.[^/]*|__MACOSX|Thumbs\.db|desktop\.ini)(\/|$)/i

/** What is said of other files than those that Hand in saves. */
const OTHER = "this page reads what Hand in saved, and rosspin judge node files and notebooks, too"

/** The upper half of the code page in which Windows writes names. */
const CP437 =
  "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0"

/**
 * The files of a drop; it has to be asked while the event is handled.
 *
 * @param {DataTransfer} dropped
 * @returns {Promise<Dropped[]>}
 */
export async function dropped({ items, files }) {
  const entries = [...items].map((item) => item.webkitGetAsEntry())
  if (!entries.some((entry) => entry?.isDirectory)) return unpacked([...files])
  const left = { ...ALL }
  const found = []
  for (const entry of entries) if (entry) found.push(...(await walked(entry, left)))
  return unpacked(found)
}

/**
 * @param {FileSystemEntry} entry
 * @param {typeof ALL} left
 * @returns {Promise<Dropped[]>}
 */
async function walked(entry, left, path = entry.name) {
  if (LEFT_BEHIND.test(entry.name) || left.names-- <= 0) return []
  if (entry.isFile) {
    const file = await new Promise((resolve) =>
      /** @type {FileSystemFileEntry} */ (entry).file(resolve, () => resolve({ name: path, why: "it cannot be read" })),
    )
    return ["why" in file ? file : named(file, path)]
  }
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader()
  const found = []
  for (;;) {
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])))
    if (!some.length) return found
    for (const inner of some) found.push(...(await walked(inner, left, `${path}/${inner.name}`)))
  }
}

/**
 * A file by its path.
 *
 * @param {File} file
 * @param {string} path
 */
const named = (file, path) => Object.defineProperty(file, "name", { value: path })

/**
 * The files, and in place of an archive those in it. What lies in a folder or an archive and is no hand-in is refused, but
 * for what is beside the one hand-in in a folder and can hold no answers.
 *
 * @param {Dropped[]} files
 * @returns {Promise<Dropped[]>}
 */
export async function unpacked(files, depth = 1, left = { ...ALL }) {
  /** @type {Dropped[]} */
  const found = []
  for (const file of files) {
    if ("why" in file || !(await isArchive(file))) found.push(file)
    else if (depth > MOST.depth) found.push({ name: file.name, why: `it is an archive within ${MOST.depth} others` })
    else {
      const inner = await entriesOf(file, left).catch(() => [{ name: file.name, why: "it is no zip archive that can be read" }])
      found.push(...(await unpacked(inner, depth + 1, left)))
    }
    if (found.length > ALL.files) return [...found.slice(0, ALL.files), { name: file.name, why: TOO_MUCH }]
  }
  const isHandIn = (/** @type {Dropped} */ { name }) => /\.json$/i.test(name)
  const folder = (/** @type {Dropped} */ { name }) => name.slice(0, name.lastIndexOf("/") + 1)
  /** @type {Map<string, number>} */
  const having = new Map()
  for (const file of found) if (isHandIn(file)) having.set(folder(file), (having.get(folder(file)) ?? 0) + 1)
  const isReport = (/** @type {Dropped} */ file) =>
    !/\.(py|ipynb|md)$/i.test(file.name) && having.get(folder(file)) === 1
  return found.flatMap((file) => {
    if (!folder(file) || isHandIn(file) || ("why" in file && file.why !== OTHER)) return [file]
    return isReport(file) ? [] : [{ name: file.name, why: OTHER }]
  })
}

/** @param {File} file */
const isArchive = async (file) =>
  /\.zip$/i.test(file.name) || (await file.slice(0, 4).text().catch(() => "")) === "PK\x03\x04"

/**
 * What is in an archive; of other files than hand-ins and archives only the names. Error: it cannot be read.
 *
 * @param {File} archive
 * @param {typeof ALL} left is lessened by what is read
 * @returns {Promise<Dropped[]>}
 */
async function entriesOf(archive, left) {
  const folder = archive.name.replace(/\.zip$/i, "")
  const tail = new DataView(await archive.slice(-65_557).arrayBuffer())
  let end = tail.byteLength - 22
  while (tail.getUint32(end, true) !== 0x06054b50) end-- // an error, in the end, if there is none
  const [size, start] = [tail.getUint32(end + 12, true), tail.getUint32(end + 16, true)]
  const list = new DataView(await archive.slice(start, start + Math.min(size, MOST_LIST)).arrayBuffer())
  /** @type {Dropped[]} */
  const found = []
  for (let at = 0; at < size; ) {
    if (found.length > ALL.files || left.names-- <= 0) return [...found, { name: archive.name, why: TOO_MUCH }]
    if (list.getUint32(at, true) !== 0x02014b50) throw new Error("damaged")
    const [flags, method] = [list.getUint16(at + 8, true), list.getUint16(at + 10, true)]
    const packed = list.getUint32(at + 20, true)
    const [long, extra, comment] = [28, 30, 32].map((place) => list.getUint16(at + place, true))
    const place = list.getUint32(at + 42, true)
    const name = nameIn(new Uint8Array(list.buffer, at + 46, long), Boolean(flags & 0x800))
    at += 46 + long + extra + comment
    const path = [folder, ...name.split(/[/\\]/).filter((part) => !["", ".", ".."].includes(part))].join("/")
    if (name.endsWith("/") || LEFT_BEHIND.test(path)) continue
    const isRead = /\.(json|zip)$/i.test(name)
    found.push(isRead ? await entry(archive, path, flags, method, place, packed, left) : { name: path, why: OTHER })
  }
  return found
}

/**
 * @param {File} archive
 * @param {string} path
 * @param {number} flags
 * @param {number} method
 * @param {number} place
 * @param {number} packed
 * @param {typeof ALL} left
 * @returns {Promise<Dropped>}
 */
async function entry(archive, path, flags, method, place, packed, left) {
  if (flags & 1) return { name: path, why: "it is locked with a password" }
  if (method !== 0 && method !== 8) return { name: path, why: "it is packed in a way that is not read here; unpack the archive first" }
  try {
    const head = new DataView(await archive.slice(place, place + 30).arrayBuffer())
    const start = place + 30 + head.getUint16(26, true) + head.getUint16(28, true)
    const data = archive.slice(start, start + packed).stream()
    const plain = method ? data.pipeThrough(new DecompressionStream("deflate-raw")) : data
    const file = new File(await startOf(plain, Math.min(left.bytes, /\.zip$/i.test(path) ? Infinity : MOST.file)), "entry")
    left.bytes -= file.size
    return left.bytes > 0 ? named(file, path) : { name: path, why: TOO_MUCH }
  } catch {
    return { name: path, why: "it is damaged in its archive" }
  }
}

/**
 * What comes out of a stream, and no more than so many bytes, whatever it claims to be.
 *
 * @param {ReadableStream<Uint8Array<ArrayBuffer>>} stream
 * @param {number} most
 */
async function startOf(stream, most) {
  const parts = []
  const reader = stream.getReader()
  for (let left = most; left > 0; ) {
    const { value, done } = await reader.read()
    if (done) return parts
    parts.push(value.subarray(0, left))
    left -= value.length
  }
  reader.cancel().catch(() => {})
  return parts
}

/**
 * A name, in the code that its flag says, or else in UTF-8 all the same, as macOS has it, or as Windows does.
 *
 * @param {Uint8Array} bytes
 * @param {boolean} isUnicode
 */
function nameIn(bytes, isUnicode) {
  try {
    return new TextDecoder("utf-8", { fatal: !isUnicode }).decode(bytes)
  } catch {
    return [...bytes].map((byte) => (byte < 128 ? String.fromCharCode(byte) : CP437[byte - 128])).join("")
  }
}
