// Paints what changes, with the next frame of the page; and so that whatever comes, most of the time is left to the reader.

/** Painting takes no more than one part of so many. */
const PARTS = 5

export class Painter {
  #paint
  #isWanted = false
  #isBusy = false // it waits for a frame, or rests

  /** @param {() => void} paint */
  constructor(paint) {
    this.#paint = paint
  }

  /** Paint as soon as that may be. */
  soon() {
    this.#isWanted = true
    if (!this.#isBusy) this.#ask()
  }

  #ask() {
    this.#isBusy = true
    requestAnimationFrame((start) => {
      this.now()
      // What has been painted is laid out after this, which takes time, too.
      setTimeout(() => setTimeout(() => this.#rested(), (PARTS - 1) * (performance.now() - start)))
    })
  }

  #rested() {
    this.#isBusy = false
    if (this.#isWanted) this.#ask()
  }

  /** Paint immediately, if something should be painted. */
  now() {
    if (!this.#isWanted) return
    this.#isWanted = false
    this.#paint()
  }

  /** Do not paint what should be painted. */
  clear() {
    this.#isWanted = false
  }
}
