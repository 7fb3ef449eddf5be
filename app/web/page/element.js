// SPDX-License-Identifier: Apache-2.0
// <etak-material id="gold"></etak-material>: a ball of a material in a studio, with its F0 and source, for any page.
//   id                           a material, a dataset (gold/johnson-1972) or a stack (anatase:120nm/titanium), as `etak f0` takes it
//   film coat                    layers on it: film="anatase:120nm" coat="pmma"; a coat without a thickness has 1 mm
//   illuminant outside observer  as the options of `etak f0`
//   model roughness gloss        of the ball, as the options of `etak shader`
//   module                       address of etak.wasm; else it is looked for beside this script
// Until a material is shown, and where scripts do not run, the text within the element stands there. Without WebGL 2 the ball is a disc.
// All elements of a page share one program, in a worker, and one context of WebGL. The host element can be styled; parts: swatch (its
// size is that of the ball), name, values, source, error. A page from a disk can load etak-element.js, which carries the module.
import {Program, workerOf} from './program.mjs';
import {Drawing, ballSize, ballWords, nearestModel} from './drawing.mjs';

const home = import.meta.url;

/** A worker of the script beside this one; from another server it can only be asked for by a script of one's own. */
function workerBeside() {
  const address = new URL('worker.mjs', home).href;
  try {
    return new Worker(address, {type: 'module'});
  } catch {
    return workerOf(`import ${JSON.stringify(address)};`, {type: 'module'});
  }
}

const programs = new Map();
function programOf(address) {
  if (!programs.has(address))
    programs.set(address, address || typeof carried === 'undefined'
      ? new Program(workerBeside, new URL(address ?? new URL('etak.wasm', home), document.baseURI).href)
      : new Program(() => workerOf(carried.worker), carried));
  return programs.get(address);
}

const shown = new Set();
const drawing = new Drawing(() => shown.forEach(each => each.draw()));
let light;
/** The light of the studio by the program that is asked first: quickly, and then in full. */
function lit(program) {
  light ??= drawing.open() ? drawing.light(program, true).then(() => {
    drawing.light(program, false).then(() => shown.forEach(each => each.draw())).catch(() => {});  // the coarse light stays
  }) : Promise.reject(new Error('no WebGL 2'));
  return light;
}

const style = `:host { display: inline-flex; gap: 0.7em; align-items: center; font-variant-numeric: tabular-nums; vertical-align: middle; }
:host([hidden]) { display: none; }
[part=swatch] { position: relative; width: 4em; aspect-ratio: 1; flex: none; }
i, canvas { position: absolute; } canvas { inset: 0; width: 100%; height: 100%; } canvas:not(.drawn), .drawn + i { visibility: hidden; }
i { inset: 4.6%; border-radius: 50%; box-shadow: inset 0 0 0 1px rgb(128 128 128 / 0.35); forced-color-adjust: none; }
b, small, span { display: block; min-width: 0; overflow-wrap: anywhere; } small { opacity: 0.8; max-width: 60ch; overflow: hidden; display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 3; }`;

export class EtakMaterial extends HTMLElement {
  static observedAttributes = ['id', 'film', 'coat', 'illuminant', 'outside', 'observer', 'model', 'roughness', 'gloss', 'module'];

  connectedCallback() { shown.add(this); this.show(); }
  disconnectedCallback() { shown.delete(this); this.sizes?.disconnect(); }
  attributeChangedCallback() { if (this.isConnected) this.show(); }

  part(tag, name, text, attributes = {}) {
    const out = document.createElement(tag);
    for (const [key, value] of Object.entries({part: name, ...attributes})) out.setAttribute(key, value);
    out.textContent = text;
    return out;
  }

  /** The named attributes that are there, as options of the program. */
  words(...names) { return names.flatMap(name => this.hasAttribute(name) ? [`--${name}`, this.getAttribute(name)] : []); }

  get subject() {
    const coat = this.getAttribute('coat');
    return [coat && (coat.includes(':') ? coat : `${coat}:1mm`), this.getAttribute('film'), this.id].filter(Boolean).join('/');
  }

  async show() {
    const turn = this.turn = (this.turn ?? 0) + 1;
    if (!this.shadowRoot) {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(style);
      this.attachShadow({mode: 'open'}).adoptedStyleSheets = [sheet];
      this.shadowRoot.append(document.createElement('slot'));
    }
    try {
      const program = programOf(this.getAttribute('module'));
      const answer = await program.run(['f0', '--format', 'json', '-q', ...this.words('illuminant', 'outside', 'observer'), '--', this.subject]);
      if (turn !== this.turn) return;
      const row = answer.out && JSON.parse(answer.out).results[0];
      if (!row?.linear) throw new Error(row?.refused ?? answer.err.replace(/^etak: /gm, '').trim());
      this.fill(row);
      this.dispatchEvent(new CustomEvent('etak-shown', {detail: row}));
      await lit(program).catch(() => {});
      if (turn === this.turn) this.watch(program, row);
    } catch (error) {
      if (turn === this.turn) this.shadowRoot.replaceChildren(this.part('span', 'error', error.message.startsWith(`${this.subject}: `) ? error.message : `${this.subject}: ${error.message}`));
    }
  }

  fill(row) {
    const name = row.name || row.path, what = row.class === 'surface' ? 'diffuse' : 'F0', numbers = [row.linear.r, row.linear.g, row.linear.b].map(value => value.toFixed(4)).join(' ');
    const swatch = this.part('span', 'swatch', '', {role: 'img', 'aria-label': `Ball of ${name}, ${what} ${row.hex}`}), disc = document.createElement('i');
    const text = document.createElement('span');
    disc.style.background = row.hex;
    this.canvas = document.createElement('canvas');
    this.canvas.width = this.canvas.height = 0;
    swatch.append(this.canvas, disc);
    text.append(this.part('b', 'name', name), this.part('span', 'values', `${what} ${numbers}, ${row.hex}`), this.part('small', 'source', row.source, {title: row.source}));
    this.shadowRoot.replaceChildren(swatch, text);
  }

  /** Draws the ball as soon as it has a size, and anew with another one. */
  watch(program, row) {
    this.sizes?.disconnect();
    if (!drawing.gl) return;
    this.ask = async () => {
      const size = ballSize(this.canvas.clientWidth), words = this.words('illuminant', 'outside', 'observer', 'roughness', 'gloss');
      const model = this.getAttribute('model') ?? nearestModel(row.class);
      const {out, err} = await program.run([...ballWords(this.subject, model, size), '--format', 'json', '-q', ...words]);
      if (!out) throw new Error(err.replace(/^etak: /gm, '').trim());
      return {shader: JSON.parse(out), size};
    };
    this.sizes = new ResizeObserver(() => { if (this.canvas.clientWidth) this.draw(); });
    this.sizes.observe(this.canvas);
  }

  async draw() {
    const {canvas, ask} = this;
    if (!ask || !drawing.gl || !canvas.clientWidth) return;
    try {
      const {shader, size} = await ask();
      if (this.canvas === canvas && drawing.gl) drawing.show(shader, canvas, size);
    } catch (error) {
      canvas.parentElement.title = `No ball: ${error.message}`;  // such as a model for metals and a clear body: the disc stays
      canvas.classList.remove('drawn');
    }
  }
}

customElements.define('etak-material', EtakMaterial);
