// The time of something that plays once from its beginning to its end, and can be paused. All times in seconds.

export class Play {
  #length
  #time = 0
  #since = NaN // the reader's time at which it was played on

  /** @param {number} length */
  constructor(length) {
    this.#length = length
  }

  get plays() {
    return !Number.isNaN(this.#since)
  }

  /**
   * Play on, or pause; from the beginning if it has come to its end.
   *
   * @param {number} now the reader's time
   */
  toggle(now) {
    const time = this.at(now)
    this.#time = time < this.#length ? time : 0
    this.#since = this.plays ? NaN : now
  }

  /**
   * How far it has come. At its end it pauses.
   *
   * @param {number} now the reader's time
   */
  at(now) {
    if (!this.plays) return this.#time
    const time = Math.min(this.#time + now - this.#since, this.#length)
    if (time === this.#length) [this.#time, this.#since] = [time, NaN]
    return time
  }

  /** Back to the beginning. */
  stop() {
    this.#time = 0
    this.#since = NaN
  }
}
