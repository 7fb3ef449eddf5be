// SPDX-License-Identifier: Apache-2.0
// The program `etak` in a worker, as a page sees it: a run is a promise, answers come in the order of the runs, and the page never waits.

/** What is answered where a run could not end. */
const stopped = why => ({status: 134, out: '', err: `etak: ${why}\n`, files: {}, ms: 0});

/** A worker of a text, for pages of which no file can be asked for. */
export function workerOf(text, options) {
  const url = URL.createObjectURL(new Blob([text], {type: 'text/javascript'}));
  try { return new Worker(url, options); } finally { setTimeout(() => URL.revokeObjectURL(url), 60000); }
}

export class Program {
  /** `make` makes a worker of worker.mjs, and `source` is what that takes first, or will be. `ended` is called where a program stops by itself. */
  constructor(make, source, ended = () => {}) {
    Object.assign(this, {make, worker: make(), waiting: new Map(), next: 0});
    let begun = false;
    this.ready = new Promise((done, failed) => {
      this.worker.onmessage = ({data: {module, times, id, answer, fault}}) => {
        if (module) { begun = true; done({module, times}); }
        else if (id === undefined) failed(new Error(fault));
        else this.take(id, answer ?? stopped(fault));
      };
      this.worker.onerror = event => {
        event.preventDefault();
        const why = event.message || 'the worker of the program could not be started, or it stopped';
        this.end(why);
        failed(new Error(why));
        if (begun) ended(why);
      };
    });
    const give = there => this.worker.postMessage({source: there});
    if (source instanceof Promise) source.then(give, () => {});
    else give(source);
  }

  take(id, answer) {
    this.waiting.get(id)?.(answer);
    this.waiting.delete(id);
  }

  async run(words, options = {}) {
    await this.ready;
    return new Promise(done => {
      this.waiting.set(++this.next, done);
      this.worker.postMessage({id: this.next, words, options});
    });
  }

  /** A long run beside the others, in a worker of its own. */
  async aside(words, options) {
    const other = new Program(this.make, this.ready.then(({module}) => module));
    const answer = await other.run(words, options);
    other.end('');
    return answer;
  }

  /** Ends it; what is running is answered with why. */
  end(why) {
    this.worker.terminate();
    for (const id of [...this.waiting.keys()]) this.take(id, stopped(why));
  }
}
