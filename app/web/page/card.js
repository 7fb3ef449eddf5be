// SPDX-License-Identifier: Apache-2.0
'use strict';
// The card of a material: its ball, its numbers, and where they come from. Curves, values for engines, comparison and
// neighbours are in card_parts.js.

const orbit = {turn: 0, rise: 0};

/** The axes right, up and back of a camera that is turned around the ball, as the uniform camera_axes takes them. */
function cameraAxes({turn, rise}) {
  const t = turn * Math.PI / 180, r = rise * Math.PI / 180;
  return [Math.cos(t), 0, -Math.sin(t), -Math.sin(r) * Math.sin(t), Math.cos(r), -Math.sin(r) * Math.cos(t),
    Math.cos(r) * Math.sin(t), Math.sin(r), Math.cos(r) * Math.cos(t)];
}

/** A row of `etak show`'s text: the value behind a key, with the lines that continue it. */
function shownLine(text, key) {
  const lines = text.split('\n'), at = lines.findIndex(line => line.trimStart().startsWith(`${key}  `));
  if (at < 0) return '';
  let out = lines[at].trim().slice(key.length).trim();
  for (let i = at + 1; /^ {11,}\S/.test(lines[i] ?? ''); ++i) out += `; ${lines[i].trim()}`;
  return out;
}

/** The lines of `etak show` about one dataset. */
function shownDataset(text, dataset) {
  const lines = text.split('\n'), at = lines.findIndex(line => line.trimEnd() === `  ${dataset}` || line.startsWith(`  ${dataset}  (`));
  const end = lines.indexOf('', at);
  return at < 0 ? '' : lines.slice(at + 1, end < 0 ? undefined : end).join('\n');
}

/** The entry of a BibTeX file, as etak's Python module writes it. */
function bibtex({authors = [], title = '', year = '', doi = '', url = '', published_in: place = '', via = '', licence = ''}) {
  const slash = {'\\': '\\textbackslash{}', '~': '\\textasciitilde{}', '^': '\\textasciicircum{}'};
  const tex = text => text.replace(/[\\~^&%$#_{}]/g, letter => slash[letter] ?? `\\${letter}`);
  const first = authors[0]?.split(/\s+/).pop() || 'anonymous', long = title.split(/\s+/).find(each => each.length > 3) ?? '';
  const key = `${first}${year}${long}`.toLowerCase().replace(/[^a-z0-9]/g, '');
  const fields = {author: authors.map(tex).join(' and '), title: title && `{${tex(title)}}`, [doi ? 'journal' : 'howpublished']: tex(place),
    year: String(year), doi, url, note: tex([via, licence].filter(Boolean).join(', '))};
  const rows = Object.entries(fields).filter(([, value]) => value).map(([name, value]) => `  ${name} = {${value}}`);
  return `@${doi ? 'article' : 'misc'}{${key},\n${rows.join(',\n')}\n}\n`;
}

const card = {
  token: 0, shader: null, size: 0, meanings: new Map(),

  /** Shows the chosen material under the settings of now. What was asked for before and is not here yet, is dropped. */
  async show() {
    const token = ++this.token, entry = library.get(state.id), box = $('card');
    box.classList.toggle('open', Boolean(entry));
    if (!entry) { box.replaceChildren(el('p', {class: 'empty'}, 'A material shows its numbers and sources here.')); this.ball = null; return; }
    const subject = subjectOf(entry.id, state.dataset), words = computeWords();
    try {
      const [f0, all, said, record] = await Promise.all([engine.json(['f0', subject, ...words]), engine.rows([`${entry.id}/*`], words),
        engine.run(['show', subject, ...words]), engine.json(['show', entry.id]).catch(() => null)]);
      if (token !== this.token) return;
      const row = f0.results[0];
      if (!row) throw new Error(f0.messages.join('; '));
      await this.learnFlags(row.flags, subject, words);
      if (token !== this.token) return;
      $('policy').textContent = `F0: ${f0.policy.text}.`;
      const focus = box.contains(document.activeElement) ? document.activeElement.id : '';
      box.replaceChildren(this.head(entry), this.ballOf(entry), this.datasetsOf(entry, all, row), this.facts(entry, row, said.out),
        this.citation(row, said.out, record), ...parts.map(part => el('section', {id: `part-${part.id}`}, el('h3', {}, part.title), part.now(entry))));
      if (focus) $(focus)?.focus();
      this.redraw();
      for (const part of parts) {
        const content = await part.then(entry, subject, words).catch(error => el('p', {class: 'problem'}, error.message));
        if (token !== this.token) return;
        $(`part-${part.id}`)?.replaceChildren(el('h3', {}, part.title), ...[content].flat());
      }
    } catch (error) {
      if (token === this.token) box.replaceChildren(this.head(entry), el('p', {class: 'problem'}, error.message));
    }
  },

  /** Learns what flags mean from the legend below the program's table. */
  async learnFlags(flags, subject, words) {
    if (flags.every(flag => this.meanings.has(flag))) return;
    const legend = (await engine.run(['f0', subject, '-v', ...words])).out.split('\n');
    for (const flag of flags) this.meanings.set(flag, legend.find(line => line.startsWith(`${flag} `))?.slice(flag.length).trim() ?? flag);
  },

  head(entry) {
    const about = [familyNames[entry.class] ?? entry.class, entry.group, ...entry.aliases].filter(Boolean).join(' · ');
    return el('div', {class: 'head'},
      el('div', {}, el('h2', {}, entry.name), el('p', {class: 'soft'}, about)),
      el('div', {class: 'tools'},
        copier('Copy link', () => location.href.replace(/#.*$/, '') + `#${fragmentOf()}`, 'a link to this material and these settings'),
        el('button', {type: 'button', class: 'close', 'aria-label': 'Close the card', click: () => choose('')}, '×')));
  },

  /** The large ball: a drag or the arrow keys turn the camera around it. */
  ballOf(entry) {
    const disc = swatch(entry.row?.hex, 'disc');
    const canvas = el('canvas', {width: 0, height: 0, id: 'big-ball', tabindex: 0, role: 'img',
      'aria-label': `Ball of ${entry.name} in a studio; arrow keys turn the camera`});
    const turn = (across, up) => {
      orbit.turn = (orbit.turn + across + 540) % 360 - 180;
      orbit.rise = Math.min(89, Math.max(-89, orbit.rise + up));
      this.frame();
    };
    canvas.addEventListener('pointerdown', event => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', event => {
      if (canvas.hasPointerCapture(event.pointerId)) turn(-event.movementX * 0.5, event.movementY * 0.5);
    });
    canvas.addEventListener('dblclick', () => turn(-orbit.turn, -orbit.rise));
    canvas.addEventListener('keydown', event => {
      const step = {ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10]}[event.key];
      if (step) { turn(...step); event.preventDefault(); }
    });
    this.ball = canvas;
    const said = balls.gl ? 'Drag or arrow keys turn the camera.' : balls.why;
    return el('figure', {class: 'big'}, el('span', {class: 'ball'}, disc, canvas), el('figcaption', {class: 'soft', id: 'ball-said'}, said));
  },

  async redraw() {
    const entry = library.get(state.id), canvas = this.ball;
    if (!entry || !canvas || !balls.gl || !balls.lit) return;
    const size = ballSize(canvas.parentElement.clientWidth || 280);
    const words = [...shaderWords(subjectOf(entry.id, state.dataset), modelOf(entry), size), '--orbit', '30', '--tilt', '10'];
    try {
      const shader = await balls.shader(words);
      if (this.ball !== canvas) return;
      Object.assign(this, {shader, size});
      this.frame();
      $('ball-said').textContent = ['Drag or arrow keys turn the camera.', ...shader.remarks.map(each => `${each}.`)].join(' ');
    } catch (error) {
      if (this.ball === canvas) $('ball-said').textContent = `No ball: ${error.message}`;
    }
  },

  frame() {
    if (this.soon || !this.shader || !balls.gl) return;
    this.soon = requestAnimationFrame(() => {
      this.soon = 0;
      if (this.ball?.isConnected && balls.gl) balls.show(this.shader, this.ball, this.size, {camera_axes: cameraAxes(orbit)});
    });
  },

  /** The publications to choose from, with what each gives. */
  datasetsOf(entry, all, shown) {
    const rows = all.map(({path, hex}) => ({id: path.slice(entry.id.length + 1), hex}));
    const first = entry.preferred;
    const select = el('select', {id: 'dataset', 'aria-label': 'Dataset', change: event => {
      state.dataset = event.target.value === first ? '' : event.target.value;
      changed({rows: false});
    }}, rows.map(({id, hex}) => el('option', {value: id}, `${id}  ${hex ?? 'refused'}${id === first ? '  (preferred)' : ''}`)));
    select.value = state.dataset || first;
    const known = rows.some(row => row.id === select.value);
    if (!known && state.dataset) select.value = rows.find(row => row.id.startsWith(state.dataset))?.id ?? shown.dataset;
    return el('p', {class: 'dataset'}, el('label', {}, rows.length > 1 ? `${rows.length} publications: ` : 'One publication: ', select));
  },

  facts(entry, row, said) {
    const own = shownDataset(said, row.dataset), facts = [], add = (name, ...content) => { if (content.some(Boolean)) facts.push(el('dt', {}, name), el('dd', {}, ...content)); };
    if (row.refused) add('Refused', row.refused);
    // Of a surface it is what comes back in all directions: a diffuse colour.
    add(entry.class === 'surface' ? 'Diffuse, linear' : 'F0, linear', row.linear && copier(triple(row.linear), () => triple(row.linear, 6), 'the linear values', 'copy number'));
    if (row.hex) add('8 bit, sRGB', swatch(row.hex), copier(row.srgb8.join(' '), () => row.srgb8.join(', '), '8-bit codes', 'copy number'), ' ',
      copier(row.hex, () => row.hex, 'hex', 'copy number'));
    add('F82', row.f82 && triple(row.f82.absolute), row.f82 && el('span', {class: 'soft'}, ' reflectance at 82 degrees, where metals lose or gain colour'));
    const zone = {below: 'below the forbidden zone of 0.20 to 0.45, as dielectrics are', above: 'above the forbidden zone of 0.20 to 0.45, as metals are',
      inside: 'inside the forbidden zone of 0.20 to 0.45, where few materials are: semiconductors and some compounds'}[row.zone?.verdict];
    add('Luminance', Number.isFinite(row.Y) && fixed(row.Y, 4), zone && `, ${zone}`);
    if (row.coat) add('Under a coat', triple(row.coat.f0_under));
    for (const flag of row.flags) add(flag.replaceAll('-', ' '), `${this.meanings.get(flag)}.`);
    if (row.doubtful) add('Doubtful', row.doubtful);
    add('Body', shownLine(own, 'clear') && `clear: ${shownLine(own, 'clear')}`);
    add('Kind', shownLine(own, 'sample'));
    add('Data', shownLine(own, 'data'));
    if (row.coverage) add('Coverage', `${fixed(row.coverage.y * 100, 2)} % of what the eye weighs`);
    add('Other publications', shownLine(said, 'spread'));
    add('The next one', shownLine(said, 'band'));
    if (!isLayered() && !state.dataset) add('Why this one', shownLine(said, 'preferred'));
    add('Note', shownLine(own, 'note'));
    return el('dl', {class: 'facts'}, facts);
  },

  citation(row, said, record) {
    const own = shownDataset(said, row.dataset), dataset = record?.material.datasets.find(each => each.id === row.dataset);
    const text = `etak, ${subjectOf(state.id, row.dataset && !isLayered() ? row.dataset : '')}: F0 ${row.hex ?? '-'} (${triple(row.linear)}, linear sRGB). ${row.source}`;
    const doi = row.source?.match(/doi:(10\.\d{4,9}\/[^\s,;]+)/)?.[1];
    return el('section', {class: 'citation'}, el('h3', {}, 'Source'),
      el('p', {}, row.source || 'no source is stated', ' ', doi && el('a', {href: `https://doi.org/${encodeURI(doi)}`, rel: 'noopener noreferrer', target: '_blank'}, 'open the publication')),
      el('p', {class: 'soft'}, [shownLine(own, 'via'), shownLine(own, 'licence')].filter(Boolean).join('. Licence: ')),
      el('p', {class: 'tools'}, copier('Copy citation', () => text, 'the citation'),
        dataset?.citation && copier('Copy BibTeX', () => bibtex(dataset.citation), 'the BibTeX entry')));
  },
};
