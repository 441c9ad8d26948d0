// Watches, in a thread of its own, whether the process still exchanges something with its host. A node that computes for
// long, and does not, is in an endless loop; it is asked where. (In real time, a run ends when its time is over.)

import { Session } from "node:inspector"
import { workerData } from "node:worker_threads"

const LOOK = 200 // ms

let seen = -1 // how many exchanges there were
let begun = 0 // what the process had used then

const watching = setInterval(() => {
  const exchanges = Atomics.load(workerData, 0)
  const most = Atomics.load(workerData, 1)
  const { user, system } = process.cpuUsage() // µs
  if (exchanges !== seen || !most) {
    seen = exchanges
    begun = user + system
  } else if (user + system - begun > most * 1000) {
    clearInterval(watching)
    ask()
  }
}, LOOK)

function ask() {
  const session = new Session()
  session.connectToMainThread()
  session.post("Runtime.evaluate", { expression: "standStill()" }) // between two instructions of the loop
  setInterval(() => {}, LOOK) // until the host ends the process
}
