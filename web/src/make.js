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
 * The element, known to be there, that this selector finds.
 *
 * @type {(selector: string, within?: ParentNode) => HTMLElement}
 */
export const find = (selector, within = document) => /** @type {HTMLElement} */ (within.querySelector(selector))

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
