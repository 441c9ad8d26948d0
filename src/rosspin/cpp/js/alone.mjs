// A C++ node that runs by itself, without Python: the clock is here, and the answers to what it asks.

import { Node } from "./node.mjs"
import { Ros1 } from "./ros1.mjs"
import { Ros2 } from "./ros2.mjs"
import { hasThreads } from "./threads.mjs"
import { packed, unpacked } from "./values.mjs"

export { COLOURS } from "./values.mjs"

const NS = 1_000_000_000

/** So long (s) after Ctrl-C it is killed: see run/host.py. */
const PATIENCE = 17

const SIGINT = 2
const KILLED = 128 + 9

const TICK = 32 // bytes: see shared.mjs

/** What each ROS says of a node that was killed: see run/kinds. */
const KILLS = { 1: " s later, as roslaunch does. Does its loop check ros::ok()?", 2: " s later. Does its loop check rclcpp::ok()?" }

/** What a node ends with that spins. */
const SPINS = { 1: "ros::spin()", 2: "rclcpp::spin(node)" }

/** What ends a run from outside. */
class Ended extends Error {
  constructor(status) {
    super(`status ${status}`)
    this.status = status
  }
}

/**
 * A node of `ros`, in the file `name`, that runs for `seconds` with these `words` on its command line. What it does is told
 * to `shown`: `print(text, isError)`, `begin(tick)` for each tick, and `pace(now)` before the time advances to `now` (s) if
 * it is `paced`, which may take a while.
 */
export class Alone extends Node {
  /** Each [source, number, expected, real, duration], times in s; duration -1: it still runs. */
  ticks = []
  foreseen = [] // those that would have come next
  periods = new Map() // (s) by source
  rings = [] // of waits
  #names = []
  #going = [] // the ticks that still run, by their numbers
  #events = []
  #signals = []
  #lost = "" // what was destroyed before the node spun: see runtime/host.cpp
  #hints = []
  #over = false // whatever it still does is no part of the run
  #ros
  #file
  #until
  #killed
  #pressed = false // Ctrl-C
  #shown
  #spins
  #paced
  #streams = [1, 2].map(() => new TextDecoder())

  constructor(module, { ros, name, words, seconds, seed, paced }, shown) {
    const start = { args: [name.replace(/\.\w+$/, ""), ...words], environment: {}, start: 0, ahead: 0, seed }
    super(module, start, (batch) => this.#answer(batch), (batch) => this.#take(batch))
    this.#spins = SPINS[ros]
    this.#ros = { 1: new Ros1(this), 2: new Ros2(this) }[ros]
    this.#file = { name, kills: `rosspin: Ctrl-C at ${seconds} s did not end the node; it was killed ${PATIENCE}${KILLS[ros]}\n` }
    this.#until = BigInt(Math.round(seconds * NS))
    this.#killed = this.#until + BigInt(PATIENCE * NS)
    this.#shown = shown
    this.#paced = paced
  }

  /** Run it to its end; a promise of its exit status, when (s) that was, and what a reader should know of that. */
  async run() {
    try {
      await super.run()
    } catch (error) {
      if (!(error instanceof Ended)) throw error
      return { status: error.status, end: seconds(this.shared.now), hints: this.#hints }
    }
  }

  get hasThreads() {
    return hasThreads(this.module)
  }

  /** The tick in which the node is, by its number; -1: in none. */
  get tick() {
    this.#take({ ticks: this.shared.takeTicks() })
    return this.#going.at(-1) ?? -1
  }

  // --- what it does ---

  write(fd, bytes) {
    const { tick } = this
    if (!this.#over) this.#shown.print(this.#streams[fd - 1].decode(bytes, { stream: true }), fd === 2, tick)
  }

  note(what, ...values) {
    if (what === "tell") {
      const [name, more] = unpacked(values[0])
      if (name === "coming") this.#foresee(more)
      else if (name === "ring") this.rings.push({ links: more[0], to: 0 })
      else if (name === "lost") this.#lost = more[0]
      else this.#ros.told[name](...more)
    } else if (what === "source") {
      const [name, period] = values
      const count = this.#names.filter((each) => each.base === name).length + 1
      this.#names.push({ base: name, name: count > 1 ? `${name} ${count}` : name })
      this.periods.set(this.#names.at(-1).name, Number(period) / NS)
    } else {
      const [tick, duration] = values.map(Number)
      this.#take({ ticks: this.shared.takeTicks() })
      this.ticks[tick][4] = duration / NS
      this.#going.splice(this.#going.indexOf(tick), 1)
    }
  }

  #foresee(values) {
    for (let at = 0; at < values.length; at += 4) {
      const [source, number, due, real] = values.slice(at, at + 4).map(Number)
      this.foreseen.push([this.#names[source].name, number, due / NS, real / NS, -1])
    }
  }

  /** Why callbacks of a node that has ended were never called, in sentences: see run/explain.py. */
  #uncalled(waiting) {
    if (waiting > 0 && !this.#pressed) return [`Nothing spun the node, so none of its timers, subscriptions and services called back. Is ${this.#spins} missing at its end?`]
    const lost = this.#lost.split(" ").filter(Boolean)
    const kept = this.#names.filter((_, source) => !lost.includes(`${source}`)).map(({ base }) => base)
    const said = lost.map((each) => {
      const base = this.#names[each]?.base
      if (kept.includes(base)) return "" // it was made again
      const [what, left] =
        each === "node"
          ? ["last ros::NodeHandle", "ros::spin(), which has shut the node down"]
          : [
              each === "group"
                ? "callback group"
                : base
                  ? `timer of ${base === "lambda" ? "a lambda" : base}`
                  : `subscription to ${each}`,
              "it could call back",
            ]
      return `The ${what} was destroyed before ${left}. Keep it in a member of the class, or in main.`
    })
    return [...new Set(said)].filter(Boolean)
  }

  #take({ ticks, status, waiting, trap }) {
    for (let at = 0; at < (ticks?.length ?? 0); at += TICK) {
      const view = new DataView(ticks.buffer, ticks.byteOffset + at, TICK)
      const time = (place) => seconds(view.getBigInt64(place, true))
      const duration = view.getBigInt64(24, true)
      const tick = [this.#names[view.getInt32(0, true)].name, view.getInt32(4, true), time(8), time(16), duration < 0n ? -1 : seconds(duration)]
      const number = this.ticks.push(tick) - 1
      if (duration < 0n) this.#going.push(number)
      this.#shown.begin(tick, number)
    }
    if (trap) {
      const { why, signal, file, line } = trap
      this.#say(`rosspin: ${file || this.#file.name}:${line ? `${line}:` : ""} ${why}\n`)
      this.#finish(128 + signal)
    }
    if (status === 0) this.#hints = this.#uncalled(waiting)
    if (status !== undefined) this.#finish(status)
  }

  // --- what it is told: see ros1.mjs and ros2.mjs ---

  event(what, values) {
    this.#events.push([String(this.shared.now), packed(what) + packed(values)])
  }

  get now() {
    return this.shared.now
  }

  logLine(level, name, text) {
    const now = this.shared.now
    const stamp = `${now / BigInt(NS)}.${String(now % BigInt(NS)).padStart(9, "0")}`
    this.#say(`[${level}] [${stamp}] [${name}]: ${text}\n`)
  }

  #answer({ asks, ticks, wake }) {
    this.#take({ ticks })
    let answer = ""
    if (asks) answer = packed(this.#asked(...unpacked(asks)))
    else if (!this.#events.length) this.#wait(BigInt(wake))
    const { now } = this.shared
    const horizon = this.#paced ? now : this.#pressed ? this.#killed : this.#until
    const reply = { now, ahead: 0n, horizon, events: this.#events, signals: this.#signals, answer }
    this.#events = []
    this.#signals = []
    return reply
  }

  #say(text) {
    this.#shown.print(text, true, -1)
  }

  #finish(status) {
    this.#over = true
    throw new Ended(status)
  }

  #asked(what, values) {
    const answer = this.#ros.asked[what]
    if (answer) return answer(...values)
    this.refuse(what === "not_simulated" ? values[0] : `in a page, to ask for the ${what.replaceAll("_", " ")} of nodes`)
  }

  refuse(what) {
    this.#say(`${what} is not simulated; run this node on a real ROS\n`)
    this.#finish(1)
  }

  /** Advance the time to when the node wakes, or to Ctrl-C. What is due when that comes still runs. */
  #wait(wake) {
    const { shared } = this
    const last = this.#pressed ? this.#killed : this.#until
    const to = wake > last ? last : wake
    if (to > shared.now) {
      if (this.#paced) this.#shown.pace(seconds(to))
      shared.now = to
    }
    if (wake <= last) return
    if (this.#pressed) {
      this.#say(this.#file.kills)
      this.#finish(KILLED)
    }
    this.#pressed = true
    this.#signals = [SIGINT]
  }
}

const seconds = (ns) => Number(ns) / NS
