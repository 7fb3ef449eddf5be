// SPDX-License-Identifier: Apache-2.0
// Types of etak.mjs.

export type Bytes = Uint8Array | string;
/** Files by their paths; relative ones are in the current folder of a run, which is the root. */
export type Files = Record<string, Bytes> | Map<string, Bytes>;

export interface RunOptions {
  /** Files that are there while the program runs. */
  files?: Files;
  stdin?: Bytes;
  /** Whether the result has the files that the program wrote; false without it. */
  collect?: boolean;
}

export interface RunResult {
  /** The exit status of the program; 134 where it could not go on. */
  status: number;
  /** Standard output, as text and as bytes. */
  out: string;
  outBytes: Uint8Array;
  /** Standard error. */
  err: string;
  files: Record<string, Uint8Array>;
}

/** Options of the program by their long names: {illuminant: 'A', outside: 'water'} is --illuminant A --outside water. */
export type Settings = Record<string, string | number | boolean | undefined>;

export interface Etak {
  /** Runs `etak WORDS...`. A failure of the program is a status and a text, and no exception. */
  run(words: readonly string[], options?: RunOptions): RunResult;
  /** The output of a run with --format json; throws an Error with the message of the program where it failed. */
  json(words: readonly string[], options?: RunOptions): unknown;
  /** Bytes of memory that the program has taken so far. */
  memory(): number;
  list(settings?: Settings): unknown;
  /** F0 of materials, of all without an id. */
  f0(ids?: string | readonly string[], settings?: Settings): unknown;
  show(id: string, settings?: Settings): unknown;
  shader(id: string, settings?: Settings): unknown;
  /** The report of the validator on all of the files. */
  validate(files: Files, settings?: Settings): unknown;
}

/** Starts the program: `source` is the compiled module or the bytes of etak.wasm, without it those of the etak.wasm
 *  of the package. Each Etak has a memory of its own. */
export function start(source?: WebAssembly.Module | BufferSource | Promise<BufferSource>): Promise<Etak>;
