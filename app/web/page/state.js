// SPDX-License-Identifier: Apache-2.0
'use strict';
// What is shown and how it is computed, and the same as the fragment of the address: a link is a citation.
//   #gold/johnson-1972&illuminant=A&outside=water&b=silver

const state = {
  view: 'materials', id: '', dataset: '', b: '', colour: '',
  illuminant: 'D65', observer: '1931-2deg', outside: '', roughness: '', model: '', film: '', thickness: '120', coat: '',
};
const defaults = {...state};

/** The materials of the library by id: the entries of `etak list`, with `row` of `etak f0`. */
const library = new Map();

const choices = {
  view: ['materials', 'colour', 'files'],
  illuminant: ['D65', 'D50', 'A', 'E'],
  observer: ['1931-2deg', '1964-10deg'],
};
const films = ['', 'anatase', 'titania_amorphous', 'fused_silica', 'sapphire', 'magnesium_fluoride', 'silicon_nitride', 'tantala', 'niobia', 'zincite', 'water'];
const coats = ['', 'pmma', 'polycarbonate', 'water', 'fused_silica'];
const word = /^[A-Za-z0-9_.-]{1,80}$/;

/** Why a value of a link cannot be taken, or an empty text. */
function faultOf(name, value) {
  if (choices[name]) return choices[name].includes(value) ? '' : `expected ${choices[name].join(', ')}`;
  if (name === 'roughness') return value !== '' && value >= 0 && value <= 1 ? '' : 'expected 0 to 1';
  if (name === 'thickness') return value >= 1 && value <= 2000 ? '' : 'expected 1 to 2000 nm';
  if (name === 'b') return library.has(value) ? '' : 'no material of the library';
  if (name === 'film' || name === 'coat') return library.has(value) ? '' : 'no material of the library';
  if (name === 'colour') return /^#?[0-9a-f]{6}$/i.test(value) ? '' : 'expected six hexadecimal digits';
  return word.test(value) ? '' : 'expected a name or a number';
}

const cut = text => text.length > 40 ? `${text.slice(0, 40)}...` : text;

/** Takes the state of a fragment. What it does not understand keeps its default, and is told in the text returned. */
function readFragment(fragment) {
  const faults = [], wanted = {...defaults};
  let parts = fragment.replace(/^#/, '').split('&').filter(Boolean);
  try {
    parts = parts.map(decodeURIComponent);
  } catch {
    Object.assign(state, defaults);
    return 'The link is broken: it holds a % without two digits.';
  }
  for (const [at, part] of parts.entries()) {
    const [name, ...rest] = part.split('='), value = rest.join('=');
    if (at === 0 && !rest.length) {
      const [id, dataset = ''] = part.split('/');
      if (!library.has(id)) faults.push(`no material has the id "${cut(id)}"`);
      else if (dataset && !word.test(dataset)) faults.push(`no dataset has the id "${cut(dataset)}"`);
      else Object.assign(wanted, {id, dataset});
    } else if (!(name in defaults) || name === 'id' || name === 'dataset') {
      faults.push(`"${cut(part)}" is nothing that a link holds`);
    } else {
      const fault = faultOf(name, value);
      if (fault) faults.push(`${name} "${cut(value)}": ${fault}`);
      else wanted[name] = value;
    }
  }
  Object.assign(state, wanted);
  return faults.length ? `The link is broken in part, the rest is shown: ${faults.join('; ')}.` : '';
}

/** The fragment of the state, without what is as it is by itself. */
function fragmentOf(from = state) {
  const rest = Object.entries(from).filter(([name, value]) => name !== 'id' && name !== 'dataset' && value !== defaults[name]
    && !(name === 'thickness' && !from.film)).map(([name, value]) => `${name}=${encodeURIComponent(value)}`);
  const first = from.id ? [from.id + (from.dataset ? `/${from.dataset}` : '')] : [];
  return [...first, ...rest].join('&');
}

let written = null;
/** Writes the state into the address, without a step in the history for each movement of a slider. */
function writeFragment() {
  const fragment = fragmentOf();
  if (fragment === written) return;
  written = fragment;
  try { history.replaceState(null, '', `#${fragment}`); } catch { /* some browsers limit how often */ }
}

/** The options of the program by which F0 is computed. */
function computeWords() {
  const words = [];
  if (state.illuminant !== 'D65') words.push('--illuminant', state.illuminant);
  if (state.observer !== '1931-2deg') words.push('--observer', state.observer);
  if (state.outside) words.push('--outside', state.outside);
  return words;
}

/** A material under the chosen film and coat, in the words of the program: pmma:1mm/anatase:120nm/titanium. */
function subjectOf(id, dataset = '') {
  const layers = [state.coat && `${state.coat}:1mm`, state.film && `${state.film}:${state.thickness}nm`].filter(Boolean);
  return [...layers, dataset ? `${id}/${dataset}` : id].join('/');
}
const isLayered = () => Boolean(state.film || state.coat);

const modelOf = entry => state.model || nearestModel(entry?.class);

const roughnessWords = () => state.roughness === '' ? [] : ['--roughness', state.roughness];
const shaderWords = (subject, model, size) => ballWords(subject, model, size, ...roughnessWords(), ...computeWords());
