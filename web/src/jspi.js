/** Whether Python can run here, and if it cannot, what is missing: the rest of a sentence. */
export const HAS_JSPI = "Suspending" in (globalThis.WebAssembly ?? {})
export const LACKS_JSPI =
  "it lacks JSPI, which Chrome and Edge have from version 137, Firefox from 153 and Safari from 27."
