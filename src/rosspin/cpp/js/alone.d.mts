// For the page, which is typed.

type Tick = [source: string, number: number, expected: number, real: number, duration: number]

interface Told {
  print(text: string, isError: boolean, tick: number): void
  begin(tick: Tick, number: number): void
  pace(now: number): void
}

export const COLOURS: RegExp

export class Alone {
  constructor(
    module: WebAssembly.Module,
    node: { ros: number; name: string; words: string[]; seconds: number; seed: number; paced: boolean },
    shown: Told,
  )
  ticks: Tick[]
  foreseen: Tick[]
  periods: Map<string, number>
  rings: { links: [name: string, waits: string][]; to: number }[]
  readonly hasThreads: boolean
  readonly now: bigint
  run(): Promise<{ status: number; end: number; hints: string[] }>
}
