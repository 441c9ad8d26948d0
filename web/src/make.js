/**
 * An element with these properties and children.
 *
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Partial<Omit<HTMLElementTagNameMap[T], "autocomplete" | "sandbox">> & {autocomplete?: string, sandbox?: string}}
 *   properties
 * @param {(Node | string)[]} children
 */
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties)
  element.append(...children)
  return element
}

/**
 * The element that this selector finds; Error: there is none.
 *
 * @param {string} selector
 * @param {ParentNode} within
 */
export function find(selector, within = document) {
  const found = within.querySelector(selector)
  if (!(found instanceof HTMLElement)) throw new Error(`this page has no ${selector}`)
  return found
}

/** The address of the folder that the script which is being run is in. */
export const here = () => new URL(".", /** @type {HTMLScriptElement} */ (document.currentScript).src)

/**
 * Let the reader save a text as a file.
 *
 * @param {string} name
 * @param {string} type
 * @param {string} text
 */
export function save(name, type, text) {
  const href = URL.createObjectURL(new Blob([text], { type }))
  make("a", { href, download: name }).click()
  setTimeout(() => URL.revokeObjectURL(href), 60_000)
}
