// What the build and the scripts of a page leave for others: see web/build.mjs and hand-in.js.

/** The SHA-256 of each file that Python starts from. */
declare const FILES: Record<string, string>

/** The version of runs.js that belongs to this page. */
declare const RUNS: string

/** The exercises by their names, with what is shown of them. */
declare const EXERCISES: Record<string, { number: number; title: string }>

/** Rules that Python has, too: see rosspin/site/rules.py. */
declare const RULES: {
  numbered: string[]
  handIns: { file: number; answer: number; name: number; time: number; said: number; entries: number }
  cpp: { advice: [pattern: string, meaning: string][]; warnings: string[]; includes: string } & Record<
    "lengths" | "notes" | "ofNoPlace",
    string
  >
  timeline: {
    colours: string[]
    title: string
  } & Record<
    | ("kinds" | "top" | "row" | "ticks" | "reach" | "bar" | "axis" | "steps" | "above" | "mostAbove" | "many" | "columns")
    | ("close" | "margin"),
    number
  >
}

/** What workers have. */
declare class FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer
}

interface Window {
  /** The answers to exercises; on pages that have some. */
  rosspinStore?: import("./store.js").Store
}
