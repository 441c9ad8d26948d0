// What to say of a run that has ended.

/** What is said of one that went wrong. */
export const SEE_CONSOLE = "error: see the console"

/** The longest console (characters) that is worth pinning in a test. */
const LONGEST = 50_000

/** The status of a node that Ctrl-C ended, as it does at the end of a run unless the node has seen to it. */
const BY_CTRL_C = 130

/**
 * What the status line says, and what of the run a test can pin, or null. `whole` is the console if nothing is left out.
 *
 * @param {import("./protocol.js").RunResult} result
 * @param {import("./runs.js").Text} job
 * @param {string | null} whole
 */
export function outcome({ status, errors, count, ticks, drive, hints }, { source, filename, seconds, args, beside, launch, ros }, whole) {
  const isAlone = !launch && !beside.length && !drive.length
  const isWhole = whole !== null && whole.length <= LONGEST && count === ticks.length
  const pinned = isAlone && isWhole && !status && !errors && !hints ? { source, filename, seconds, args, console: whole, ticks } : null
  const ticked = count ? `: ${count} tick${count === 1 ? "" : "s"}` : ""
  let said = `done${ticked}`
  if (status === BY_CTRL_C) said += `, ended by Ctrl-C${ros ? "" : " with a traceback"}`
  else if (status) said = SEE_CONSOLE
  else if (errors) said = `done, but with an ${SEE_CONSOLE}`
  else if (hints) said += "; see the console"
  return { said, pinned }
}
