// The threads of a program: each has a stack of its own, which is suspended (JSPI) while another runs. Which one that
// is, the program says (see runtime/threads.cpp).

/** Whether a program begins threads, and can do so here. */
export const hasThreads = (module) => HAS_JSPI && WebAssembly.Module.imports(module).some(({ name }) => name === "thread")

const HAS_JSPI = "Suspending" in WebAssembly

export class Threads {
  /** A promise that fails as soon as a thread does: that has ended the program. */
  failed
  #fail
  #goOn = new Map() // how each one that waits continues, by its number

  constructor(program) {
    this.failed = new Promise((_, reject) => (this.#fail = reject))
    this.failed.catch(() => {}) // whoever runs the program hears of it
    const turn = (from, to) =>
      new Promise((goOn) => {
        const next = this.#goOn.get(to)
        this.#goOn.set(from, goOn)
        next()
      })
    this.imports = {
      thread: (body, thread) => {
        const begin = () => WebAssembly.promising(program.exports.__indirect_function_table.get(body))(thread).catch(this.#fail)
        this.#goOn.set(thread, () => queueMicrotask(begin)) // not on the stack of the one before
        return HAS_JSPI
      },
      turn: HAS_JSPI ? new WebAssembly.Suspending(turn) : turn,
      leave: (to) => this.#goOn.get(to)(),
    }
  }
}
