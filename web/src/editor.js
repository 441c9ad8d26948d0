// The editor, loaded when a reader first wants to change a listing.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands"
import { cpp, cppLanguage } from "@codemirror/lang-cpp"
import { python, pythonLanguage } from "@codemirror/lang-python"
import { bracketMatching, indentUnit, syntaxHighlighting } from "@codemirror/language"
import { EditorState, StateEffect, StateField } from "@codemirror/state"
import { Decoration, EditorView, WidgetType, highlightSpecialChars, keymap } from "@codemirror/view"
import { highlightCode, tagHighlighter, tags } from "@lezer/highlight"
import { make } from "./make.js"
import { UNSEEN, sign } from "./unseen.js"

// The classes that Pygments gives to the plain listing, so that the theme colours both alike, in light and in dark.
const likeTheListing = tagHighlighter([
  { tag: tags.comment, class: "c1" },
  { tag: tags.string, class: "s2" },
  { tag: tags.number, class: "mf" },
  { tag: tags.keyword, class: "k" },
  { tag: [tags.bool, tags.null, tags.self], class: "kc" },
  { tag: tags.operatorKeyword, class: "ow" },
  { tag: [tags.operator, tags.definitionOperator], class: "o" },
  { tag: tags.function(tags.definition(tags.variableName)), class: "nf" },
  { tag: tags.definition(tags.className), class: "nc" },
  { tag: tags.meta, class: "nd" },
])

/** @typedef {"python" | "cpp" | "xml"} Language XML is not coloured */

/**
 * A text in pieces, each with the class of its colour.
 *
 * @param {string} text
 * @param {Language} language
 */
export function coloured(text, language) {
  /** @type {[piece: string, colour: string][]} */
  const pieces = []
  const put = (/** @type {string} */ piece, colour = "") => pieces.push([piece, colour])
  if (language === "xml") put(text)
  else highlightCode(text, { python: pythonLanguage, cpp: cppLanguage }[language].parser.parse(text), likeTheListing, put, () => put("\n"))
  return pieces
}

// It takes the place of the listing, and looks like it.
const looksLikeIt = EditorView.theme({
  "&": {
    background: "var(--pst-color-surface)",
    border: "1px solid var(--pst-color-border)",
    borderRadius: "0.25rem",
  },
  ".cm-scroller": { fontFamily: "var(--pst-font-family-monospace)", lineHeight: "1.25", padding: "1rem 0.6rem" },
  ".cm-content": { caretColor: "currentColor", padding: "0" },
})

/** @type {import("@codemirror/state").StateEffectType<import("@codemirror/view").DecorationSet>} */
const runs = StateEffect.define()

// The lines that run, while the reader goes through a run step by step; none once the text has changed.
const running = StateField.define({
  create: () => Decoration.none,
  update: (lines, { effects, docChanged }) =>
    effects.find((effect) => effect.is(runs))?.value ?? (docChanged ? Decoration.none : lines),
  provide: (field) => EditorView.decorations.from(field),
})

/** @type {import("@codemirror/state").StateEffectType<import("@codemirror/view").DecorationSet>} */
const blames = StateEffect.define()

// What the compiler says of places in the text as it was compiled, below their lines; none once that has changed.
const blamed = StateField.define({
  create: () => Decoration.none,
  update: (places, { effects, docChanged }) =>
    effects.find((effect) => effect.is(blames))?.value ?? (docChanged ? Decoration.none : places),
  provide: (field) => EditorView.decorations.from(field),
})

class Said extends WidgetType {
  /** @param {string} text */
  constructor(text) {
    super()
    this.text = text
  }

  toDOM() {
    return make("div", { className: "live-fault", textContent: this.text })
  }
}

const mark = (/** @type {string} */ character) => make("span", { className: "unseen", textContent: sign(character) })

/**
 * An open editor. `write` replaces its text, `goTo` selects a line, counted from 1, `blame` shows what is wrong at places.
 *
 * @typedef {{element: HTMLElement, text(): string, write(text: string): void, focus(): void, goTo(line: number): void,
 *   blame(faults: import("./faults.js").Fault[]): void}} Editor
 */

/**
 * An editor with a text, known to screen readers by a label. It calls `changed(text)` on each change, `run()` on
 * Ctrl-Enter and `leave()` on Escape. Long lines are wrapped if it `wraps`.
 *
 * @param {string} text
 * @param {string} label
 * @param {{language: Language, wraps: boolean, changed: (text: string) => void, run: () => void, leave: () => void}} how
 * @returns {Editor}
 */
export function open(text, label, { language, wraps, changed, run, leave }) {
  const command = (/** @type {() => void} */ act) => () => {
    act()
    return true
  }
  const view = new EditorView({
    state: EditorState.create({
      doc: text,
      extensions: [
        keymap.of([
          { key: "Ctrl-Enter", mac: "Cmd-Enter", run: command(run) },
          { key: "Escape", run: command(leave) },
          indentWithTab,
          ...defaultKeymap,
          ...historyKeymap,
        ]),
        history(),
        bracketMatching(),
        indentUnit.of(language === "python" ? "    " : "  "),
        language === "cpp" ? cpp() : language === "python" ? python() : [],
        highlightSpecialChars({ specialChars: UNSEEN, render: (code) => mark(String.fromCodePoint(code)) }),
        wraps ? EditorView.lineWrapping : [],
        syntaxHighlighting(likeTheListing),
        looksLikeIt,
        running,
        blamed,
        EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false" }),
        EditorView.updateListener.of((update) => update.docChanged && changed(update.state.doc.toString())),
      ],
    }),
  })
  // Sent by stepper.js, which knows no editor.
  view.dom.addEventListener("runs", (event) => {
    const { text, lines } = /** @type {CustomEvent<{text: string, lines: number[]}>} */ (event).detail
    const { doc } = view.state
    const line = Decoration.line({ class: "stepper-running" })
    const starts = doc.toString() === text ? [...lines].sort((a, b) => a - b) : []
    view.dispatch({ effects: runs.of(Decoration.set(starts.map((number) => line.range(doc.line(number).from)))) })
  })
  return {
    element: view.dom,
    text: () => view.state.doc.toString(),
    write: (text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }),
    focus: () => view.focus(),
    blame: (faults) => {
      const { doc } = view.state
      const places = faults.filter(({ line }) => line <= doc.lines).flatMap(({ line, column, text }) => {
        const { from, to } = doc.line(line)
        const at = Math.min(from + column - 1, to)
        const word = /^\w+|^./.exec(doc.sliceString(at, to))?.[0].length ?? 0
        const widget = new Said(`${line}:${column}: ${text}`)
        const said = Decoration.widget({ widget, block: true, side: 1 }).range(to)
        return word ? [Decoration.mark({ class: "live-faulty" }).range(at, at + word), said] : [said]
      })
      view.dispatch({ effects: blames.of(Decoration.set(places, true)) })
    },
    goTo: (number) => {
      const { from, to } = view.state.doc.line(Math.min(number, view.state.doc.lines))
      view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true })
      view.focus()
    },
  }
}
