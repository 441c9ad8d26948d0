// What a C++ node of ROS 2 asks, answered for a process that is alone: its own topics and services, and what its command line
// says. See ros2.py, which answers where there are others.

const FORMAT = "[{severity}] [{time}] [{name}]: {message}"
const LEVELS = { unset: 0n, debug: 10n, info: 20n, warn: 30n, error: 40n, fatal: 50n }
const [RELIABLE, BEST_EFFORT, TRANSIENT_LOCAL, VOLATILE] = [1n, 2n, 1n, 2n]
const [RELIABILITY, DURABILITY] = [16n, 2n] // kinds of policies

/** An answer that is an error. */
class Refused extends Error {
  constructor(answer) {
    super(answer.text)
    this.answer = answer
  }
}

export class Ros2 {
  #host
  #contexts = []
  #nodes = []
  #publishers = []
  #subscriptions = []
  #services = []
  #clients = []
  #requests = new Map() // those that are not answered, by their numbers: whose they are

  /** `host` has `event(what, values)`, which gives something to the node as soon as it waits, `now`,
   * `logLine(level, name, text)`, and `refuse(what)`, which ends the run.
   */
  constructor(host) {
    this.#host = host
  }

  asked = Object.fromEntries(
    Object.entries({
      init: (words, withLogging) => this.#init(words, withLogging),
      node: (context, name, space, words, useGlobal) => this.#node(context, name, space, words, useGlobal),
      resolve: (node, name, isService, onlyExpand) => ({ name: this.#resolve(node, name, isService, onlyExpand) }),
      publisher: (node, topic, kind, qos, events) => {
        const end = { ...this.#end(node, topic, kind, qos, events), kept: [], sent: 0n, isPublisher: true }
        end.id = add(this.#publishers, end)
        for (const each of this.#subscriptions) this.#join(end, each)
        return { id: end.id, name: end.name }
      },
      subscription: (node, topic, kind, qos, events) => {
        const end = { ...this.#end(node, topic, kind, qos, events), isPublisher: false }
        if (end.name === "/rosout") this.#host.refuse("in a page, /rosout for a node that runs alone")
        const id = (end.id = add(this.#subscriptions, end))
        for (const each of this.#publishers) {
          this.#join(each, end)
          if (!meet(each, end) || qos.durability !== TRANSIENT_LOCAL) continue
          each.kept.forEach((message) => this.#host.event("message", [id, ...message]))
        }
        return { id, name: end.name }
      },
      subscription_count: (number) => BigInt(this.#subscriptions.filter((each) => meet(this.#publishers[number], each)).length),
      publisher_count: (number) => BigInt(this.#publishers.filter((each) => meet(each, this.#subscriptions[number])).length),
      service: (node, name, kind) => {
        const full = this.#resolve(node, name, true)
        return { id: add(this.#services, { name: full, kind }), name: full }
      },
      client: (node, name, kind) => {
        const full = this.#resolve(node, name, true)
        return { id: add(this.#clients, { name: full, kind, sent: 0n }), name: full }
      },
      service_is_ready: (number) => this.#server(number) >= 0,
      send_request: (number, data) => {
        const sequence = ++this.#clients[number].sent
        const server = this.#server(number)
        if (server >= 0) {
          const key = BigInt(this.#requests.size + 1)
          this.#requests.set(key, [number, sequence])
          this.#host.event("request", [BigInt(server), key, data])
        }
        return sequence
      },
      node_names: () => ({ names: this.#nodes.filter(Boolean).map(({ full }) => full) }),
    }).map(([what, answer]) => [what, (...values) => refused(() => answer(...values))]),
  )

  told = {
    shutdown: () => {},
    assert_liveliness: () => {},
    publish: (number, data) => {
      const publisher = this.#publishers[number]
      const message = [data, this.#host.now, this.#host.now, ++publisher.sent]
      if (publisher.qos.durability === TRANSIENT_LOCAL) publisher.kept = [...publisher.kept, message].slice(-Number(publisher.qos.depth))
      this.#subscriptions.forEach((each, place) => {
        if (meet(publisher, each)) this.#host.event("message", [BigInt(place), ...message])
      })
    },
    parameter_event: (_node, data) => {
      this.#subscriptions.forEach(({ name, ended }, place) => {
        if (name === "/parameter_events" && !ended) this.#host.event("message", [BigInt(place), data, this.#host.now, this.#host.now, 1n])
      })
    },
    respond: (_service, number, data) => {
      const [client, sequence] = this.#requests.get(number)
      if (!this.#clients[client].ended) this.#host.event("response", [client, sequence, data])
    },
    end_node: (number) => delete this.#nodes[number],
    end_publisher: (number) => this.#part(this.#publishers[number]),
    end_subscription: (number) => this.#part(this.#subscriptions[number]),
    end_service: (number) => (this.#services[number].ended = true),
    end_client: (number) => (this.#clients[number].ended = true),
  }

  #end(node, topic, kind, qos, events) {
    if (events.includes("deadline") && finite(qos.deadline)) this.#host.refuse("in a page, a deadline")
    if (events.includes("liveliness") && finite(qos.liveliness_lease_duration)) this.#host.refuse("in a page, liveliness")
    return { name: this.#resolve(node, topic, false), kind, qos, events, counts: {} }
  }

  /** Tell two ends that they match, or by which policy they do not. */
  #join(publisher, subscription) {
    if (meet(publisher, subscription)) this.#tell(publisher, subscription, 1n)
    else if (meet({ ...publisher, qos: subscription.qos }, subscription)) {
      const policy = mismatch(publisher, subscription)
      for (const end of [publisher, subscription]) this.#happen(end, "incompatible_qos", { total: 1n }, { last_policy_kind: policy })
    }
  }

  #part(end) {
    for (const each of end.isPublisher ? this.#subscriptions : this.#publishers) {
      const pair = end.isPublisher ? [end, each] : [each, end]
      if (meet(...pair)) this.#tell(...pair, -1n)
    }
    end.ended = true
  }

  #tell(publisher, subscription, change) {
    const total = change > 0n ? change : 0n
    for (const end of [publisher, subscription]) this.#happen(end, "matched", { total, current: change })
    this.#happen(subscription, "liveliness", { alive: change, not_alive: 0n })
  }

  /** Tell an end's events of changes of its counts, if they are wanted. */
  #happen({ events, counts, isPublisher, id }, name, changes, info = {}) {
    if (!events.includes(name)) return
    for (const [count, change] of Object.entries(changes)) {
      const key = `${name} ${count}`
      counts[key] = (counts[key] ?? 0n) + change
      info = { ...info, [`${count}_count`]: counts[key], [`${count}_count_change`]: change }
    }
    this.#host.event("happened", [isPublisher, id, name, info])
  }

  #server(client) {
    const { name, kind } = this.#clients[client]
    return this.#services.findIndex((each) => !each.ended && each.name === name && each.kind === kind)
  }

  #init(words, withLogging) {
    let read
    try {
      read = new Arguments(words)
    } catch (error) {
      if (error.answer?.error === "arguments") this.#host.logLine("ERROR", "rcl", "Failed to parse global arguments")
      throw error
    }
    for (const word of withLogging ? read.deprecated : []) {
      const instead = `Use '--ros-args --remap ${word}' instead.`
      this.#host.logLine("WARN", "rcl", `Found remap rule '${word}'. This syntax is deprecated. ${instead}`)
    }
    const { level, levels, console } = read
    return { id: add(this.#contexts, read), level, levels, console, form: FORMAT, to_stdout: false, coloured: false }
  }

  #node(context, name, space, words, useGlobal) {
    const own = words.includes("--ros-args") ? words.slice(words.indexOf("--ros-args")) : []
    const all = [new Arguments(own), ...(useGlobal ? [this.#contexts[context]] : [])]
    check("node name", name, NODE_NAME)
    const whole = space === "" || space.startsWith("/") ? space || "/" : `/${space}`
    check("namespace", whole, NAMESPACE)
    const remapped = (source, otherwise) =>
      all.flatMap(({ rules }) => rules).find((rule) => rule.source === source && (!rule.node || rule.node === name))?.target ?? otherwise
    const node = { name: remapped("__node", name), space: remapped("__ns", whole), all }
    node.full = `${node.space.replace(/\/$/, "")}/${node.name}`
    const found = all.map((each) => each.parameters(node.full)).reverse()
    const overrides = Object.assign({}, ...found)
    node.logger = node.full.slice(1).replaceAll("/", ".")
    const id = add(this.#nodes, node)
    return { id, name: node.name, namespace: node.space, "full name": node.full, logger: node.logger, overrides }
  }

  /** The full name of a topic or a service of a node. */
  #resolve(number, name, isService, onlyExpand = false) {
    const node = this.#nodes[number]
    const what = isService ? "service name" : "topic name"
    check(what, name, TOPIC)
    const full = expanded(name, node)
    check(what, full, FULL_TOPIC)
    if (onlyExpand) return full
    const rules = node.all.flatMap(({ rules }) => rules).filter((rule) => !rule.source.startsWith("__"))
    const rule = rules.find((rule) => (!rule.node || rule.node === node.name) && expanded(rule.source, node) === full)
    return rule ? expanded(rule.target, node) : full
  }
}

const add = (list, each) => BigInt(list.push(each) - 1)

const meet = (publisher, subscription) =>
  publisher.name === subscription.name &&
  publisher.kind === subscription.kind &&
  !publisher.ended &&
  !subscription.ended &&
  !mismatch(publisher, subscription)

/** The kind of the policy by which a subscription asks for more than a publisher offers; 0n if they match. */
function mismatch({ qos: offered }, { qos: requested }) {
  if (requested.reliability === RELIABLE && offered.reliability === BEST_EFFORT) return RELIABILITY
  return requested.durability === TRANSIENT_LOCAL && offered.durability === VOLATILE ? DURABILITY : 0n
}

/** Whether a length of time (ns) is one: 0 and the longest are none. */
const finite = (length) => length > 0n && length < (1n << 63n) - 1n

function refused(answer) {
  try {
    return answer()
  } catch (error) {
    if (error instanceof Refused) return error.answer
    throw error
  }
}

// --- a command line: see rclpy/arguments.py ---

const RULE = /^(?:(\w+):)?([^\s:=]+):=([^]+)$/

class Arguments {
  rules = []
  values = [] // of parameters: the node, the name, the value
  level = LEVELS.info
  levels = {}
  console = true
  deprecated = [] // rules as ROS 1 writes them

  constructor(words) {
    const unknown = []
    const options = {
      "-r": [this.#remap, "remap rule"],
      "--remap": [this.#remap, "remap rule"],
      "-p": [this.#set, "parameter override rule"],
      "--param": [this.#set, "parameter override rule"],
      "--params-file": [() => fail("Error opening YAML file"), "params file"],
      "--log-level": [this.#setLevel, "log level"],
      "-e": [() => {}, "value"],
      "--enclave": [() => {}, "value"],
      "--log-config-file": [() => {}, "value"],
    }
    for (let at = 0; at < words.length; at++) {
      if (words[at] !== "--ros-args") {
        this.#userWord(words[at])
        continue
      }
      for (at++; at < words.length && words[at] !== "--"; at++) {
        const flag = words[at]
        if (flag in options) {
          const [use, what] = options[flag]
          const failed = "failed to initialize rcl: Couldn't parse"
          if (++at >= words.length) refuse(`${failed} trailing ${flag} flag. No ${what} found.`)
          try {
            use.call(this, words[at])
          } catch (error) {
            refuse(`${failed} ${what}: '${flag} ${words[at]}'. Error: ${error.message}`)
          }
        } else if (flag.endsWith("able-stdout-logs")) this.console = flag === "--enable-stdout-logs"
        else if (flag !== "--ros-args" && !/able-(rosout|external-lib)-logs$/.test(flag)) unknown.push(flag)
      }
    }
    if (unknown.length) throw new Refused({ error: "unknown arguments", words: unknown })
  }

  #userWord(word) {
    if (/^_[^_]/.test(word)) return
    try {
      this.#remap(word)
      this.deprecated.push(word)
    } catch {} // it is the node's
  }

  #remap(text) {
    const [, node, source, target] = text.match(RULE) ?? fail(`Expected lexeme type (19) not found, search ended at index ${text.length}`)
    const isNode = source === "__node" || source === "__name"
    if (source === "__ns") {
      if (!/^(\/|(\/[a-zA-Z_]\w*)+)$/.test(target)) fail("Namespace not remapped to a fully qualified name")
    } else if (!(isNode ? /^[a-zA-Z_]\w*$/ : /^~?(\/?[a-zA-Z_{][\w{}]*)*$/).test(target)) fail("error not set")
    this.rules.push({ node, source: isNode ? "__node" : source, target })
  }

  #set(text) {
    const [, node, name, value] = text.match(RULE) ?? fail(`Expected lexeme type (22) not found, search ended at index ${text.length}`)
    this.values.push([node ? `/${node}` : "/**", name, parameter(value.trim())])
  }

  #setLevel(text) {
    const at = text.lastIndexOf(":=")
    const level = LEVELS[text.slice(at < 0 ? 0 : at + 2).toLowerCase()] ?? fail("Argument does not use a valid severity level")
    if (at > 0) this.levels[text.slice(0, at)] = level
    else this.level = level
  }

  /** The values for the parameters of a node. Of several the last is taken, of the node named last. */
  parameters(full) {
    const nodes = [...new Set(this.values.map(([node]) => node))].filter((node) => node === "/**" || node === full)
    const found = nodes.flatMap((node) => this.values.filter(([each]) => each === node))
    return Object.fromEntries(found.map(([, name, value]) => [name, value]))
  }
}

function fail(text) {
  throw new Error(text)
}

function refuse(text) {
  throw new Refused({ error: "arguments", text })
}

/** A parameter's value as rcl reads it, of YAML a scalar or a list of such in one line. */
function parameter(text) {
  if (text.startsWith("[") && text.endsWith("]")) {
    const items = text.slice(1, -1).match(/\s*("([^"\\]|\\.)*"|'([^']|'')*'|[^,]+)\s*/g) ?? []
    const values = items.map((item) => parameter(item.trim()))
    if (new Set(values.map((value) => typeof value)).size > 1) fail("Sequence should be of same type")
    return values.length ? values : null
  }
  if (/^"([^"\\]|\\["\\])*"$/.test(text)) return text.slice(1, -1).replace(/\\(.)/g, "$1")
  if (/^'([^']|'')*'$/.test(text)) return text.slice(1, -1).replaceAll("''", "'")
  if (/^[[{&*!|>'"%@`]/.test(text) || text === "" || /: |:$/.test(text)) fail("Unknown YAML event")
  if (/^(y|yes|on|true)$/i.test(text)) return true
  if (/^(n|no|off|false)$/i.test(text)) return false
  if (/^[-+]?(0x[0-9a-f]+|0[0-7]*|[1-9]\d*)$/i.test(text)) {
    const digits = text.replace(/^[-+]/, "").replace(/^0(?=[0-7])/, "0o")
    const whole = text.startsWith("-") ? -BigInt(digits) : BigInt(digits)
    return BigInt.asIntN(64, whole) === whole ? whole : Number(whole)
  }
  if (/^[-+]?(\d+\.?\d*(e[-+]?\d+)?|\.\d+(e[-+]?\d+)?)$/i.test(text)) return Number(text)
  if (/^[-+]?\.?(inf|Inf|INF)$/.test(text)) return text.startsWith("-") ? -Infinity : Infinity
  return /^[-+]?\.?(nan|NaN|NAN)$/.test(text) ? NaN : text
}

// --- names: see rclpy/names.py ---

const NODE_NAME = [
  [/^$/d, "node name must not be empty"],
  [/\W/d, "node name must not contain characters other than alphanumerics or '_'"],
  [/^\d/d, "node name must not start with a number"],
  [/^.{254}(.)./d, "node name length should not exceed '255'"],
]
const NAMESPACE = [
  [/^[^/]/d, "namespace must be absolute, it must lead with a '/'"],
  [/.(\/)$/d, "namespace must not end with a '/', unless only a '/'"],
  [/[^\w/]/d, "namespace must not contain characters other than alphanumerics, '_', or '/'"],
  [/\/(\/)/d, "namespace must not contain repeated '/'"],
  [/\/(\d)/d, "namespace must not have a token that starts with a number"],
  [/^.{244}(.)./d, "namespace should not exceed '245'"],
]
const TOPIC = [
  [/^$/d, "topic name must not be empty string"],
  [/^\d/d, "topic name token must not start with a number"],
  [/\/$/d, "topic name must not end with a forward slash"],
  [/[^\w/~{}]/d, "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"],
  [/.(~)/d, "topic name must not have tilde '~' unless it is the first character"],
  [/\{(?!\w*\})|^[^{]*(\})/d, "topic name must not have unmatched (unbalanced) curly braces '{}'"],
  [/^~([^/])./d, "topic name must not have a tilde '~' that is not followed by a forward slash '/'"],
  [/\/(\d)/d, "topic name token must not start with a number"],
]
const FULL_TOPIC = [
  [/\/(\/)/d, "topic name must not contain repeated '/'"],
  [/^.{246}(.)./d, "topic length should not exceed '255U - 8U'"],
]

function check(what, name, rules) {
  for (const [pattern, said] of rules) {
    const found = name.match(pattern)
    if (!found) continue
    const at = (found.indices[1] ?? found.indices[0])[0]
    throw new Refused({ error: what, text: `Invalid ${what}: ${said}:\n  '${name}'\n   ${" ".repeat(at)}^\n` })
  }
}

function expanded(name, { name: node, space }) {
  const words = { node, ns: space, namespace: space }
  const filled = name.replace(/\{(\w*)\}/g, (_, word) => words[word] ?? refuse(`unknown substitution: {${word}}`))
  const below = space.replace(/\/$/, "")
  if (filled.startsWith("~")) return `${below}/${node}${filled.slice(1)}`
  return filled.startsWith("/") ? filled : `${below}/${filled}`
}
