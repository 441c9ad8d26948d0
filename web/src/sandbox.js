// All that the page of a sandbox does. It starts a worker, is sent its script, once, and passes on what the page
// and the worker say to each other: from the worker no more than the page can bear, in each message and in each second. What is packed it unpacks, since the
// worker has other things to do. Both have an origin that nothing else has, and may ask for nothing: web/build.mjs has their
// policy.

import { LONGEST, PER_SECOND, room } from "./limits.js"

const unpack = (/** @type {ArrayBuffer} */ bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer()

const blob = (/** @type {string | ArrayBuffer} */ script) =>
  URL.createObjectURL(new Blob([script], { type: "text/javascript" }))

/** A worker that becomes what the first message says. It takes as long to start as its script to come. */
const BLANK = `onmessage = ({ data }) => {
  onmessage = null
  importScripts(data)
}`

/**
 * @param {Worker} worker
 * @param {Promise<ErrorEvent>} broken
 * @param {ArrayBuffer} script
 * @param {MessagePort} port
 */
function begin(worker, broken, script, port) {
  worker.postMessage(blob(script))
  const end = (/** @type {string} */ reason) => {
    worker.onmessage = null
    worker.terminate()
    port.postMessage(JSON.stringify({ kind: "failed", reason }))
  }
  /** @type {import("./limits.js").Kind | null} */
  let job = null
  let [left, since] = [0, 0] // how much room there is for messages, and when (ms) it was so much
  const most = () => LONGEST[job ?? ""].characters + PER_SECOND
  const grant = (/** @type {import("./limits.js").Kind | null} */ kind) => {
    job = kind
    left = most()
    since = performance.now()
  }
  grant(null)
  worker.onmessage = ({ data }) => {
    const now = performance.now()
    left = Math.min(left + ((now - since) / 1e3) * PER_SECOND, most()) - room(data, job)
    since = now
    if (left >= 0) port.postMessage(data)
    else end("It was ended: it sent more than this page takes.")
  }
  broken.then(({ message }) => end(`It was ended by an error: ${message?.slice(0, 500) ?? "its worker could not be started"}`))
  port.onmessage = async ({ data }) => {
    if (data.kind !== "file") grant(data.kind)
    if (data.bytes && data.name.endsWith(".gz")) data.bytes = await unpack(data.bytes).catch(() => null)
    worker.postMessage(data, data.bytes ? [data.bytes] : [])
  }
}

// Opened as a page, or in a frame that shares its origin with the site, it does nothing.
if (self.origin === "null" && parent !== self) {
  const worker = new Worker(blob(BLANK))
  const broken = new Promise((resolve) => (worker.onerror = resolve))
  let begun = false
  addEventListener("message", ({ source, data, ports: [port] }) => {
    if (source !== parent || begun || !port) return
    begun = true
    begin(worker, broken, data, port)
  })
  parent.postMessage("here", "*")
}
