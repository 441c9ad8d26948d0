// For the page, which is typed.

type Files = Record<string, Uint8Array>

export function unpacked(archive: Uint8Array): Files

export class Compiler {
  constructor(module: WebAssembly.Module, archive: Uint8Array)
  run(args: string[], files: Files, outputs?: string[]): { status: number; said: string; made: Files }
}
