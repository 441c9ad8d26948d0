// All that the page of a sandbox does. It is sent first what a worker needs, then answers, one at a time, and starts a
// worker for each, which ends the one before it. The page and its workers have an origin of their own, and may ask for
// nothing: web/build.mjs has their policy.

let given
let worker

async function prepare({ script, wasm, ...files }) {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }))
  return { address, files: { ...files, wasm: await WebAssembly.compile(wasm) } }
}

addEventListener("message", async ({ data, ports }) => {
  if (data.script) {
    given = prepare(data)
    return
  }
  const { address, files } = await given
  worker?.terminate()
  worker = new Worker(address)
  worker.postMessage({ ...files, ...data }, ports)
})
