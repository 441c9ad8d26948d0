// For the page, which is typed.

export class Beside {
  constructor(module: WebAssembly.Module)
  goOn(text: string): Promise<{ text: string; ticks?: Uint8Array }[]>
}
