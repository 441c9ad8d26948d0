// The workers in which Python runs: a new one for each run, which finds nothing of earlier runs there. The next one is
// started meanwhile. Where that cannot be, as when the server has gone, one whose run has ended takes its place.

/** A worker that has started Python, or is about to. */
class Runner {
  #base
  #worker
  #hear = () => {}
  #begin
  #booted
  #dead = false
  ready = false

  constructor(base) {
    this.#base = base
    this.#booted = new Promise((resolve) => (this.#begin = resolve)).then(() => {
      this.ready = true
      used?.end()
    })
    this.#take(new Worker(`${base}worker.js`, { type: "module" }))
  }

  #take(worker) {
    this.#worker = worker
    worker.onmessage = ({ data }) => (data.kind === "ready" ? this.#begin() : this.#receive(data))
    worker.onerror = worker.onmessageerror = () => {
      this.#receive({ kind: "failed", reason: "Python could not be loaded. Is the site still there?" })
    }
  }

  #receive(message) {
    if (message.kind === "failed") {
      if (!this.ready && used) return this.#takeFrom(used)
      this.end()
    }
    this.#hear(message)
  }

  #takeFrom(other) {
    this.#worker.terminate()
    this.#take(other.#worker)
    used = null
    this.#begin()
  }

  /** Run a job; `hear` is called with what comes of it. */
  async run(job, hear) {
    this.#hear = hear
    await this.#booted
    if (this.#dead) return
    hear({ kind: "begun" })
    this.#worker.postMessage(job)
    warmUp(this.#base)
  }

  end() {
    this.#dead = true
    this.#worker.terminate()
    if (next === this) next = null
    if (used === this) used = null
  }
}

/** The one for the next run, if it was asked for. */
let next = null

/** One whose run has ended. It is kept until the next one is ready. */
let used = null

/** Have a worker ready for the next run. */
export function warmUp(base) {
  next ??= new Runner(base)
}

/** Run a job in a worker of its own, which is returned; `hear` is called with what comes of it. */
export function start(base, job, hear) {
  warmUp(base)
  const runner = next
  next = null
  runner.run(job, hear)
  return runner
}

/** Give back a worker whose run has ended by itself. */
export function release(runner) {
  used?.end()
  if (next?.ready) runner.end()
  else used = runner
}
