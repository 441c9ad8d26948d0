// The file in which a student hands in answers: JSON with a name, a date and the texts. Python reads it: see
// rosspin/hand_ins/files.py.

/** The file of an answer in C++, as the compiler has it. */
export const ANSWER = "answer.cpp"

/** What compiles C++, and how much that is. */
export const LOADS_CLANG = "this page loads clang once: about 28 MB, which your browser keeps"

/** Whether an answer is in C++, by what it includes: see rosspin/run/kinds/cpp.py. */
export const isCpp = (/** @type {string} */ answer) => new RegExp(RULES.cpp.includes, "m").test(answer)

/** What is read at most: of a file (bytes), of an answer and of a name (characters). */
export const MOST = { file: RULES.handIns.file, answer: RULES.handIns.answer, name: RULES.handIns.name }

/**
 * The text of such a file, made now.
 *
 * @param {string} name
 * @param {string} id what tells students of the same name apart
 * @param {Record<string, string>} answers name of the exercise -> text
 * @param {string} student ID, if the student gives one
 */
export function write(name, id, answers, student = "") {
  const date = new Date().toISOString()
  const known = student ? { name, student } : { name }
  return JSON.stringify({ format: "rosspin-answers", version: 2, ...known, id, date, answers }, null, 1)
}

/** Whether an answer is too long to be judged, where Python counts as characters what JavaScript may count as two. */
export const isTooLong = (/** @type {string} */ answer) =>
  answer.length > MOST.answer && [...answer].length > MOST.answer
