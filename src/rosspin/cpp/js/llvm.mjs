// The compiler: LLVM's programs in one module, on WASI (snapshot preview 1) with files in memory. The package brings a host
// of its own, which copies the whole of a file for each 4 kB that are written to it.

const SUCCESS = 0
const BADF = 8
const EXIST = 20
const INVAL = 28
const ISDIR = 31
const NOENT = 44
const NOSYS = 52
const NOTDIR = 54

const DIRECTORY = 3
const FILE = 4
const CREATE = 1
const AS_DIRECTORY = 2
const EXCLUSIVE = 4
const TRUNCATE = 8

const ROOT = 3 // the folder that is open from the start

class Exit extends Error {
  constructor(status) {
    super(`exit ${status}`)
    this.status = status
  }
}

let inodes = 0

class Folder {
  inode = ++inodes
  entries = new Map()

  /** Put a file, or a folder, at a path below. */
  put(path, entry) {
    const parts = path.split("/")
    const last = parts.pop()
    let at = this
    for (const part of parts) {
      if (!at.entries.has(part)) at.entries.set(part, new Folder())
      at = at.entries.get(part)
    }
    at.entries.set(last, entry)
  }
}

class File {
  inode = ++inodes

  constructor(bytes = new Uint8Array()) {
    this.bytes = bytes
    this.size = bytes.length
  }

  get content() {
    return this.bytes.subarray(0, this.size)
  }

  resize(size) {
    if (size > this.bytes.length) {
      const larger = new Uint8Array(Math.max(size, 2 * this.bytes.length))
      larger.set(this.content)
      this.bytes = larger
    } else this.bytes.fill(0, size, this.size)
    this.size = size
  }

  write(at, bytes) {
    if (at + bytes.length > this.size) this.resize(at + bytes.length)
    this.bytes.set(bytes, at)
  }
}

/** Return the files of an archive (tar), by their names. */
export function unpacked(archive) {
  const files = {}
  const text = (at, length) => decoder.decode(archive.subarray(at, at + length)).replace(/\0.*$/s, "")
  for (let at = 0; archive[at]; ) {
    const size = Number.parseInt(text(at + 124, 12), 8) || 0
    const name = text(at, 100).replace(/^\.\/|\/$/g, "")
    if (archive[at + 156] !== 0x35) files[name] = archive.subarray(at + 512, at + 512 + size)
    at += 512 + Math.ceil(size / 512) * 512
  }
  return files
}

/** LLVM: `module` is its program, `archive` the headers and libraries that it brings, as a tar file of /usr. */
export class Compiler {
  constructor(module, archive) {
    this.module = module
    this.usr = new Folder()
    for (const [path, bytes] of Object.entries(unpacked(archive))) this.usr.put(path, new File(bytes))
  }

  /**
   * Run one of its programs with files, by their paths; return its exit status, what it said, and what it made, by the
   * names among `outputs`.
   */
  run(args, files, outputs = []) {
    const root = new Folder()
    root.entries.set("usr", this.usr)
    root.entries.set("tmp", new Folder())
    for (const [path, bytes] of Object.entries(files)) root.put(path, new File(bytes))
    const world = new World(["llvm", ...args], root)
    const instance = new WebAssembly.Instance(this.module, { wasi_snapshot_preview1: world.calls() })
    world.memory = instance.exports.memory
    let status = 0
    try {
      instance.exports._start()
    } catch (error) {
      if (!(error instanceof Exit)) throw error
      status = error.status
    }
    const made = Object.fromEntries(outputs.map((name) => [name, root.entries.get(name)?.content]))
    return { status, said: decoder.decode(world.said.content), made }
  }
}

/** What a program of the compiler has about it. */
class World {
  said = new File()

  constructor(words, root) {
    this.words = words.map((word) => encoder.encode(`${word}\0`))
    this.root = root
    this.open = [undefined, this.said, this.said, root].map((entry) => ({ entry, at: 0 }))
  }

  get view() {
    if (this.dataView?.buffer !== this.memory.buffer) this.dataView = new DataView(this.memory.buffer)
    return this.dataView
  }

  bytes(at, length) {
    return new Uint8Array(this.memory.buffer, at, length)
  }

  /** Return the folder in which a path is, its name there, and what is there, if anything. */
  find(descriptor, at, length) {
    const trail = [this.open[descriptor].entry]
    const parts = decoder.decode(this.bytes(at, length)).split("/")
    let last = "."
    for (const part of parts) {
      if (part === "" || part === ".") continue
      const folder = trail.at(-1)
      if (!(folder instanceof Folder)) return {}
      if (part === "..") trail.length > 1 && trail.pop()
      else trail.push(folder.entries.get(part))
      last = part
    }
    return { folder: trail.at(-2), name: last, entry: trail.at(-1) }
  }

  stat(at, entry) {
    this.bytes(at, 64).fill(0)
    this.view.setBigUint64(at + 8, BigInt(entry.inode), true)
    this.view.setUint8(at + 16, entry instanceof Folder ? DIRECTORY : FILE)
    this.view.setBigUint64(at + 24, 1n, true)
    this.view.setBigUint64(at + 32, BigInt(entry.size ?? 0), true)
    return SUCCESS
  }

  /** Go through the buffers of a list; `each` returns how much of one it has used. */
  each(list, count, total, each) {
    let sum = 0
    for (let number = 0; number < count; number++) {
      const at = list + 8 * number
      sum += each(this.bytes(this.view.getUint32(at, true), this.view.getUint32(at + 4, true)))
    }
    this.view.setUint32(total, sum, true)
    return SUCCESS
  }

  read(file, at, list, count, total) {
    if (file instanceof Folder) return ISDIR
    return this.each(list, count, total, (bytes) => {
      const part = file ? file.content.subarray(at, at + bytes.length) : []
      bytes.set(part)
      at += part.length
      return part.length
    })
  }

  calls() {
    const checked = (call) => (fd, ...more) => (this.open[fd] ? call(this.open[fd], ...more) : BADF)
    return {
      args_sizes_get: (count, size) => {
        this.view.setUint32(count, this.words.length, true)
        const sizes = this.words.map((word) => word.length)
        this.view.setUint32(size, sizes.reduce((sum, each) => sum + each), true)
        return SUCCESS
      },
      args_get: (list, buffer) => {
        for (const word of this.words) {
          this.view.setUint32(list, buffer, true)
          this.bytes(buffer, word.length).set(word)
          list += 4
          buffer += word.length
        }
        return SUCCESS
      },
      environ_sizes_get: (count, size) => {
        this.view.setUint32(count, 0, true)
        this.view.setUint32(size, 0, true)
        return SUCCESS
      },
      environ_get: () => SUCCESS,
      clock_time_get: (_clock, _precision, at) => {
        this.view.setBigUint64(at, BigInt(Date.now()) * 1_000_000n, true)
        return SUCCESS
      },
      random_get: (at, length) => {
        crypto.getRandomValues(this.bytes(at, length))
        return SUCCESS
      },
      poll_oneoff: () => NOSYS,
      proc_exit: (status) => {
        throw new Exit(status)
      },
      fd_close: checked((open) => (delete this.open[this.open.indexOf(open)], SUCCESS)),
      fd_fdstat_get: checked(({ entry }, at) => {
        this.bytes(at, 24).fill(0)
        this.view.setUint8(at, entry instanceof Folder ? DIRECTORY : FILE)
        this.bytes(at + 8, 16).fill(255) // it may do anything
        return SUCCESS
      }),
      fd_filestat_get: checked(({ entry }, at) => this.stat(at, entry ?? this.said)),
      fd_filestat_set_size: checked(({ entry }, size) => (entry.resize(Number(size)), SUCCESS)),
      fd_filestat_set_times: () => SUCCESS,
      fd_prestat_get: (fd, at) => {
        if (fd !== ROOT) return BADF
        this.view.setUint32(at, 0, true)
        this.view.setUint32(at + 4, 1, true)
        return SUCCESS
      },
      fd_prestat_dir_name: (_fd, at) => (this.view.setUint8(at, 0x2f), SUCCESS),
      fd_read: checked((open, list, count, total) => {
        const status = this.read(open.entry, open.at, list, count, total)
        if (!status) open.at += this.view.getUint32(total, true)
        return status
      }),
      fd_pread: checked(({ entry }, list, count, at, total) => this.read(entry, Number(at), list, count, total)),
      fd_write: checked((open, list, count, total) =>
        this.each(list, count, total, (bytes) => {
          if (open.entry === this.said) open.at = this.said.size
          open.entry.write(open.at, bytes)
          open.at += bytes.length
          return bytes.length
        }),
      ),
      fd_seek: checked((open, offset, whence, result) => {
        open.at = [0, open.at, open.entry.size][whence] + Number(offset)
        this.view.setBigUint64(result, BigInt(open.at), true)
        return SUCCESS
      }),
      fd_readdir: checked(({ entry }, at, length, cookie, used) => {
        const end = at + length
        let next = Number(cookie)
        const start = at
        for (const [name, each] of [...entry.entries].slice(next)) {
          const head = new Uint8Array(24)
          const bytes = encoder.encode(name)
          const view = new DataView(head.buffer)
          view.setBigUint64(0, BigInt(++next), true)
          view.setBigUint64(8, BigInt(each.inode), true)
          view.setUint32(16, bytes.length, true)
          view.setUint8(20, each instanceof Folder ? DIRECTORY : FILE)
          for (const part of [head, bytes]) {
            const fitting = part.subarray(0, end - at)
            this.bytes(at, fitting.length).set(fitting)
            at += fitting.length
          }
          if (at === end) break
        }
        this.view.setUint32(used, at - start, true)
        return SUCCESS
      }),
      path_create_directory: (fd, at, length) => {
        const { folder, name, entry } = this.find(fd, at, length)
        if (entry) return EXIST
        if (!folder) return NOENT
        folder.entries.set(name, new Folder())
        return SUCCESS
      },
      path_filestat_get: (fd, _flags, at, length, result) => {
        const { entry } = this.find(fd, at, length)
        return entry ? this.stat(result, entry) : NOENT
      },
      path_open: (fd, _lookup, at, length, how, _base, _inheriting, _flags, result) => {
        let { folder, name, entry } = this.find(fd, at, length)
        if (entry && how & CREATE && how & EXCLUSIVE) return EXIST
        if (!entry && how & CREATE && folder) folder.entries.set(name, (entry = new File()))
        if (!entry) return NOENT
        if (how & AS_DIRECTORY && !(entry instanceof Folder)) return NOTDIR
        if (how & TRUNCATE) entry.resize(0)
        this.view.setUint32(result, this.open.push({ entry, at: 0 }) - 1, true)
        return SUCCESS
      },
      path_rename: (fd, at, length, to, toAt, toLength) => {
        const [old, fresh] = [this.find(fd, at, length), this.find(to, toAt, toLength)]
        if (!old.entry || !fresh.folder) return NOENT
        old.folder.entries.delete(old.name)
        fresh.folder.entries.set(fresh.name, old.entry)
        return SUCCESS
      },
      path_unlink_file: (fd, at, length) => {
        const { folder, name, entry } = this.find(fd, at, length)
        if (!entry) return NOENT
        folder.entries.delete(name)
        return SUCCESS
      },
      path_remove_directory: () => NOSYS,
      path_link: () => NOSYS,
      path_readlink: () => INVAL,
      path_symlink: () => NOSYS,
    }
  }
}

const encoder = new TextEncoder()
const decoder = new TextDecoder()
