// Python is interrupted so often (ms) while it does not give way: see src/rosspin/clocks/watchdog.py.
const LOOK = 400

/** Stands for the shared memory through which Python is told of signals: it looks there every now and then. */
export const signals = {
  last: Infinity, // when (ms) it was interrupted last
  get 0() {
    if (performance.now() < this.last + LOOK) return 0
    this.last = performance.now()
    return 2 // SIGINT
  },
  set 0(_) {},
}
