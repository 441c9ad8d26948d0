// Python in the worker of a sandbox: judges one answer. It is sent all that it needs, and can ask for nothing.

import { loadPyodide } from "pyodide/pyodide.mjs"
import { info } from "pyodide/pyodide-lock.json"
import { signals } from "./signals.js"
import { install, options } from "./start.js"

// Where Pyodide believes that its files are.
const NOWHERE = "memory:/"

async function start({ module, wasm, stdlib, rosspin, snapshot }) {
  globalThis.fetch = async () => new Response(stdlib) // there is nothing else that it asks for
  WebAssembly.instantiateStreaming = async (_, imports) => {
    return { module: wasm, instance: await WebAssembly.instantiate(wasm, imports) }
  }
  const address = URL.createObjectURL(new Blob([module], { type: "text/javascript" }))
  const { default: createPyodideModule } = await import(address)
  const silent = { stdout() {}, stderr() {}, stdin: () => null }
  const given = { ...options(info), ...silent, indexURL: NOWHERE, createPyodideModule }
  const python = await loadPyodide({ ...given, _loadSnapshot: snapshot && Promise.resolve(snapshot) })
  install(python, new Uint8Array(rosspin))
  return python
}

addEventListener(
  "message",
  async ({ data, ports: [port] }) => {
    const say = port.postMessage.bind(port) // which no answer can get hold of
    const fail = (error) => say(JSON.stringify({ verdict: "not judged", said: `Python itself broke down: ${error}` }))
    addEventListener("unhandledrejection", ({ reason }) => fail(reason)) // as after os.abort()
    try {
      const python = await start(data).catch(() => start({ ...data, snapshot: null }))
      const { judge, wake } = python.pyimport("rosspin.page")
      wake()
      python.setInterruptBuffer(signals)
      say("begun")
      signals.last = performance.now()
      say(await judge.callPromising(data.number, data.answer))
    } catch (error) {
      fail(error)
    }
  },
  { once: true },
)
