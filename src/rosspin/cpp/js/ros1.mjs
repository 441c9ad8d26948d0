// What a C++ node of ROS 1 asks, answered for one that is alone: its own topics, and a parameter server. See ros1.py, which
// answers where there are others.

export class Ros1 {
  #name = ""
  #hasRosout = false
  #publications = []
  #subscriptions = []
  #services = new Map() // their names, and the names of their requests
  #calls = [] // the numbers that the node has for them
  #parameters = {}
  #event

  /** `host.event(what, values)` gives something to the node as soon as it waits. */
  constructor(host) {
    this.#event = (what, values) => host.event(what, values)
  }

  asked = {
    init: (name, parameters, hasRosout) => {
      this.#name = name
      this.#hasRosout = hasRosout
      for (const [each, text] of Object.entries(parameters)) this.asked.set_param(each, fromCommandLine(text))
    },
    advertise: (topic, kind, _size, latches, isTold) => {
      const number = BigInt(this.#publications.push({ topic, kind, latches, isTold, last: null, ended: false }) - 1)
      if (this.asked.subscribers(number)) this.#connect(number, true)
      return number
    },
    subscribe: (topic, kind) => {
      const number = BigInt(this.#subscriptions.push({ topic, kind, ended: false }) - 1)
      this.#publications.forEach((each, place) => {
        if (!meet(each, this.#subscriptions[number])) return
        if (each.last) this.#event("message", [number, each.last, this.#name])
        if (this.#others(this.#subscriptions, each).length === 1) this.#connect(BigInt(place), true)
      })
      return number
    },
    nodes: () => [this.#name],
    topics: () => [...(this.#hasRosout ? [["/rosout", "rosgraph_msgs/Log"]] : []), ...this.#topics()],
    subscribers: (number) => BigInt(this.#others(this.#subscriptions, this.#publications[number]).length > 0),
    publishers: (number) => BigInt(this.#others(this.#publications, this.#subscriptions[number]).length > 0),
    advertise_service: (name, request) => void this.#services.set(name, request),
    service_exists: (name) => this.#services.has(name),
    get_param: (name) => parts(name).reduce((at, part) => at?.[part], this.#parameters),
    has_param: (name) => this.asked.get_param(name) !== undefined,
    set_param: (name, value) => {
      const [last, ...above] = parts(name).reverse()
      let at = this.#parameters
      for (const part of above.reverse()) at = isTable(at[part]) ? at[part] : (at[part] = {})
      at[last] = value
    },
    delete_param: (name) => {
      const found = this.asked.has_param(name)
      const [last, ...above] = parts(name).reverse()
      if (found) delete this.asked.get_param(above.reverse().join("/"))[last]
      return found
    },
    search_param: (space, name) => {
      if (name.startsWith("/")) return this.asked.has_param(name) ? name : null
      const above = parts(space)
      for (let count = above.length; count >= 0; count--) {
        const around = ["", ...above.slice(0, count), ""].join("/")
        if (this.asked.has_param(around + parts(name)[0])) return around + name
      }
      return null
    },
    param_names: () => leaves("", this.#parameters),
  }

  told = {
    publish: (number, data) => {
      const publication = this.#publications[number]
      if (publication.latches && !publication.ended) publication.last = data
      this.told.publish_to(number, 0n, data)
    },
    // All that subscribe are one node.
    publish_to: (number, _link, data) =>
      this.#subscriptions.forEach((each, place) => {
        if (meet(this.#publications[number], each)) this.#event("message", [BigInt(place), data, this.#name])
      }),
    unadvertise: (number) => (this.#publications[number].ended = true),
    unsubscribe: (number) => {
      const met = this.#publications.map((each) => meet(each, this.#subscriptions[number]))
      this.#subscriptions[number].ended = true
      met.forEach((was, place) => was && !this.asked.subscribers(place) && this.#connect(BigInt(place), false))
    },
    unadvertise_service: (name) => this.#services.delete(name),
    call: (number, _client, _persistent, name, request, data) => {
      if (this.#services.get(name) !== request) this.#event("response", [number, false, false, ""])
      else this.#event("request", [name, BigInt(this.#calls.push(number) - 1), data, this.#name])
    },
    respond: (number, isOk, data) => this.#event("response", [this.#calls[number], true, isOk, data]),
    shutdown: () => this.#event("shutdown", []),
  }

  /** Tell that the node itself subscribes to what it publishes, or no longer does. */
  #connect(number, connects) {
    if (this.#publications[number].isTold) this.#event("connect", [number, connects, this.#name, 0n])
  }

  /** The topics that it publishes, and their types. */
  #topics() {
    return [...new Map(this.#publications.filter(({ ended }) => !ended).map(({ topic, kind }) => [topic, kind]))]
  }

  #others(all, end) {
    return all.filter((each) => meet(each, end))
  }
}

const meet = (one, other) =>
  one.topic === other.topic && !one.ended && !other.ended && (one.kind === other.kind || [one.kind, other.kind].includes("*"))

const parts = (name) => name.split("/").filter(Boolean)
const isTable = (value) => typeof value === "object" && value !== null && !Array.isArray(value)
const leaves = (above, table) =>
  Object.entries(table).flatMap(([name, value]) => (isTable(value) ? leaves(`${above}/${name}`, value) : [`${above}/${name}`]))

/** Read a value as roscpp does (source: roscpp/param.cpp, init). */
function fromCommandLine(text) {
  if (/^[-+]?\d+$/.test(text)) return BigInt(text.replace("+", ""))
  if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text)) return Number(text)
  if (["true", "True", "TRUE"].includes(text)) return true
  return ["false", "False", "FALSE"].includes(text) ? false : text
}
