// SPDX-License-Identifier: Apache-2.0
'use strict';
// The program `etak` in a worker: engine.run(words, {files, stdin, collect}) promises {status, out, outBytes, err, files, ms}.

// In the worker, behind the text of etak.mjs. A run answers in its turn, and the page never waits for one.
const workerText = `
let etak;
onmessage = async ({data}) => {
  try {
    if (data.module) {
      etak = await start(data.module);
      postMessage({ready: true});
    } else {
      const begun = performance.now();
      const answer = await etak.run(data.words, data.options);
      postMessage({id: data.id, answer: {...answer, ms: performance.now() - begun}});
    }
  } catch (error) {
    postMessage({id: data.id, fault: String(error && error.message || error)});
  }
};`;

const engine = {
  worker: null, module: null, waiting: new Map(), next: 0, times: {},

  /** What this browser lacks, as a sentence; empty where it has everything. */
  lacks() {
    if (typeof WebAssembly !== 'object') return 'This browser has no WebAssembly, which etak runs in.';
    // A function with a try block, which browsers before 2022 do not know.
    const tried = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11];
    if (!WebAssembly.validate(new Uint8Array(tried)))
      return 'This browser has WebAssembly without exceptions, which etak needs: Chrome 95, Firefox 100, Safari 15.2 and later have them.';
    return '';
  },

  async open() {
    const begun = performance.now();
    const bytesOf = id => {
      const text = atob($(id).textContent.trim()), bytes = new Uint8Array(text.length);
      for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);  // ten times as fast as Uint8Array.from()
      return bytes;
    };
    const {instance: {exports: door}} = await WebAssembly.instantiate(bytesOf('unpacker'));
    const packed = bytesOf('module'), size = new DataView(packed.buffer).getUint32(5, true);
    const from = door.room(packed.length), to = door.room(size);
    new Uint8Array(door.memory.buffer).set(packed, from);
    door.unpack(from, to, size);
    $('module').textContent = '';
    this.times.unpack = performance.now() - begun;
    // Compiled once for all workers.
    this.module = await WebAssembly.compile(new Uint8Array(door.memory.buffer, to, size));
    await (this.opened = this.begin());
    this.times.start = performance.now() - begun - this.times.unpack;
  },

  /** A worker with the program in it; `take` gets its answers, `ended` is called where it stops by itself. */
  spawn(take, ended) {
    const text = $('loader').textContent.replace(/^export (?=async |function |const |class )/gm, '');
    const url = URL.createObjectURL(new Blob([text, workerText], {type: 'text/javascript'}));
    const worker = new Worker(url);
    return new Promise((done, failed) => {
      worker.onmessage = ({data}) => {
        if (data.ready) { URL.revokeObjectURL(url); done(worker); }
        else if (data.id === undefined) failed(new Error(data.fault));
        else take(data);
      };
      worker.onerror = event => {
        event.preventDefault();
        failed(new Error(event.message || 'the worker could not be started'));
        ended(event.message || 'it stopped');
      };
      worker.postMessage({module: this.module});
    });
  },

  async begin() {
    this.worker = await this.spawn(data => this.answer(data), why => this.restart(why));
  },

  /** A long run beside the others, in a worker of its own. */
  async aside(words, options) {
    let taken;
    const answer = new Promise(done => { taken = done; });
    const nothing = {status: 134, out: '', err: '', files: {}};
    const worker = await this.spawn(data => taken(data.answer ?? nothing), () => taken(nothing));
    worker.postMessage({id: 0, words, options});
    const out = await answer;
    worker.terminate();
    return out;
  },

  answer({id, answer, fault}) {
    const done = this.waiting.get(id);
    this.waiting.delete(id);
    if (answer?.status === 134) complain(`The program was started anew. ${messages(answer.err).join(' ')}`);
    done?.(answer ?? {status: 134, out: '', err: `etak: ${fault}\n`, files: {}, ms: 0});
  },

  /** Ends what is running, such as an answer that nobody waits for any more, and starts the program anew. */
  restart(why) {
    this.worker?.terminate();
    for (const done of this.waiting.values()) done({status: 134, out: '', err: `etak: ${why}\n`, files: {}, ms: 0});
    this.waiting.clear();
    this.opened = this.begin().catch(error => complain(`The program cannot be started: ${error.message}`));
    return this.opened;
  },

  run(words, options = {}) {
    return new Promise(done => {
      this.waiting.set(++this.next, done);
      const id = this.next;
      this.opened.then(() => this.worker.postMessage({id, words, options}));
    });
  },

  /** F0 of many materials, without what JSON has beyond the columns of CSV, in a sixth of the time: {path, hex, Y}. */
  async rows(inputs, words) {
    const answer = await this.run(['f0', '--format', 'csv', '-q', ...words, ...inputs]);
    if (answer.status > 1 && !answer.out) throw new Error(messages(answer.err).join('; '));
    const [head, ...lines] = answer.out.trimEnd().split('\n').map(cellsOf), at = name => head.indexOf(name);
    const codes = ['u8_r', 'u8_g', 'u8_b'].map(at), hex = cells => codes.map(i => Number(cells[i]).toString(16).padStart(2, '0')).join('');
    return lines.map(cells => ({path: cells[at('path')], Y: Number(cells[at('Y')]), hex: cells[codes[0]] === '' ? null : `#${hex(cells)}`}));
  },

  /** The JSON of a run, or an Error with the program's words. Exit status 1 is an answer, too: something was refused. */
  async json(words, options) {
    const answer = await this.run([words[0], '--format', 'json', ...words.slice(1)], options);
    if (answer.status > 1 && !answer.out) throw new Error(messages(answer.err).join('; ') || `exit status ${answer.status}`);
    const value = JSON.parse(answer.out);
    Object.defineProperty(value, 'messages', {value: messages(answer.err)});
    return value;
  },
};
