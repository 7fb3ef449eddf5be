// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace etak {

/// Style sheet of the start page, below page_css.
inline constexpr std::string_view start_css = R"css(
.lead { max-width: 68ch; font-size: 1.2rem; }
.facts { display: flex; flex-wrap: wrap; gap: 0.5rem 2.5rem; margin: 1rem 0 0; padding: 0; list-style: none; }
.facts b { font-size: 1.7rem; font-variant-numeric: tabular-nums; }
section > p { max-width: 80ch; }
.wall { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 320px), 1fr)); gap: 0.9rem; margin: 1rem 0; }
.wall article { margin: 0; padding: 0.75rem 0.9rem; }
.wall h3 { margin: 0 0 0.4rem; font-size: 1rem; }
.balls { display: grid; grid-template-columns: repeat(3, 1fr); gap: 0.6rem; }
.balls img { display: block; width: 100%; max-width: 160px; height: auto; margin: 0 auto; }
.balls figcaption { text-align: center; font-variant-numeric: tabular-nums; }
.balls figcaption b { color: var(--ink); font-weight: 600; }
.balls .seen b { color: var(--warn); }
.wall summary { color: var(--link); cursor: pointer; font-size: 0.87rem; margin-top: 0.4rem; }
.wall pre { margin: 0.1rem 0 0.5rem; padding: 0.4rem 0.6rem; background: var(--page); border-radius: 6px; font-size: 0.8rem;
  overflow-x: auto; white-space: pre-wrap; overflow-wrap: anywhere; }
.wall h4 { font-size: 0.83rem; color: var(--ink-soft); font-weight: 600; }
.engine { margin: 0.6rem 0 0; }
.engine select { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 6px;
  padding: 0.2rem 0.4rem; }
.balls.copies { cursor: copy; }
.panel { background: var(--card); border-radius: 8px; padding: 1rem 1.25rem; overflow: hidden; }
.beside > *, .wide { min-width: 0; }
.wide { overflow-x: auto; }
.chart { display: block; width: 100%; min-width: 480px; max-width: 860px; height: auto; }
.chart text { fill: var(--ink-soft); font: 13px system-ui, "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; }
.chart .label { fill: var(--ink); }
.chart .name { fill: var(--ink); font-size: 14px; paint-order: stroke; stroke: var(--card); stroke-width: 4px; }
.chart .grid { stroke: var(--line); fill: none; }
.chart .reach { stroke: var(--plot-1); stroke-width: 2; fill: none; opacity: 0.6; }
.chart circle { fill: var(--plot-1); }
.beside { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 460px), 1fr)); gap: 1.25rem; align-items: start; }
.panel h3 { margin-top: 0; }
.textures { --texel: 0.26px; display: flex; flex-wrap: wrap; gap: 0.6rem; align-items: flex-end; }
.textures img { display: block; height: auto; width: calc(var(--wide) * var(--texel)); max-width: 100%; outline: 1px solid var(--line); }
.textures figcaption { max-width: calc(var(--wide) * var(--texel)); overflow-wrap: anywhere; min-width: 4rem; }
.severity { display: inline-block; min-width: 4.6rem; text-align: center; padding: 0 0.45rem; border-radius: 4px;
  font-size: 0.8rem; font-weight: 700; }
.severity.error { background: #b3261e; color: #fff; }
.severity.warning { background: #ffc46b; color: #3b2500; }
.severity.info { background: #cfe0f5; color: #12314f; }
.found { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 380px), 1fr)); gap: 0.9rem; margin: 0.8rem 0; }
.found article { margin: 0; display: flex; gap: 0.9rem; align-items: flex-start; overflow-wrap: anywhere; }
.found img { flex: none; width: 96px; height: 96px; object-fit: contain; background: var(--page); image-rendering: auto; outline: 1px solid var(--line); }
.found .place { color: var(--ink-soft); font-size: 0.87rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 280px), 1fr)); gap: 0.9rem; margin: 1rem 0 3rem; }
.cards a { display: block; background: var(--card); border-radius: 8px; padding: 1rem 1.1rem; color: inherit; border: 1px solid transparent; }
.cards a:hover, .cards a:focus-visible { border-color: var(--link); text-decoration: none; }
.cards h3 { margin: 0 0 0.3rem; color: var(--link); font-size: 1.1rem; }
.cards p { margin: 0; color: var(--ink-soft); }
.cards img { display: block; width: 100%; height: 120px; object-fit: cover; object-position: top; border-radius: 4px; margin-bottom: 0.6rem; }
.engine label { white-space: nowrap; margin-right: 1rem; }
.engine input { font: inherit; vertical-align: middle; }
.live { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 400px), 1fr)); gap: 0.9rem; margin: 1rem 0; }
.live > * { background: var(--card); border-radius: 8px; padding: 0.75rem 0.9rem; }
@media (min-width: 900px) { .live > :first-child { grid-row: span 3; } }
.live > :first-child::part(swatch) { width: 180px; }
@media (max-width: 600px) { .textures { --texel: 0.16px; } .panel { padding: 0.75rem; } .facts b { font-size: 1.4rem; } }
@media (min-width: 1400px) and (max-width: 2199px) { header, main { max-width: 1720px; } }
@media (min-width: 2200px) { .textures { --texel: 0.34px; } }
)css";

/// Script of the start page, below copy_script: a list of programs, and a click on the spheres of a material
/// copies its values for the chosen one.
inline constexpr std::string_view start_script = R"js(
(() => {
  const wall = document.querySelector('.wall');
  const names = [...wall.querySelector('article').querySelectorAll('pre')].map((pre) => pre.dataset.target);
  const line = document.createElement('p');
  line.className = 'engine';
  line.append('A click on the spheres copies the values for ');
  const select = document.createElement('select');
  select.setAttribute('aria-label', 'Program to copy values for');
  for (const name of names) select.add(new Option(name, name));
  line.append(select);
  wall.before(line);
  for (const article of wall.querySelectorAll('article')) {
    const balls = article.querySelector('.balls');
    balls.classList.add('copies');
    balls.tabIndex = 0;
    balls.setAttribute('role', 'button');
    balls.setAttribute('aria-label', 'Copy the values of ' + article.querySelector('h3').textContent);
    const copy = () => {
      const pre = [...article.querySelectorAll('pre')].find((each) => each.dataset.target === select.value);
      copy_text(pre.textContent);
    };
    balls.addEventListener('click', copy);
    balls.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); copy(); }
    });
  }
})();
)js";

/// Script of the section of materials computed in the page: its fields change the first of them.
inline constexpr std::string_view live_script = R"js(
(() => {
  const shown = document.querySelector('.live etak-material'), form = document.querySelector('#live form');
  form.addEventListener('submit', (event) => event.preventDefault());
  form.addEventListener('input', ({target}) => {
    if (target.name === 'roughness') shown.setAttribute('roughness', target.value);
    else if (target.value === '0') shown.removeAttribute('film');
    else if (target.name === 'film') shown.setAttribute('film', `anatase:${target.value}nm`);
    if (target.type !== 'range') return;
    const unit = target.name === 'film' ? ' nm' : '';
    target.nextElementSibling.textContent = unit && target.value === '0' ? 'none' : target.value + unit;
  });
  form.elements.id.addEventListener('change', ({target}) => { shown.id = target.value.trim(); });
})();
)js";

}  // namespace etak
