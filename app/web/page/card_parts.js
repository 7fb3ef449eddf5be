// SPDX-License-Identifier: Apache-2.0
'use strict';
// The parts of a card that take a moment more. Each has `now`, what stands there at once, and `then`, what follows.

const soon = () => el('p', {class: 'soft'}, '...');

async function curveParts(entry, subject, words) {
  const others = conducts(entry.class) || isLayered() ? ['schlick', 'f82'] : ['schlick', 'from-f0'];
  const names = {schlick: 'Schlick from F0', f82: 'F82', 'from-f0': 'exact from F0'};
  const out = [];
  try {
    const angle = await engine.json(['curve', subject, '--of', 'F', ...['spectrum', ...others].flatMap(term => ['--term', term]), '-q', ...words]);
    const kinds = ['true', 'other', 'third'], labels = [isLayered() ? 'exact' : 'measured', ...others.map(term => names[term])];
    const curves = angle.curves.map((curve, i) => ({...curve, label: labels[i] ?? curve.title, kind: kinds[i % 3]}));
    out.push(chart({title: 'Over the angle', x: 'degrees from the normal', y: angle.y, curves, zones: angle.zones.slice(1)}),
      el('ul', {class: 'soft errors'}, curves.slice(1).map(curve => el('li', {}, `${distanceOf(curves[0], curve)}.`))));
  } catch (error) {
    out.push(el('p', {class: 'soft'}, `No curve over the angle: ${error.message}.`));
  }
  const wave = await engine.json(['curve', subject, '--of', 'R', '-q', ...words]);
  out.push(chart({title: 'Over the wavelength', x: 'nm', y: wave.y, curves: wave.curves.slice(0, 1).map(curve => ({...curve, label: 'reflectance', kind: 'true'}))}));
  return out;
}

/** What a target changes or leaves out, in the program's words. */
function lossesOf(target) {
  const lost = target.changes.map(change => `${change.field}: ${change.action}, by ${fixed(change.amount, 4)}; ${change.reason}`);
  const error = target.error ? `Against the measured spectrum at all angles: CIEDE2000 ${fixed(target.error.mean, 2)} in the mean, ${fixed(target.error.max, 2)} at worst.`
    : target.error_reason && `No error is told: ${target.error_reason}.`;
  return [el('p', {}, error), target.formula && el('p', {class: 'soft'}, target.formula),
    el('ul', {class: 'soft errors'}, [...lost, ...target.notes].map(text => el('li', {}, text)))];
}

let engineShown = 'unreal';
async function engineParts(entry, subject, words) {
  const answer = await engine.json(['export', subject, '--to', 'values', ...roughnessWords(), ...words, '-q']);
  const targets = answer.materials[0]?.targets ?? [], pre = el('pre', {class: 'values', tabindex: 0, 'aria-label': 'Values'}), losses = el('div', {});
  if (!targets.length) return el('p', {class: 'soft'}, answer.messages.join('; ') || 'There are no values for engines.');
  const shown = () => targets.find(target => target.id === engineShown) ?? targets[0];
  const tell = () => { pre.textContent = shown().copy; losses.replaceChildren(...lossesOf(shown())); };
  const select = el('select', {id: 'engine', 'aria-label': 'Engine or format', change: event => { engineShown = event.target.value; tell(); }},
    targets.map(target => el('option', {value: target.id}, `${target.title}, ${target.version}`)));
  select.value = shown().id;
  pre.addEventListener('click', () => copy(shown().copy, `values for ${shown().title}`));
  tell();
  return [el('p', {class: 'tools'}, select, copier('Copy', () => shown().copy, 'the values')), pre, losses];
}

/** CIEDE2000 between F0 of two materials of the library, as `etak nearest` says it. */
async function distanceTo(subject, other, words) {
  const near = await engine.json(['nearest', subject, '-n', '1000', '--class', other.class, ...words]);
  return near.nearest.find(each => each.id === other.id);
}

async function compareParts(entry, subject, words) {
  const list = el('select', {id: 'compare', 'aria-label': 'Compare with', change: event => { state.b = event.target.value; changed({rows: false}); }},
    el('option', {value: ''}, 'choose a material'),
    [...library.values()].sort((a, b) => a.name < b.name ? -1 : 1).map(each => el('option', {value: each.id}, each.name)));
  list.value = state.b;
  const other = library.get(state.b), out = [el('p', {class: 'tools'}, el('label', {}, 'with ', list),
    other && el('button', {type: 'button', click: () => { const was = state.id; choose(other.id, was); }}, 'Swap'))];
  if (!other) return out;
  const [found, plain] = await Promise.all([distanceTo(subject, other, words), engine.json(['f0', other.id, '-q', ...words])]);
  // The other one is as the library has it, without film and coat.
  const mine = await engine.json(['f0', subject, '-q', ...words]);
  const sides = [[entry, mine.results[0]], [other, plain.results[0]]].map(([each, row]) => {
    const canvas = el('canvas', {width: 0, height: 0, 'aria-hidden': 'true'});
    if (balls.gl && balls.lit) balls.shader(shaderWords(each === other ? other.id : subject, modelOf(each), ballSize(130)))
      .then(shader => balls.show(shader, canvas, ballSize(130))).catch(() => {});
    return el('figure', {}, el('span', {class: 'ball'}, swatch(row.hex, 'disc'), canvas),
      el('figcaption', {}, el('b', {}, each === entry && isLayered() ? `${each.name} with its layers` : each.name), el('br'), row.hex, el('br'), triple(row.linear)));
  });
  out.push(el('div', {class: 'pair'}, sides), el('p', {id: 'difference'}, found
    ? `ΔE ${fixed(found.delta_e2000, 2)} (CIEDE2000) between their F0${found.band_share ? `; that is ${fixed(found.band_share, 2)} of the distance within which nine of ten new publications of ${other.name} would lie` : ''}. About 1 is what an eye can tell.`
    : 'No distance is told for these two.'));
  return out;
}

/** A list of materials with their distance, each of which opens its card. */
function nearList(items) {
  return el('ul', {class: 'near'}, items.map(each => el('li', {}, el('button', {type: 'button', click: () => choose(each.id)},
    swatch(each.hex), el('span', {}, each.name), el('span', {class: 'soft num'}, each.text)))));
}

async function nearParts(entry, subject, words) {
  const near = await engine.json(['nearest', subject, '-n', '7', ...(entry.class === 'surface' ? ['--class', 'surface'] : []), ...words]);
  return nearList(near.nearest.filter(each => each.id !== entry.id || isLayered())
    .map(each => ({...each, text: `ΔE ${fixed(each.delta_e2000, 2)}`})));
}

const parts = [
  {id: 'engines', title: 'Values for engines', now: soon, then: engineParts},
  {id: 'curves', title: 'Reflectance', now: soon, then: curveParts},
  {id: 'compare', title: 'Compare', now: soon, then: compareParts},
  {id: 'near', title: 'Nearest in the library', now: soon, then: nearParts},
];
