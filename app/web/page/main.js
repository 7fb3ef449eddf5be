// SPDX-License-Identifier: Apache-2.0
'use strict';
// Starts the page, and holds its parts together: views, settings, the material that is chosen, keys.

/** Opens the card of a material, or closes it where `id` is empty. */
function choose(id, b = state.b) {
  Object.assign(state, {id, dataset: '', b, view: 'materials'});
  complain('');
  showView('materials');
  grid.mark();
  cover();
  changed({rows: false});
  if (id && narrow.matches) $('card').focus();
  else if (!id) $('grid').querySelector('[tabindex="0"]')?.focus();
}

/** Where the card lies over the page, what is below it cannot be reached by keys. */
const narrow = matchMedia('(max-width: 1099px)');
function cover() {
  const covered = narrow.matches && Boolean(state.id) && state.view === 'materials';
  for (const each of [document.querySelector('header'), document.querySelector('.library'), document.querySelector('footer')]) each.inert = covered;
}

function showView(view) {
  state.view = view;
  for (const each of choices.view) {
    $(each).hidden = each !== view;
    $(`tab-${each}`).setAttribute('aria-selected', String(each === view));
    $(`tab-${each}`).tabIndex = each === view ? 0 : -1;
  }
  if (view === 'colour' && !$('answer').childElementCount) colour.ask(state.colour ? `#${state.colour}` : $('typed').value);
  writeFragment();
}

let asked = 0, running = false;
/** After a change: writes the link, computes all rows anew where the settings changed, and shows the material. */
async function changed({rows = true} = {}) {
  writeFragment();
  tellSettings();
  if (!rows) return card.show();
  ++asked;
  if (running) return;  // the run that is under way asks again
  running = true;
  try {
    for (let done = 0; done !== asked;) {
      done = asked;
      await computeRows();
    }
  } finally {
    running = false;
  }
  grid.refresh();
  await card.show();
}

/** F0 of all materials under the settings of now, in one run. */
async function computeRows() {
  const entries = [...library.values()];
  if (!isLayered() && !computeWords().length) {  // `etak list` has said them
    for (const entry of entries) entry.row = {path: entry.id, hex: entry.hex ?? null, Y: entry.Y};
    complain('', 'settings-problem');
    return;
  }
  const layered = entries.filter(entry => entry.class !== 'surface' && entry.group !== 'film');
  const inputs = isLayered() ? layered.map(entry => subjectOf(entry.id)) : ['--all'];
  try {
    const rows = new Map((await engine.rows(inputs, computeWords())).map(row => [row.path, row]));
    for (const entry of entries) entry.row = rows.get(isLayered() ? subjectOf(entry.id) : entry.id) ?? null;
    complain('', 'settings-problem');
  } catch (error) {
    complain(error.message, 'settings-problem');
    $('settings-box').open = true;
  }
}

const named = id => library.get(id)?.name ?? id;
function tellSettings() {
  const said = [`light ${state.illuminant}`, state.observer === '1964-10deg' ? '10-degree observer' : '2-degree observer',
    state.outside ? `in ${named(state.outside)}` : 'in vacuum', state.roughness === '' ? 'roughness by family' : `roughness ${state.roughness}`];
  if (state.film) said.push(`${state.thickness} nm ${named(state.film)}`);
  if (state.coat) said.push(`coat of ${named(state.coat)}`);
  if (state.model) said.push(state.model);
  $('settings-said').textContent = `(now ${said.join(', ')})`;
}

function fillSettings(models) {
  const select = (name, label, pairs) => el('label', {}, `${label} `, el('select', {id: `set-${name}`, change: event => {
    state[name] = event.target.value;
    changed({rows: name !== 'model'}).then(() => { if (name === 'model') grid.redraw(); });
  }}, pairs.map(([value, text]) => el('option', {value}, text))));
  const ids = (list, none) => list.filter(id => !id || library.has(id)).map(id => [id, id ? named(id) : none]);
  const outside = el('input', {id: 'set-outside', list: 'media', placeholder: 'vacuum', size: 14, spellcheck: false, autocomplete: 'off',
    change: event => { state.outside = event.target.value.trim(); changed(); }});
  const slide = (name, attributes, told) => {
    const value = el('output', {id: `said-${name}`});
    const range = el('input', {id: `set-${name}`, type: 'range', ...attributes, input: event => {
      state[name] = told(event.target.value)[0];
      value.textContent = told(event.target.value)[1];
      changed({rows: name !== 'roughness'}).then(() => { if (name === 'roughness') grid.redraw(); });
    }});
    return [range, value];
  };
  $('settings').append(
    select('illuminant', 'Light', choices.illuminant.map(id => [id, id])),
    select('observer', 'Observer', [['1931-2deg', 'CIE 1931, 2 degrees'], ['1964-10deg', 'CIE 1964, 10 degrees']]),
    el('label', {}, 'Surrounded by ', outside), el('datalist', {id: 'media'}, ['water', '1.33', 'pmma', '1.5', 'fused_silica', 'air'].map(value => el('option', {value}))),
    el('label', {}, 'Roughness ', slide('roughness', {min: 0, max: 1, step: 0.01}, roughnessOf)),
    select('film', 'Thin film', ids(films, 'none')), el('label', {}, 'Thickness ', slide('thickness', {min: 5, max: 800, step: 5}, value => [value, `${value} nm`])),
    select('coat', 'Clear coat, 1 mm', ids(coats, 'none')),
    select('model', 'Shading model', [['', 'nearest to the measurement'], ...models.map(each => [each.id, each.title])]),
    el('button', {type: 'button', click: () => {
      for (const name of ['illuminant', 'observer', 'outside', 'roughness', 'model', 'film', 'thickness', 'coat']) state[name] = defaults[name];
      showSettings();
      changed();
    }}, 'As at first'));
  $('settings').addEventListener('submit', event => event.preventDefault());
}

// The slider's left end is no roughness but that of the family.
const roughnessOf = value => Number(value) === 0 ? ['', 'by family'] : [fixed(Number(value), 2), fixed(Number(value), 2)];

/** Shows the settings of the state in their fields. */
function showSettings() {
  for (const name of ['illuminant', 'observer', 'outside', 'film', 'thickness', 'coat', 'model']) $(`set-${name}`).value = state[name];
  $('set-roughness').value = state.roughness || 0;
  $('said-roughness').textContent = roughnessOf(state.roughness || 0)[1];
  $('said-thickness').textContent = `${state.thickness} nm`;
  tellSettings();
}

/** What a fragment says, at the start and when a link is followed. */
async function takeFragment(fragment) {
  const before = computeWords().join() + subjectOf('x'), fault = readFragment(fragment);
  if (!state.id && state.view === 'materials' && !fault && matchMedia('(min-width: 1100px)').matches) state.id = 'gold';
  complain(fault);
  showSettings();
  showView(state.view);
  grid.mark();
  cover();
  await changed({rows: before !== computeWords().join() + subjectOf('x') || !library.get('gold')?.row});
}

function openKeys() {
  const tabs = choices.view.map(view => $(`tab-${view}`));
  tabs.forEach((tab, i) => {
    tab.addEventListener('click', () => showView(choices.view[i]));
    tab.addEventListener('keydown', event => {
      const step = {ArrowRight: 1, ArrowLeft: tabs.length - 1}[event.key];
      if (step) { const next = tabs[(i + step) % tabs.length]; next.click(); next.focus(); }
    });
  });
  addEventListener('keydown', event => {
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName ?? '');
    if (event.key === '/' && !typing) { showView('materials'); $('search').focus(); event.preventDefault(); }
    if (event.key === 'Escape') {
      if (event.target.id === 'search' && $('search').value) { $('search').value = ''; grid.filter(); }
      else if (!typing && state.id) choose('');
    }
  });
  narrow.addEventListener('change', cover);
  addEventListener('hashchange', () => { if (location.hash.slice(1) !== written) takeFragment(location.hash); });
}

function tellTimes() {
  const {unpack, start, rows, balls: drawn} = engine.times;
  $('times').textContent = `Unpacked in ${fixed(unpack, 0)} ms, started in ${fixed(start, 0)} ms, all materials in ${fixed(rows, 0)} ms, the first ball ${fixed(engine.times.ball, 0)} ms and all in sight ${fixed(drawn, 0)} ms after opening.`;
}

async function begin() {
  const lack = engine.lacks();
  if (lack) {
    $('loading').hidden = true;
    complain(`${lack} The program for the command line needs no browser.`);
    return;
  }
  const opened = engine.open();
  const light = balls.light(engine, true).catch(error => complain(`No light for the balls: ${error.message}`));
  await opened;
  const begun = performance.now();
  const asked = Promise.all([engine.json(['list', '-q']), engine.json(['models', '-q']), engine.run(['--version'])]);
  await new Promise(done => setTimeout(done));  // all this is on its way before the next line, which takes the thread for a while
  balls.begin();
  const [list, models, version] = await asked;
  engine.times.rows = performance.now() - begun;
  for (const entry of list.materials) library.set(entry.id, entry);
  $('version').textContent = version.out.trim().split('\n')[0] || 'etak';
  $('search').placeholder = `Search ${library.size} materials: a name, alias or formula (press /)`;
  fillSettings(models.models.filter(each => each.kind === 'specular' || each.kind === 'both'));
  $('loading').hidden = true;
  grid.open();
  colour.open();
  files.open();
  openKeys();
  complain(balls.why, 'notice');
  grid.askFirst();
  const shown = takeFragment(location.hash);
  await light;
  grid.drawSoon();
  card.redraw();
  await shown;
  document.documentElement.dataset.ready = 'rows';
  if (balls.gl) await balls.light(engine, false).catch(() => {});  // the coarse light stays
  grid.redraw();
  card.frame();
  document.documentElement.dataset.ready = 'all';
}

begin().catch(error => {
  $('loading').hidden = true;
  complain(`The page could not start: ${error.message}`);
});
