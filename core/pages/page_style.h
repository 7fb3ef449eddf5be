// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace etak {

/// Style sheet of the report pages. The light and the dark scheme use neutral greys, because a tinted page
/// would change how the colours of the swatches look.
inline constexpr std::string_view page_css = R"css(
:root { color-scheme: light dark; --page: #f2f2f2; --card: #ffffff; --ink: #1c1c1c; --ink-soft: #5c5c5c;
  --line: #d8d8d8; --link: #1a56a8; --warn: #8a4b00; --warn-bg: #ffe9c7; --bad: #a11d1d;
  --plot-1: #1f6fb4; --plot-2: #c4500c; --plot-3: #1c1c1c; }
@media (prefers-color-scheme: dark) {
  :root { --page: #161616; --card: #202020; --ink: #ececec; --ink-soft: #a8a8a8;
    --line: #3a3a3a; --link: #8ab8f5; --warn: #ffc46b; --warn-bg: #4a3410; --bad: #ff8f8f;
    --plot-1: #6fb3f2; --plot-2: #f29b5a; --plot-3: #ececec; }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body { margin: 0; background: var(--page); color: var(--ink); font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto,
  "Noto Sans", "DejaVu Sans", sans-serif; }
header, main { max-width: 1340px; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 2rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 0.5rem; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 0.5rem; }
h3 { font-size: 1.15rem; margin: 2rem 0 0.75rem; }
h4 { font-size: 1.1rem; margin: 0; }
p { margin: 0.4rem 0; max-width: 80ch; }
a { color: var(--link); text-decoration: none; }
a:hover, a:focus-visible { text-decoration: underline; }
code { font: 0.92em ui-monospace, "DejaVu Sans Mono", Consolas, monospace; }
.hidden { position: absolute; }
.lead { font-size: 1.1rem; }
.policy { color: var(--ink-soft); }
nav { display: flex; flex-wrap: wrap; gap: 0.4rem; margin: 1rem 0 0; }
nav a { padding: 0.15rem 0.6rem; border: 1px solid var(--line); border-radius: 1rem; background: var(--card); white-space: nowrap; }
nav span { color: var(--ink-soft); }
.scroll { overflow-x: auto; max-width: 100%; }
.strip { display: block; width: 100%; min-width: 760px; max-width: 1700px; height: auto; background: var(--card); border-radius: 8px; }
.strip text { font-size: 13px; fill: var(--ink-soft); font-variant-numeric: tabular-nums; }
.strip .label { fill: var(--ink); }
.strip .grid { stroke: var(--line); }
.strip .minor { stroke: var(--ink-soft); }
.strip .zone { fill: var(--warn-bg); }
.strip circle { stroke: var(--ink-soft); stroke-width: 0.8; }
.strip .bar { stroke: var(--ink-soft); opacity: 0.4; }
.strip a:hover circle, .strip a:focus-visible circle { stroke: var(--ink); stroke-width: 2; }
.data { border-collapse: separate; border-spacing: 0; font-size: 0.87rem; }
.data th, .data td { padding: 0.28rem 0.6rem; text-align: left; white-space: nowrap; border-bottom: 1px solid var(--line); }
.data thead th { font-weight: 600; color: var(--ink-soft); vertical-align: bottom; }
.data tbody th { font-weight: 500; }
.data .num { font-variant-numeric: tabular-nums; }
.data .preferred th { font-weight: 700; }
.data .inside { color: var(--warn); background: var(--warn-bg); }
.refused { color: var(--bad); }
.data td.wide { white-space: normal; min-width: 11rem; }
.data .refused { white-space: normal; }
.data .dataset { white-space: normal; min-width: 9rem; overflow-wrap: anywhere; }
.summary { width: 100%; background: var(--card); border-radius: 8px; }
article .data { font-size: 0.83rem; }
article .data th, article .data td { padding: 0.25rem 0.45rem; }
.summary .group th { font-size: 1rem; font-weight: 700; padding-top: 1.1rem; }
.summary tr:target { outline: 2px solid var(--link); outline-offset: -2px; }
.summary tbody tr:not(.group) th { white-space: normal; min-width: 10rem; position: sticky; left: 0; background: var(--card); }
.who { display: flex; align-items: center; gap: 0.6rem; }
.ball { flex: none; width: 44px; height: 44px; border-radius: 50%; outline: 1px solid var(--line); outline-offset: -1px; }
.swatches .ball { width: 128px; height: 128px; }
.pair { display: flex; flex: none; width: 52px; height: 36px; }
[data-copy].copies { cursor: copy; }
.copied { position: fixed; bottom: 1rem; left: 50%; transform: translateX(-50%); z-index: 9; padding: 0.3rem 0.9rem;
  border-radius: 6px; background: var(--ink); color: var(--page); font-size: 0.9rem; white-space: pre-line; max-width: 90vw; }
.flat tr > th::after { content: attr(data-class); display: block; font-size: 0.8rem; font-weight: 400; color: var(--ink-soft); }
.pair i { flex: 1; border: 1px solid var(--line); }
.pair .f0 { flex: 3; }
.flag { display: inline-block; padding: 0 0.4rem; border: 1px solid var(--line); border-radius: 4px; font-size: 0.8rem;
  color: var(--ink-soft); white-space: nowrap; }
article { background: var(--card); border-radius: 8px; padding: 1rem 1.25rem; margin: 0 0 1rem; }
article:target { outline: 2px solid var(--link); }
h4 code { color: var(--ink-soft); font-weight: 400; margin-left: 0.3rem; }
.up { float: right; font-size: 0.85rem; font-weight: 400; }
.about { color: var(--ink-soft); }
.swatches { display: flex; flex-wrap: wrap; gap: 0.75rem; align-items: flex-end; margin: 0.75rem 0; }
figure { margin: 0; }
figcaption { font-size: 0.8rem; color: var(--ink-soft); line-height: 1.35; margin-top: 0.25rem; }
.chip { width: 170px; height: 84px; display: flex; justify-content: flex-end; border: 1px solid var(--line); }
.big .chip { width: 280px; height: 128px; }
.big figcaption { color: var(--ink); }
.rim { display: flex; }
.rim .chip { width: 70px; height: 36px; }
.chip i { width: 25%; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 380px), 1fr)); gap: 1rem; margin: 0.5rem 0; }
.spread { margin: 0.8rem 0 0; }
.sources { font-size: 0.87rem; padding-left: 1.1rem; margin: 0.6rem 0 0; max-width: 110ch; overflow-wrap: anywhere; }
.sources li { margin: 0.3rem 0; }
.said { color: var(--ink-soft); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.3rem 1rem; }
dd { margin: 0; }
.filter { margin: 0.5rem 0; padding: 0.35rem 0.6rem; width: min(100%, 22rem); font: inherit; color: inherit; background: var(--card);
  border: 1px solid var(--line); border-radius: 6px; }
.sortable { cursor: pointer; font: inherit; color: inherit; background: none; border: 0; padding: 0; }
.sortable:hover { text-decoration: underline; }
.summary th, .summary td { padding-left: 0.42rem; padding-right: 0.42rem; }
main:has(#summary), header:has(+ main #summary) { max-width: 1420px; }
@media (min-width: 1460px) {
  #summary { overflow: visible; }
  .summary thead th { position: sticky; top: 0; background: var(--card); z-index: 1; }
}
/* Wide screens are used: two materials stand beside each other. */
@media (min-width: 2200px) {
  header, main, main:has(#summary), header:has(+ main #summary) { max-width: 2420px; }
  #materials { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; align-items: start; }
  #materials > * { min-width: 0; margin-bottom: 0; }
  #materials > :not(article) { grid-column: 1 / -1; }
}
@media (max-width: 600px) {
  header, main { padding-left: 0.75rem; padding-right: 0.75rem; }
  article { padding: 0.75rem; }
  h1 { font-size: 1.5rem; }
  .big .chip { width: 180px; height: 96px; }
  .swatches .ball { width: 96px; height: 96px; }
  .chip { width: 120px; height: 64px; }
  .ball { width: 32px; height: 32px; }
  dl { grid-template-columns: 1fr; gap: 0.1rem; }
  dd { margin-bottom: 0.5rem; }
  .pair { width: 44px; height: 26px; }
}
@media print { article { break-inside: avoid; } }
)css";

/// Script of pages with values to copy: a click on an element with data-copy copies that text and says so.
inline constexpr std::string_view copy_script = R"js(
const copy_text = (text) => {
  const tell = () => {
    document.querySelectorAll('.copied').forEach((old) => old.remove());
    const told = document.createElement('div');
    told.className = 'copied';
    told.setAttribute('role', 'status');
    told.textContent = 'copied: ' + text;
    document.body.append(told);
    setTimeout(() => told.remove(), 1800);
  };
  const by_selection = () => {
    const field = document.createElement('textarea');
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand('copy');
    field.remove();
    tell();
  };
  if (navigator.clipboard) navigator.clipboard.writeText(text).then(tell, by_selection);
  else by_selection();
};
for (const each of document.querySelectorAll('[data-copy]')) {
  each.classList.add('copies');
  each.title = 'click copies ' + each.dataset.copy;
}
document.addEventListener('click', (event) => {
  const from = event.target.closest('[data-copy]');
  if (from) copy_text(from.dataset.copy);
});
)js";

/// Script of the F0 page: a filter box above the summary table, and column titles that sort all materials: first
/// upwards, then downwards, then by classes again. The page is complete where scripts are off.
inline constexpr std::string_view page_script = R"js(
(() => {
  const box = document.getElementById('summary');
  const table = box.querySelector('table');
  const groups = [...table.tBodies];
  const homes = groups.map((body) => [...body.rows].filter((row) => !row.classList.contains('group')));
  const rows = homes.flat();
  for (const row of rows) row.cells[0].dataset.class = row.dataset.class;
  const flat = document.createElement('tbody');
  flat.className = 'flat';
  const input = document.createElement('input');
  input.type = 'search';
  input.className = 'filter';
  input.placeholder = 'Filter: name, flag, zone';
  input.setAttribute('aria-label', 'Filter the table');
  box.before(input);
  input.addEventListener('input', () => {
    const wanted = input.value.trim().toLowerCase();
    for (const row of rows) row.hidden = !row.textContent.toLowerCase().includes(wanted);
    groups.forEach((body, i) => { body.hidden = homes[i].every((row) => row.hidden); });
  });
  const value = (row, column) => (row.cells[column] ? row.cells[column].textContent : '');
  const titles = [...table.tHead.rows[0].cells];
  let sorted = -1, up = true;
  const arrange = () => {
    titles.forEach((cell, i) => {
      if (i === sorted) cell.setAttribute('aria-sort', up ? 'ascending' : 'descending');
      else cell.removeAttribute('aria-sort');
    });
    if (sorted < 0) {
      flat.remove();
      groups.forEach((body, i) => { body.append(...homes[i]); table.append(body); });
      return;
    }
    const order = (a, b) => {
      const x = value(a, sorted), y = value(b, sorted);
      const p = parseFloat(x), q = parseFloat(y);
      if (Number.isNaN(p) !== Number.isNaN(q)) return Number.isNaN(p) ? 1 : -1;
      return (up ? 1 : -1) * (Number.isNaN(p) ? x.localeCompare(y) : p - q);
    };
    groups.forEach((body) => body.remove());
    flat.append(...[...rows].sort(order));
    table.append(flat);
  };
  titles.forEach((cell, column) => {
    const button = document.createElement('button');
    button.className = 'sortable';
    button.title = 'sort all materials; the third click brings the classes back';
    button.textContent = cell.textContent;
    cell.replaceChildren(button);
    button.addEventListener('click', () => {
      if (sorted !== column) { sorted = column; up = true; }
      else if (up) up = false;
      else sorted = -1;
      arrange();
    });
  });
})();
)js";

}  // namespace etak
