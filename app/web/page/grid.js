// SPDX-License-Identifier: Apache-2.0
'use strict';
// The library: search, families, order, and the grid of balls, of which only those in sight are drawn.

// What most people look for first; the other materials follow by family.
const bestKnown = ['gold', 'silver', 'copper', 'aluminum', 'iron', 'titanium', 'brass_70_30', 'chromium', 'titanium_nitride', 'diamond', 'water', 'silicon',
  'platinum', 'nickel', 'tungsten', 'bronze_commercial', 'anodised_titanium_120nm', 'anodised_titanium_40nm', 'fused_silica', 'sapphire', 'pmma',
  'graphite', 'germanium', 'mercury'];
const familyOrder = ['metal', 'alloy', 'conductor', 'semiconductor', 'gem', 'glass', 'crystal', 'mineral', 'salt', 'plastic', 'liquid', 'organic', 'solid',
  'gas', 'surface'];
const familyNames = {metal: 'Metals', alloy: 'Alloys', conductor: 'Conductors', semiconductor: 'Semiconductors', gem: 'Gems', glass: 'Glasses',
  crystal: 'Crystals', mineral: 'Minerals', salt: 'Salts', plastic: 'Plastics', liquid: 'Liquids', organic: 'Organic', solid: 'Solids', gas: 'Gases',
  surface: 'Everyday surfaces', film: 'Thin films'};
const familyOf = entry => entry.group === 'film' ? 'film' : entry.class;

const grid = {
  cells: new Map(), shown: [], inSight: new Set(), family: '', token: 0,

  open() {
    const watcher = new IntersectionObserver(changes => {
      for (const change of changes) {
        const cell = this.cells.get(change.target.dataset.id);
        if (change.isIntersecting) this.inSight.add(cell);
        else {
          this.inSight.delete(cell);
          cell.key = '';
          cell.canvas.width = cell.canvas.height = 0;  // the memory of a picture that nobody sees
          cell.canvas.classList.remove('drawn');
        }
      }
      this.drawSoon();
    }, {rootMargin: '200px'});
    for (const entry of library.values()) {
      const canvas = el('canvas', {width: 0, height: 0, 'aria-hidden': 'true'});
      const disc = swatch('', 'disc'), hex = el('span', {class: 'hex'});
      const item = el('li', {role: 'option', 'data-id': entry.id, tabindex: -1, 'aria-selected': 'false', title: entry.name},
        el('span', {class: 'ball'}, disc, canvas), el('span', {class: 'name'}, entry.name), hex);
      this.cells.set(entry.id, {entry, item, canvas, disc, hex, key: ''});
      watcher.observe(item);
    }
    this.openFilters();
    $('grid').addEventListener('click', event => this.choose(event.target.closest('li')));
    $('grid').addEventListener('keydown', event => this.key(event));
    this.filter();
  },

  openFilters() {
    const counts = new Map();
    for (const entry of library.values()) counts.set(familyOf(entry), (counts.get(familyOf(entry)) ?? 0) + 1);
    const families = [...counts.keys()].sort((a, b) => (familyOrder.indexOf(a) + 99) % 99 - (familyOrder.indexOf(b) + 99) % 99);
    const chip = (family, name, count) => el('button', {type: 'button', 'aria-pressed': String(family === this.family), 'data-family': family,
      click: event => {
        this.family = family;
        for (const each of $('families').children) each.setAttribute('aria-pressed', String(each === event.currentTarget));
        this.filter();
      }}, name, el('span', {class: 'soft'}, ` ${count}`));
    $('families').append(chip('', 'All', library.size),
      ...families.map(family => chip(family, familyNames[family] ?? family, counts.get(family))));
    $('search').addEventListener('input', () => this.filter());
    $('order').addEventListener('change', () => this.filter());
  },

  /** Fills the grid with what the search and the family leave. */
  filter() {
    const wanted = $('search').value.trim().toLowerCase(), order = $('order').value;
    const has = entry => [entry.id, entry.name, ...entry.aliases].some(text => text.toLowerCase().includes(wanted));
    const rank = entry => bestKnown.includes(entry.id) && !this.family ? bestKnown.indexOf(entry.id) : 100 + familyOrder.indexOf(entry.class);
    // A name or an alias that is exactly what was typed stands first: Au is gold, not a word with au in it.
    const exact = entry => wanted && [entry.id, entry.name, ...entry.aliases].some(text => text.toLowerCase() === wanted) ? 0 : 1;
    const byName = (a, b) => a.name < b.name ? -1 : a.name > b.name ? 1 : 0;
    // Under a film or a coat only media of n and k have an F0.
    this.shown = [...library.values()].filter(entry => (entry.row || !isLayered()) && (!this.family || familyOf(entry) === this.family) && (!wanted || has(entry)));
    this.shown.sort((a, b) => exact(a) - exact(b)
      || (order === 'Y' ? (a.row?.Y ?? a.Y) - (b.row?.Y ?? b.Y) : order === 'name' ? 0 : rank(a) - rank(b)) || byName(a, b));
    $('grid').replaceChildren(...this.shown.map(entry => this.cells.get(entry.id).item));
    $('none').hidden = this.shown.length > 0;
    $('count').textContent = `${this.shown.length} of ${library.size}`;
    this.mark();
  },

  /** Shows which material is chosen, and lets the Tab key lead to it, else to the first. */
  mark() {
    const stop = this.shown.some(entry => entry.id === state.id) ? state.id : this.shown[0]?.id;
    for (const {entry, item} of this.cells.values()) {
      item.setAttribute('aria-selected', String(entry.id === state.id));
      item.tabIndex = entry.id === stop ? 0 : -1;
    }
  },

  choose(item) {
    if (item) choose(item.dataset.id);
  },

  key(event) {
    const items = this.shown.map(entry => this.cells.get(entry.id).item), at = items.indexOf(document.activeElement);
    if (at < 0 || event.altKey || event.ctrlKey || event.metaKey) return;
    const columns = Math.max(1, items.findIndex((item, i) => i > 0 && item.offsetTop !== items[0].offsetTop));
    const steps = {ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns, Home: -at, End: items.length - 1 - at};
    if (event.key in steps) {
      const next = items[Math.min(items.length - 1, Math.max(0, at + steps[event.key]))];
      items[at].tabIndex = -1;
      next.tabIndex = 0;
      next.focus();
      event.preventDefault();
    } else if (event.key === 'Enter' || event.key === ' ') {
      this.choose(items[at]);
      event.preventDefault();
    }
  },

  /** Takes the rows of F0 under the settings of now: codes and discs change at once, balls follow. */
  refresh() {
    if (isLayered() !== this.layered || $('order').value === 'Y') this.filter();
    this.layered = isLayered();
    for (const {entry, disc, hex, item} of this.cells.values()) {
      const shown = entry.row?.hex ?? '';
      disc.style.background = shown || 'transparent';
      hex.textContent = shown || 'no F0 here';
      item.classList.toggle('refused', !shown);
    }
    this.redraw();
  },

  redraw() {
    for (const cell of this.inSight) cell.key = '';
    this.drawSoon();
  },

  drawSoon() {
    if (!this.soon && balls.gl && balls.lit) this.soon = requestAnimationFrame(() => { this.soon = 0; this.drawSome(++this.token); });
  },

  size: cell => ballSize(cell.item.firstChild.clientWidth || 112),

  /** Asks for the shaders of the first balls while their light is made. */
  askFirst() {
    if (!balls.gl || location.hash.includes('=')) return;  // settings of a link are not taken yet
    for (const entry of this.shown.slice(0, 3))
      balls.shader(shaderWords(entry.id, modelOf(entry), this.size(this.cells.get(entry.id)))).catch(() => {});
  },

  /** Draws what is in sight and stale, in the order of the page, until a newer call takes over. */
  async drawSome(token) {
    for (const {id} of this.shown) {
      const cell = this.cells.get(id);
      if (token !== this.token || !balls.gl) return;
      if (!this.inSight.has(cell) || cell.key || !cell.entry.row?.hex) continue;
      const size = this.size(cell);
      try {
        const shader = await balls.shader(shaderWords(subjectOf(id), modelOf(cell.entry), size));
        if (token !== this.token || !balls.gl) return;
        balls.show(shader, cell.canvas, size);
      } catch (error) {
        // A model that cannot draw this material, such as one for metals and a clear body: the disc stays.
        cell.canvas.classList.remove('drawn');
        cell.item.title = `${cell.entry.name}: ${error.message}`;
      }
      cell.key = 'drawn';
    }
    if (token === this.token && engine.times.rows && !engine.times.balls) {
      engine.times.balls = performance.now();
      tellTimes();
    }
  },
};
