// SPDX-License-Identifier: Apache-2.0
// <etak-material id="gold"></etak-material>: a swatch of a material's F0 with its numbers and source, for any page.
//   id                           a material, a dataset (gold/johnson-1972) or a stack (anatase:120nm/titanium), as `etak f0` takes it
//   illuminant outside observer  as the options of `etak f0`
//   module                       address of etak.wasm; else it is looked for beside etak.mjs
// All elements of a page share one program. The host element can be styled; parts: swatch, name, values, source, error.
import {start} from './etak.mjs';

const programs = new Map();
function programOf(address) {
  if (!programs.has(address))
    programs.set(address, fetch(address).then(answer => {
      if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
      return answer.arrayBuffer();
    }).then(start));
  return programs.get(address);
}

const style = `:host { display: inline-flex; gap: 0.7em; align-items: center; font-variant-numeric: tabular-nums; vertical-align: middle; }
:host([hidden]) { display: none; }
i { width: 2.6em; height: 2.6em; border-radius: 50%; flex: none; box-shadow: inset 0 0 0 1px rgb(128 128 128 / 0.35); }
small, span { display: block; } small { opacity: 0.75; max-width: 60ch; }`;

export class EtakMaterial extends HTMLElement {
  static observedAttributes = ['id', 'illuminant', 'outside', 'observer', 'module'];

  connectedCallback() { this.show(); }
  attributeChangedCallback() { if (this.isConnected) this.show(); }

  part(tag, name, text) {
    const out = document.createElement(tag);
    out.setAttribute('part', name);
    out.textContent = text;
    return out;
  }

  async show() {
    const turn = this.turn = (this.turn ?? 0) + 1;
    const root = this.shadowRoot ?? this.attachShadow({mode: 'open'});
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    root.adoptedStyleSheets = [sheet];
    try {
      const program = await programOf(this.getAttribute('module') ?? new URL('etak.wasm', import.meta.url).href);
      const words = ['illuminant', 'outside', 'observer'].flatMap(name => this.hasAttribute(name) ? [`--${name}`, this.getAttribute(name)] : []);
      const answer = await program.run(['f0', '--format', 'json', '-q', ...words, '--', this.id]);
      if (turn !== this.turn) return;
      const row = answer.out && JSON.parse(answer.out).results[0];
      if (!row?.linear) throw new Error(row?.refused ?? answer.err.replace(/^etak: /gm, '').trim());
      const swatch = this.part('i', 'swatch', ''), text = document.createElement('span');
      swatch.style.background = row.hex;
      const numbers = [row.linear.r, row.linear.g, row.linear.b].map(value => value.toFixed(4)).join(' ');
      text.append(this.part('b', 'name', row.name || row.path), this.part('span', 'values', `F0 ${numbers}, ${row.hex}`), this.part('small', 'source', row.source));
      root.replaceChildren(swatch, text);
      this.dispatchEvent(new CustomEvent('etak-shown', {detail: row}));
    } catch (error) {
      if (turn === this.turn) root.replaceChildren(this.part('span', 'error', `${this.id}: ${error.message}`));
    }
  }
}

customElements.define('etak-material', EtakMaterial);
