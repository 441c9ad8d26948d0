// The world of a C++ node: WASI (snapshot preview 1) on a simulated clock, for Node and for the page.

import { Shared } from "./shared.mjs"
import { Threads } from "./threads.mjs"

const SUCCESS = 0
const BADF = 8
const INVAL = 28
const NOSYS = 52

// A program that reads the clock so often without waiting waits by reading it: from then on each look takes 1 µs, and ten
// times as long each time that it has looked so often again, up to 1 ms (see runtime/host.cpp). To print
// counts as a look, too.
const LOOKS = 10_000
const LOOK = [0n, 1_000n, 10_000n, 100_000n, 1_000_000n]

/**
 * How a program calls out to a host, and is called. What it calls are `steps`, a generator function: what that yields is for
 * the host, whose answer `exchange` returns. This host answers at once.
 */
const AT_ONCE = {
  out:
    (steps, exchange) =>
    (...given) => {
      const going = steps(...given)
      let step = going.next()
      while (!step.done) step = going.next(exchange(step.value))
      return step.value
    },
  into: (called) => called,
}

/** This one answers with a promise, until which the program is suspended (JSPI). What is called may be, too. */
const SUSPENDED = {
  out(steps, exchange) {
    const end = async (going, step) => {
      while (!step.done) step = going.next(await (step.value instanceof Promise ? step.value : exchange(step.value)))
      return step.value
    }
    return new WebAssembly.Suspending((...given) => {
      const going = steps(...given)
      const step = going.next()
      return step.done ? step.value : end(going, step)
    })
  },
  into: (called) => WebAssembly.promising(called),
}

/**
 * One program. `link` is what it shares with others: `link.begin(shared)` sets its time, `link.write(fd, bytes)` takes
 * what it prints, `link.sleep(until)` takes the steps in which the time advances to `until` (bigint, ns) and may come back
 * earlier, with something for the program to do; `link.exchange` is the host's, and `link.random(bytes)` fills bytes.
 */
export class Program {
  #status

  constructor(module, args, environment, link) {
    this.module = module
    this.link = link
    this.threads = new Threads(this)
    this.args = args.map((word) => encoder.encode(`${word}\0`))
    this.environment = Object.entries(environment).map(([name, value]) => encoder.encode(`${name}=${value}\0`))
  }

  /** Run it to its end; return its exit status. What ends it from outside, or a trap, is thrown. */
  run(imports) {
    this.#begin(imports, AT_ONCE)
    try {
      try {
        this.exports._start()
      } catch (error) {
        this.#tell(error, (called) => called)
      }
      return 0
    } catch (error) {
      return this.#statusAt(error)
    }
  }

  /** Do the same with threads, or beside others: a promise of the exit status. */
  async runSuspended(imports, isBeside) {
    this.#begin(imports, isBeside ? SUSPENDED : AT_ONCE)
    try {
      try {
        await Promise.race([WebAssembly.promising(this.exports._start)(), this.threads.failed])
      } catch (error) {
        await this.#tell(error, WebAssembly.promising)
      }
      return 0
    } catch (error) {
      return this.#statusAt(error)
    }
  }

  #begin(imports, calls) {
    this.into = calls.into
    const out = (steps) => calls.out(steps, this.link.exchange)
    const rosspin = { ...imports(this, out), ...this.threads.imports }
    const instance = new WebAssembly.Instance(this.module, this.#given({ wasi_snapshot_preview1: this.#wasi(out), rosspin }))
    this.exports = instance.exports
    this.memory = instance.exports.memory
    this.shared = new Shared(instance.exports)
    this.link.begin(this.shared)
  }

  /** Let it tell which exception of C++ it is that has ended it, and exit. Any other error is thrown. */
  #tell(error, into) {
    const tag = this.exports.__cpp_exception
    if (!(tag && error instanceof WebAssembly.Exception && error.is(tag))) throw error
    return into(this.exports.rosspin_uncaught)(error.getArg(tag, 0))
  }

  /** The exit status by which it has ended itself. Any other error is thrown. */
  #statusAt(error) {
    if (this.#status === undefined) throw error
    return this.#status
  }

  /** Note that it looks at the time, or at something else; whoever looks again and again waits. */
  *look() {
    this.link.touch?.()
    const times = Math.floor(this.shared.looks++ / LOOKS)
    if (times) yield* this.link.sleep(this.shared.now + LOOK[Math.min(times, 4)])
  }

  *sleep(until) {
    if (until > this.shared.now) this.shared.looks = 0
    else yield* this.look()
    yield* this.link.sleep(until)
  }

  text(at, length) {
    return decoder.decode(this.bytes(at, length))
  }

  bytes(at, length) {
    return new Uint8Array(this.memory.buffer, at, length)
  }

  /** Copy bytes into the program's memory, for it to free; return where they are. */
  give(bytes) {
    const at = this.exports.malloc(bytes.length)
    this.bytes(at, bytes.length).set(bytes)
    return at
  }

  get #view() {
    if (this.dataView?.buffer !== this.memory.buffer) this.dataView = new DataView(this.memory.buffer)
    return this.dataView
  }

  #words(words, list, buffer) {
    for (const word of words) {
      this.#view.setUint32(list, buffer, true)
      this.bytes(buffer, word.length).set(word)
      list += 4
      buffer += word.length
    }
    return SUCCESS
  }

  #sizes(words, count, size) {
    this.#view.setUint32(count, words.length, true)
    this.#view.setUint32(
      size,
      words.reduce((sum, word) => sum + word.length, 0),
      true,
    )
    return SUCCESS
  }

  /**
   * What it imports of these modules' functions. Others of WASI answer that there is no such thing: a node has no files.
   * A program names what it likes, such as `constructor`, which each object has.
   */
  #given(modules) {
    const given = { __proto__: null }
    for (const { module, name } of WebAssembly.Module.imports(this.module)) {
      const own = Object.hasOwn(modules, module) ? modules[module] : {}
      const lacking = () => {
        if (own === modules.wasi_snapshot_preview1) return name.startsWith("fd_") ? BADF : NOSYS
        throw new WebAssembly.RuntimeError(`it calls ${name} of ${module}, which there is not`)
      }
      given[module] ??= { __proto__: null }
      given[module][name] = Object.hasOwn(own, name) ? own[name] : lacking
    }
    return given
  }

  #wasi(out) {
    const program = this
    return {
      args_sizes_get: (count, size) => this.#sizes(this.args, count, size),
      args_get: (list, buffer) => this.#words(this.args, list, buffer),
      environ_sizes_get: (count, size) => this.#sizes(this.environment, count, size),
      environ_get: (list, buffer) => this.#words(this.environment, list, buffer),
      clock_res_get: (_clock, at) => {
        this.#view.setBigUint64(at, 1n, true)
        return SUCCESS
      },
      clock_time_get: out(function* (clock, _precision, at) {
        if (clock > 1) return INVAL
        yield* program.look()
        const { now, ahead } = program.shared
        program.#view.setBigUint64(at, clock === 0 ? now + ahead : now, true)
        return SUCCESS
      }),
      random_get: (at, length) => {
        this.link.random(this.bytes(at, length))
        return SUCCESS
      },
      sched_yield: out(function* () {
        yield* program.look()
        return SUCCESS
      }),
      // A trap follows: an exception would be caught on its way, by each destructor and by what throws nothing.
      proc_exit: (status) => {
        this.#status = status
      },
      fd_fdstat_get: (fd, at) => {
        if (fd > 2) return BADF
        this.bytes(at, 24).fill(0)
        this.#view.setUint8(at, 2) // a terminal: what is printed is seen at the end of each line
        this.#view.setBigUint64(at + 8, fd ? 64n : 2n, true)
        return SUCCESS
      },
      fd_read: (fd, _list, _count, read) => {
        if (fd) return BADF
        this.#view.setUint32(read, 0, true) // there is no keyboard
        return SUCCESS
      },
      fd_write: out(function* (fd, list, count, written) {
        if (fd !== 1 && fd !== 2) return BADF
        let total = 0
        for (let each = 0; each < count; each++) {
          const at = program.#view.getUint32(list + 8 * each, true)
          const length = program.#view.getUint32(list + 8 * each + 4, true)
          if (length) program.link.write(fd, program.bytes(at, length))
          total += length
        }
        program.#view.setUint32(written, total, true)
        yield* program.look()
        return SUCCESS
      }),
      poll_oneoff: out(function* (subscriptions, events, count, happened) {
        let found = 0
        const add = (at, error) => {
          program.bytes(events + 32 * found, 32).fill(0)
          program.bytes(events + 32 * found, 8).set(program.bytes(at, 8))
          program.#view.setUint16(events + 32 * found + 8, error, true)
          program.#view.setUint8(events + 32 * found + 10, program.#view.getUint8(at + 8))
          found++
        }
        const dues = []
        for (let each = 0; each < count; each++) {
          const at = subscriptions + 48 * each
          if (program.#view.getUint8(at + 8) !== 0) {
            add(at, SUCCESS) // a stream is always ready
            continue
          }
          const clock = program.#view.getUint32(at + 16, true)
          const timeout = program.#view.getBigUint64(at + 24, true)
          const now = program.shared.now + (clock === 0 ? program.shared.ahead : 0n)
          const absolute = program.#view.getUint16(at + 40, true) & 1
          dues.push([absolute ? (timeout > now ? timeout - now : 0n) : timeout, at])
        }
        if (!found && dues.length) {
          dues.sort(([one], [other]) => (one < other ? -1 : 1))
          const until = program.shared.now + dues[0][0]
          while (program.shared.now < until) yield* program.sleep(until)
          add(dues[0][1], SUCCESS)
        }
        program.#view.setUint32(happened, found, true)
        return SUCCESS
      }),
    }
  }
}

const encoder = new TextEncoder()
const decoder = new TextDecoder()
