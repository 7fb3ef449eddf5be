// SPDX-License-Identifier: Apache-2.0
// The program `etak` as a function, in browsers and in node: etak.wasm is its command line, compiled for WebAssembly.
// Nothing is read but what a call brings, and nothing is sent anywhere. etak.d.ts describes what is exported.

const encoder = new TextEncoder(), decoder = new TextDecoder('utf-8', {ignoreBOM: true});
const bytesOf = content => typeof content === 'string' ? encoder.encode(content) : content;

/** A program in memory. After a trap its memory says nothing any more, so that each of them has an instance of its own. */
class Instance {
  constructor(module) {
    this.exports = new WebAssembly.Instance(module, {etak: {now: () => Date.now()}}).exports;
    this.exports._initialize();
  }

  /** Writes bytes to where `place(size)` of the module says. */
  put(place, bytes) {
    const at = place(bytes.length);
    if (at === 0) throw new RangeError('a file and a folder have the same name');
    new Uint8Array(this.exports.memory.buffer).set(bytes, at >>> 0);
  }

  part(index) {
    const at = this.exports.etak_part(index) >>> 0;
    return new Uint8Array(this.exports.memory.buffer).slice(at, at + (this.exports.etak_part_size(index) >>> 0));
  }

  run(words, files, stdin) {
    const door = this.exports;
    door.etak_begin();
    for (const [path, content] of files) {
      this.put(door.etak_words, encoder.encode(path));
      this.put(door.etak_file, bytesOf(content));
    }
    if (stdin !== undefined) this.put(door.etak_input, bytesOf(stdin));
    this.put(door.etak_words, encoder.encode(words.map(word => `${word}\0`).join('')));
    return door.etak_run();
  }
}

/** What is said where a run ended in the middle. */
function reasonOf(error, words) {
  const place = `etak ${words[0] ?? ''}`.trim();
  if (error instanceof RangeError && /stack/i.test(error.message)) return `${place}: the input is nested too deeply`;
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError || error instanceof WebAssembly.Exception)
    return `${place}: the program had to stop, most likely because there is not enough memory${error.message ? ` (${error.message})` : ''}`;
  return `${place}: ${error.message}`;
}

/** Starts the program; `source` is a compiled module, or the bytes of etak.wasm. */
export async function start(source) {
  const given = await source;
  const module = given instanceof WebAssembly.Module ? given : await WebAssembly.compile(given);
  let instance = null;

  function run(words, {files = {}, stdin, collect = false} = {}) {
    const entries = files instanceof Map ? [...files] : Object.entries(files);
    try {
      instance ??= new Instance(module);
      const status = instance.run(words.map(String), entries, stdin);
      const outBytes = instance.part(0), err = decoder.decode(instance.part(1));
      const written = {};
      for (let i = 2, count = instance.exports.etak_parts(); collect && i < count; i += 2)
        written[decoder.decode(instance.part(i))] = instance.part(i + 1);
      return {status, out: decoder.decode(outBytes), outBytes, err, files: written};
    } catch (error) {
      instance = null;
      return {status: 134, out: '', outBytes: new Uint8Array(), err: `${reasonOf(error, words)}\n`, files: {}};
    }
  }

  /** The output of a run as JSON; an Error with the message of the program where it failed. */
  function json(words, options) {
    const result = run([...words, '--format', 'json'], options);
    if (result.status === 0) return JSON.parse(result.out);
    throw new Error(result.err.replace(/^etak: /, '').trimEnd());
  }

  /** {outside: 'water'} as the options of the program: --outside water. */
  const options = settings => Object.entries(settings).flatMap(([name, value]) =>
    value === true ? [`--${name}`] : value === false || value === undefined ? [] : [`--${name}`, String(value)]);

  return {
    run,
    json,
    memory: () => instance?.exports.memory.buffer.byteLength ?? 0,
    list: (settings = {}) => json(['list', ...options(settings)]),
    f0: (ids = [], settings = {}) => json(['f0', ...(ids.length > 0 ? [ids].flat() : ['--all']), ...options(settings)]),
    show: (id, settings = {}) => json(['show', id, ...options(settings)]),
    shader: (id, settings = {}) => json(['shader', id, ...options(settings)]),
    validate: (files, settings = {}) => {
      const names = (files instanceof Map ? [...files.keys()] : Object.keys(files));
      return json(['validate', ...options({'exit-zero': true, ...settings}), '--', ...names], {files});
    },
  };
}
