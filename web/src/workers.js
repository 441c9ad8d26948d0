// The workers in which Python runs, one for each run. Stopping a run ends its worker, so one is kept warm beside them.

/** A worker that has started Python, or is about to. */
class Runner {
  #worker
  #hear = () => {}
  #booted
  ready = false
  dead = false

  constructor(base) {
    this.#worker = new Worker(`${base}worker.js`, { type: "module" })
    this.#booted = new Promise((resolve) => {
      this.#worker.addEventListener("message", ({ data }) => (data.kind === "ready" ? resolve() : this.#receive(data)))
    }).then(() => (this.ready = true))
    const fail = () => this.#receive({ kind: "failed", reason: "Python could not be loaded. Is the site still there?" })
    this.#worker.addEventListener("error", fail)
    this.#worker.addEventListener("messageerror", fail)
  }

  #receive(message) {
    if (message.kind === "failed") this.end()
    this.#hear(message)
  }

  /** Run a job; `hear` is called with what comes of it. */
  async run(job, hear) {
    this.#hear = hear
    await this.#booted
    if (this.dead) return
    hear({ kind: "begun" })
    this.#worker.postMessage(job)
    warmUp(this.base)
  }

  end() {
    this.dead = true
    this.#worker.terminate()
    idle.delete(this)
  }
}

/** Those that do nothing. */
const idle = new Set()

/** Have a worker ready for the next run. */
export function warmUp(base) {
  if (idle.size === 0) idle.add(Object.assign(new Runner(base), { base }))
}

/** Run a job in a worker of its own, which is returned; `hear` is called with what comes of it. */
export function start(base, job, hear) {
  warmUp(base)
  const runner = [...idle].find((found) => found.ready) ?? [...idle][0]
  idle.delete(runner)
  runner.run(job, hear)
  return runner
}

/** Give back a worker whose run has ended by itself. Two are enough to keep. */
export function release(runner) {
  if (idle.size < 2) idle.add(runner)
  else runner.end()
}
