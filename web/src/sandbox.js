// All that the page of a sandbox does: it starts the worker that it is sent, which judges one answer. The page and its
// worker have an origin of their own and may ask for nothing: see web/build.mjs for the policy.

addEventListener(
  "message",
  ({ data, ports }) => {
    const address = URL.createObjectURL(new Blob([data.worker], { type: "text/javascript" }))
    const buffers = Object.values(data).filter((value) => value instanceof ArrayBuffer)
    new Worker(address, { type: "module" }).postMessage(data, [...ports, ...buffers])
  },
  { once: true },
)
