// A C++ node as a process of a host: what happens in it is told in batches, and it asks the host to advance the time.
//
// A batch is { log, ticks?, now, wake, asks?, status?, trap? }. `log` is what happened since the last one, in order:
// ["out", fd, text (a character a byte)], ["source", name, period], ["end", tick, duration] of a tick that was told in an
// earlier batch, ["tell", text]. `ticks` are bytes (see shared.mjs). Times are in ns, as text. The node waits until `wake`,
// unless it `asks` something (text), or has ended, by a `trap`, or with a `status` and how many callbacks were still `waiting`
// for someone to spin, -1 if someone has. The host answers { now, horizon, events, signals }, and `answer`: the node may run
// on its own as long as its time is before `horizon`.
//
// A trap is { why, in words; signal, the number that would have ended it on a computer; file, line, of its source }: line is 0
// where that is not known, and file empty if it is the one with main.

import { functionNames } from "./names.mjs"
import { hasThreads } from "./threads.mjs"
import { Program } from "./wasi.mjs"

const NEVER = (1n << 63n) - 1n

// A batch that has become this long is told at once.
const LONG = 5_000

export class Node {
  /**
   * `exchange(batch)` tells the host of a batch and returns its answer; `pass(batch)` tells it of one that wants none.
   * If the time is real, `real` is what it is ahead of the clock of this computer that never jumps.
   */
  constructor(module, { args, environment, start, ahead, seed, real }, exchange, pass) {
    this.exchange = exchange
    this.pass = pass
    this.real = real && BigInt(real)
    this.start = BigInt(start)
    this.ahead = BigInt(ahead)
    this.log = []
    this.coming = [] // what the program is told as soon as it waits
    this.sources = 0
    this.draw = mulberry(seed)
    this.module = module
    this.program = new Program(module, args, environment, this)
  }

  begin(shared) {
    this.shared = shared
    shared.now = shared.horizon = this.start
    shared.ahead = this.ahead
    shared.real = this.real !== undefined
  }

  /** Look at the clock, if the time is real. */
  touch() {
    if (this.real !== undefined) this.shared.now = process.hrtime.bigint() + this.real
  }

  /** Run it. With threads, it is a promise. */
  run() {
    if (hasThreads(this.module)) return this.runSuspended(false)
    let end
    try {
      end = this.#ended(this.program.run((...given) => this.#imports(...given)))
    } catch (error) {
      end = this.#trap(error)
    }
    this.pass(this.#batch(end))
  }

  /** Run it with threads, or beside others: what `exchange` returns are promises, then. */
  async runSuspended(isBeside) {
    const end = await this.program.runSuspended((...given) => this.#imports(...given), isBeside).then(
      (status) => this.#ended(status),
      (error) => this.#trap(error),
    )
    this.pass(this.#batch(end))
  }

  /** Tell that it is in an endless loop, with all that came before. */
  standStill() {
    this.pass(this.#batch({ stuck: this.#function(new Error()) }))
  }

  #ended(status) {
    return { status, waiting: this.shared.waiting }
  }

  #trap(error) {
    if (!TRAPS.includes(error.name)) throw error
    const { file, line, divides } = this.shared.fault ?? { file: "", line: 0 }
    const said = divides ? "divide by zero" : error.message
    const [reason, signal] = REASONS.find(([, , trap]) => trap.test(said)) ?? [`it was ended (${said})`, SIGSEGV]
    const [, number, name] = OF_NODE.exec(file) ?? []
    if (name) return { trap: { why: reason, signal, file: number === "0" ? "" : name, line } }
    const place = this.#function(error)
    return { trap: { why: place ? `${reason}, in ${place}` : reason, signal, file: "", line: 0 } }
  }

  write(fd, bytes) {
    this.print(fd, long(bytes))
  }

  print(fd, text) {
    // A host that never lets it run on its own is told of a tick before what is printed in it.
    if (this.shared.horizon <= this.shared.now) this.tellTicks()
    this.note("out", fd, text)
    if (this.real !== undefined) this.pass(this.#batch({}))
  }

  random(bytes) {
    for (let at = 0; at < bytes.length; at++) bytes[at] = this.draw()
  }

  *sleep(until) {
    const { shared } = this
    if (until < shared.horizon && !shared.urgent) {
      if (until > shared.now) shared.now = until
      return
    }
    shared.urgent = false
    if (!this.coming.length) this.#heed(yield this.#batch({ wake: String(until) }))
    for (const come of this.coming.splice(0)) {
      const done = come()
      if (done) yield done // a promise
    }
  }

  /** Tell what there is to tell, if ticks are. */
  tellTicks() {
    const batch = this.#batch({})
    if (batch.ticks) this.pass(batch)
    else this.log = batch.log
  }

  note(...entry) {
    this.log.push(entry)
    if (this.log.length >= LONG) this.pass(this.#batch({}))
  }

  #batch(more) {
    const batch = { log: this.log, ticks: this.shared.takeTicks(), now: String(this.shared.now), ...more }
    this.log = []
    return batch
  }

  #heed({ now, ahead, horizon, events, signals }) {
    const { program, coming, shared } = this
    shared.now = BigInt(now)
    shared.ahead = BigInt(ahead)
    shared.horizon = BigInt(horizon)
    const [event, signal] = [program.exports.rosspin_event, program.exports.rosspin_signal].map(program.into)
    for (const [when, text] of events) {
      coming.push(() => event(program.give(bytes(`${text}\0`)), BigInt(when)))
    }
    for (const number of signals) coming.push(() => signal(number))
    if (coming.length) shared.urgent = true
  }

  #answer(program, text, length) {
    new DataView(program.memory.buffer).setUint32(length, text.length, true)
    return program.give(bytes(`${text}\0`))
  }

  /** The innermost function of the node itself that was running when this error was made; empty if there is none. */
  #function(error) {
    const numbers = [...(error.stack ?? "").matchAll(/wasm-function\[(\d+)\]/g)].map(([, number]) => Number(number))
    const names = functionNames(this.module)
    return numbers.map((number) => own(names.get(number) ?? "")).find(Boolean) ?? ""
  }

  #imports(program, out) {
    const node = this
    return {
      wait: out((until) => node.sleep(until)),
      touch: () => this.touch(),
      source: (name, length, period) => {
        this.note("source", program.text(name, length), String(period))
        return this.sources++
      },
      flush: () => this.pass(this.#batch({})),
      end: (tick, duration) => this.note("end", String(tick), String(duration)),
      tell: (text, length) => {
        this.note("tell", long(program.bytes(text, length)))
        this.shared.urgent = true
      },
      ask: out(function* (text, length, answered) {
        const reply = yield node.#batch({ asks: long(program.bytes(text, length)) })
        node.#heed(reply)
        return node.#answer(program, reply.answer, answered)
      }),
      name: (address, length) => {
        const found = program.exports.__indirect_function_table.get(address)
        const name = found ? functionNames(this.module).get(Number(found.name)) : undefined
        return this.#answer(program, name ?? "", length)
      },
    }
  }
}

const SIGFPE = 8
const SIGSEGV = 11

/** Why a trap has ended it, in words, the signal, and what browsers call it. */
const REASONS = [
  ["its stack has overflowed: a function may call itself without an end", SIGSEGV, /call stack|recursion/],
  ["it has used memory that it does not have, or its stack has overflowed", SIGSEGV, /out of bounds/i],
  ["it has used a null pointer", SIGSEGV, /unreachable/i],
  ["it has called a null pointer, or one to a function with other parameters", SIGSEGV, /null function|indirect/],
  ["it has divided by zero", SIGFPE, /divi(de|sion) by zero/i],
]

/** What is thrown at a trap, and where the stack ends. */
const TRAPS = ["RuntimeError", "RangeError", "InternalError"]

/** A file of the node, with which number, as the compiler names it. */
const OF_NODE = /^\/?(?:node\/(\d+)|own)\/(.+)/

/** A function of the node (see lean.py), and a lambda in one, which is often all that is left of what it calls. */
const OWN = /^(\(anonymous namespace\)::)?(?![^(]*\b(std|rosspin|rclcpp|rcl_interfaces|ros|boost)::|__)[^(]+\(/
const LAMBDA = /((?:\w+::)*\w+\([^()]*\))::'lambda/

function own(name) {
  if (OWN.test(name)) return name
  const [, around = ""] = LAMBDA.exec(name) ?? []
  return OWN.test(around) ? `a lambda of ${around}` : ""
}

/** Bytes of a text of which each character is one, and the other way round. */
const bytes = (text) => Uint8Array.from(text, (character) => character.charCodeAt(0))
const long = (from) => {
  let text = ""
  for (const byte of from) text += String.fromCharCode(byte)
  return text
}

/** A generator of bytes that are the same for the same seed (mulberry32). */
const mulberry = (seed) => () => {
  seed = (seed + 0x6d2b79f5) | 0
  let mixed = Math.imul(seed ^ (seed >>> 15), 1 | seed)
  mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed
  return (mixed ^ (mixed >>> 14)) & 0xff
}
