// A C++ node that runs beside others in a page: it is suspended (JSPI) while they have something to do.

import { Node } from "./node.mjs"
import { COLOURS } from "./values.mjs"

export class Beside {
  #module
  #reply = null // gives it what it waits for
  #batches = []
  #tell = () => {}

  constructor(module) {
    this.#module = module
  }

  /**
   * Begin the node, or continue it with the host's answer (JSON): a promise of the batches until it waits, or has ended.
   * In each the ticks are bytes, and the `text` is JSON of the rest: see node.mjs.
   */
  goOn(text) {
    const { promise, resolve } = Promise.withResolvers()
    this.#tell = resolve
    if (this.#reply) this.#reply(JSON.parse(text))
    else this.#begin(JSON.parse(text))
    return promise
  }

  #begin(start) {
    const wait = (batch) => {
      const { promise, resolve } = Promise.withResolvers()
      this.#reply = resolve
      this.#pass(batch)
      this.#told()
      return promise
    }
    const node = new Suspended(this.#module, start, wait, (batch) => this.#pass(batch))
    node.runSuspended(true).then(() => this.#told(), (error) => this.#tell(Promise.reject(error)))
  }

  #pass({ ticks, ...rest }) {
    this.#batches.push({ ticks, text: JSON.stringify(rest) })
  }

  #told() {
    this.#tell(this.#batches.splice(0))
  }
}

class Suspended extends Node {
  print(fd, text) {
    super.print(fd, text.replace(COLOURS, ""))
  }
}
