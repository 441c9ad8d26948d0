// What the build defines: the constants that Python has, too.

import { execFileSync } from "node:child_process"
import { fileURLToPath } from "node:url"

const python = fileURLToPath(new URL("../../.venv/bin/python", import.meta.url))
Object.assign(globalThis, JSON.parse(execFileSync(python, ["-m", "rosspin.site.rules"])))
