// SPDX-License-Identifier: Apache-2.0
'use strict';
// The program of the page: engine.run(words, {files, stdin, collect}) promises {status, out, outBytes, err, files, ms}.

const engine = {
  program: null, module: null, times: {},

  /** What this browser lacks, as a sentence; empty where it has everything. */
  lacks() {
    if (typeof WebAssembly !== 'object') return 'This browser has no WebAssembly, which etak runs in.';
    // A function with a try block, and one that drops a vector of 128 bits.
    const [tried, vector] = [[6, 64, 25, 11], [65, 0, 253, 15, 26]].map(body =>
      WebAssembly.validate(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, body.length + 4, 1, body.length + 2, 0, ...body, 11])));
    const lack = [!tried && 'exceptions', !vector && '128-bit vectors'].filter(Boolean).join(' and ');
    return lack && `This browser has WebAssembly without ${lack}, which etak needs: Chrome 95, Firefox 100, Safari 16.4 and later have both.`;
  },

  open() {
    const [packed, unpacker] = ['module', 'unpacker'].map(id => $(id).textContent);
    $('module').textContent = '';
    return this.opened = this.begin({packed, unpacker});
  },

  async begin(source) {
    this.program = new Program(() => workerOf($('worker').textContent), source, why => this.restart(why));
    const {module, times} = await this.program.ready;
    this.module ??= module;
    this.times = {...times, ...this.times};
  },

  /** Ends what is running, such as an answer that nobody waits for any more, and starts the program anew. */
  restart(why) {
    this.program.end(why);
    this.opened = this.begin(this.module).catch(error => complain(`The program cannot be started: ${error.message}`));
    return this.opened;
  },

  async run(words, options) {
    await this.opened;
    const program = this.program, answer = await program.run(words, options);
    if (answer.status === 134 && program === this.program) complain(`The program was started anew. ${messages(answer.err).join(' ')}`);
    return answer;
  },

  aside: (words, options) => engine.program.aside(words, options),

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
