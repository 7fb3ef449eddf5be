// SPDX-License-Identifier: Apache-2.0
'use strict';
// Elements, numbers as text, messages, saving and copying. All texts go in as text: nothing that a file, a name or a
// link holds is ever read as markup.

const $ = id => document.getElementById(id);

/** An element. Functions among the attributes listen to the event of their name; children are elements or texts. */
function el(tag, attributes = {}, ...children) {
  const out = tag.startsWith('svg:') ? document.createElementNS('http://www.w3.org/2000/svg', tag.slice(4))
                                     : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') out.addEventListener(name, value);
    else if (value !== undefined && value !== null && value !== false) out.setAttribute(name, value === true ? '' : value);
  }
  out.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined && child !== false));
  return out;
}

/** A disc or square of a colour; `hex` must be one of the program's (#rrggbb). */
function swatch(hex, kind = 'swatch') {
  const out = el('i', {class: kind, 'aria-hidden': 'true'});
  if (/^#[0-9a-f]{6}$/i.test(hex ?? '')) out.style.background = hex;
  return out;
}

// Numbers have a decimal point in every browser's language.
const fixed = (value, digits) => Number.isFinite(value) ? value.toFixed(digits) : '-';
const triple = (color, digits = 4) => color ? [color.r, color.g, color.b].map(v => fixed(v, digits)).join(' ') : '-';

/** A line for people, read out by screen readers. */
function say(text) { $('live').textContent = text; }

/** One clear line about what went wrong; empty text takes it away. */
function complain(text, where = 'problem') {
  $(where).textContent = text;
  $(where).hidden = !text;
}

/** The messages of a run without the program's name in front. */
const messages = err => err.split('\n').map(line => line.replace(/^etak: /, '')).filter(Boolean);

/** The cells of a line of CSV. */
const cellsOf = line => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain);

/** Offers bytes or a text as a file to save. */
function save(name, content, type) {
  const url = URL.createObjectURL(new Blob([content], {type}));
  const link = el('a', {href: url, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
  say(`${name} is saved.`);
}

/** Copies a text; without a clipboard, as in pages from a disk in some browsers, by a selection. */
async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = el('textarea', {class: 'unseen', 'aria-hidden': 'true'});
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    if (!done) { complain(`${what}: this browser does not let the page copy; select the text instead.`); return false; }
  }
  say(`Copied: ${what}`);
  return true;
}

/** A button that copies what `text()` gives, and says so for a moment. */
function copier(label, text, what = label, kind = 'copy') {
  const button = el('button', {type: 'button', class: kind, title: `Copy ${what}`}, label);
  button.addEventListener('click', async () => {
    if (!await copy(text(), what)) return;
    button.classList.add('copied');
    setTimeout(() => button.classList.remove('copied'), 1200);
  });
  return button;
}

/** A table: `heads` are texts, rows are arrays of texts or elements; the first of a row is its head. */
function table(heads, rows, caption) {
  return el('div', {class: 'scroll'}, el('table', {},
    caption && el('caption', {}, caption),
    el('thead', {}, el('tr', {}, heads.map(head => el('th', {scope: 'col'}, head)))),
    el('tbody', {}, rows.map(row => el('tr', {}, row.map((cell, i) => el(i ? 'td' : 'th', i ? {} : {scope: 'row'}, cell)))))));
}
