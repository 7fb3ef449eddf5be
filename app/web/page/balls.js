// SPDX-License-Identifier: Apache-2.0
'use strict';
// The balls of the page, of drawing.mjs.

const balls = Object.assign(new Drawing(() => { grid.redraw(); card.redraw(); }), {
  why: '', shaders: new Map(),

  begin() {
    if (!this.open()) this.why = 'This browser offers no WebGL 2, so materials are shown as flat colours of F0 instead of balls. All numbers are the same.';
    // What most balls are drawn by is compiled, of which a first picture is a part, while their light is made.
    else for (const shader of JSON.parse($('shaders').textContent)) this.draw(shader, 1);
  },

  show(...what) {
    Drawing.prototype.show.apply(this, what);
    engine.times.ball ??= performance.now();
  },

  /** What `etak shader` says, kept for the last few hundred questions. */
  async shader(words) {
    const key = words.join('\n');
    if (!this.shaders.has(key)) {
      if (this.shaders.size > 600) this.shaders.delete(this.shaders.keys().next().value);
      const asked = engine.json(words);
      this.shaders.set(key, asked);
      asked.catch(() => this.shaders.delete(key));
    }
    return this.shaders.get(key);
  },
});
