// SPDX-License-Identifier: Apache-2.0
'use strict';
// Curves of `etak curve` as a picture: axes, lines, and a cross that tells the values under the pointer or by arrow keys.

const plot = {width: 460, height: 250, left: 46, right: 12, top: 12, bottom: 34};

/** Round marks of an axis from `first` to `last`, about `count` of them. */
function marksOf(first, last, count) {
  const rough = (last - first) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].find(each => each * power >= rough * 0.999) * power, out = [];
  for (let i = Math.ceil(first / step - 1e-9); i * step <= last + step * 1e-9; ++i) out.push(i * step);
  return {marks: out, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9) + (step / power === 2.5 ? 1 : 0))};
}

/** The picture of curves [{label, x, y, kind}], `kind` being the class of the line; y is in [0, top]. */
function chart({title, x: xName, y: yName, curves, zones = []}) {
  const {width, height, left, right, top, bottom} = plot;
  const xs = curves[0].x, first = xs[0], last = xs[xs.length - 1];
  const most = Math.max(0.02, ...curves.flatMap(curve => curve.y)), ceiling = most > 1 ? most * 1.02 : most > 0.6 ? 1 : most * 1.1;
  const X = value => left + (value - first) / (last - first) * (width - left - right);
  const Y = value => height - bottom - value / ceiling * (height - top - bottom);
  const line = curve => curve.x.map((x, i) => `${i ? 'L' : 'M'}${X(x).toFixed(1)} ${Y(curve.y[i]).toFixed(1)}`).join('');
  const across = marksOf(first, last, 6), up = marksOf(0, ceiling, 5);
  const cross = el('svg:path', {class: 'cross', d: ''}), told = el('figcaption', {class: 'told'});
  const picture = el('svg:svg', {viewBox: `0 0 ${width} ${height}`, class: 'plot', role: 'img', tabindex: 0,
      'aria-label': `${title}: ${xName} across, ${yName} up; left and right keys tell values`},
    zones.map(zone => el('svg:rect', {class: 'zone', x: X(zone.first), y: top, width: X(zone.last) - X(zone.first), height: height - top - bottom})),
    up.marks.map(value => [el('svg:path', {class: 'grid', d: `M${left} ${Y(value)}H${width - right}`}),
      el('svg:text', {x: left - 6, y: Y(value) + 4, 'text-anchor': 'end'}, fixed(value, up.digits))]),
    across.marks.map(value => [el('svg:path', {class: 'grid', d: `M${X(value)} ${top}V${height - bottom}`}),
      el('svg:text', {x: X(value), y: height - bottom + 15, 'text-anchor': 'middle'}, fixed(value, across.digits))]),
    el('svg:text', {x: (left + width - right) / 2, y: height - 3, 'text-anchor': 'middle'}, xName),
    curves.map(curve => el('svg:path', {class: `curve ${curve.kind}`, d: line(curve)})), cross);
  let at = Math.round(xs.length / 2);
  const tell = index => {
    at = Math.min(xs.length - 1, Math.max(0, index));
    cross.setAttribute('d', `M${X(xs[at])} ${top}V${height - bottom}`);
    told.textContent = `${fixed(xs[at], Number.isInteger(xs[at]) ? 0 : 1)}: ` + curves.map(curve => `${curve.label} ${fixed(curve.y[at], 4)}`).join(', ');
  };
  picture.addEventListener('pointermove', event => {
    const box = picture.getBoundingClientRect(), share = ((event.clientX - box.left) / box.width * width - left) / (width - left - right);
    tell(Math.round(share * (xs.length - 1)));
  });
  picture.addEventListener('keydown', event => {
    const step = {ArrowRight: 5, ArrowLeft: -5}[event.key];
    if (step) { tell(at + step); event.preventDefault(); }
  });
  return el('figure', {class: 'chart'}, el('figcaption', {class: 'legend'}, el('b', {}, title),
    curves.map(curve => el('span', {}, el('i', {class: `key ${curve.kind}`, 'aria-hidden': 'true'}), curve.label))), picture, told);
}

/** The largest distance of a curve from the true one, in words. */
function distanceOf(truth, curve) {
  let worst = 0;
  for (let i = 0; i < truth.y.length; ++i)
    if (Math.abs(curve.y[i] - truth.y[i]) > Math.abs(curve.y[worst] - truth.y[worst])) worst = i;
  return `${curve.label}: off by at most ${fixed(Math.abs(curve.y[worst] - truth.y[worst]), 4)}, at ${fixed(truth.x[worst], 1)} degrees`;
}
