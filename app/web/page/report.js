// SPDX-License-Identifier: Apache-2.0
'use strict';
// What `etak validate` finds in textures, sets of them and scenes, in its own words.

const report = {
  urls: [],

  async check(names, content, wanted) {
    const inputs = ['--', ...names];
    $('work').textContent = `Checking ${Object.keys(content).length} files ...`;
    const answer = await engine.run(['validate', '--format', 'json', '--mask', 'masks', ...inputs], {files: content, collect: true});
    if (!wanted()) return;
    let found;
    try { found = JSON.parse(answer.out); } catch {
      complain(messages(answer.err).join(' ') || `etak validate ended with status ${answer.status}`);
      $('work').textContent = '';
      return;
    }
    const {errors, warnings, infos, files: count, clean} = found.summary;
    $('work').textContent = `${found.summary.passed ? 'Passed' : 'Not passed'}: ${errors} errors, ${warnings} warnings, ${infos} infos in ${count} files, ${clean} clean (${fixed(answer.ms, 0)} ms)`;
    for (const url of this.urls.splice(0)) URL.revokeObjectURL(url);
    const masks = new Map(Object.entries(answer.files).map(([path, bytes]) => [path.replace(/^.*\//, ''), bytes]));
    const saver = (format, name, type) => el('button', {type: 'button', id: `save-${format}`, click: async () => {
      const saved = await engine.run(['validate', '--format', format, ...inputs], {files: content});
      save(name, saved.outBytes ?? saved.out, type);
    }}, `Save ${format.toUpperCase()}`);
    const said = messages(answer.err), [pack, packed] = packer(names, content);
    $('results').replaceChildren(
      el('p', {class: 'tools'}, saver('html', 'etak-report.html', 'text/html'), saver('json', 'etak-report.json', 'application/json'),
        saver('sarif', 'etak-report.sarif', 'application/sarif+json'), pack), packed,
      said.length ? el('ul', {id: 'said', class: 'said'}, said.slice(0, 1000).map(line => el('li', {}, line))) : '',
      ...found.files.map(file => this.fileOf(file, masks)));
  },

  fileOf(file, masks) {
    const rank = {error: 0, warning: 1, info: 2}, size = file.width ? ` ${file.width} x ${file.height}` : '';
    const findings = [...file.findings].sort((a, b) => rank[a.severity] - rank[b.severity]);
    const roles = file.roles.map(each => each.file === file.path ? each.role : `${each.role}: ${each.file}`).join(', ');
    return el('article', {class: 'checked'},
      el('h3', {}, file.path), el('p', {class: 'soft'}, `${roles}${size}${file.unreadable ? ', could not be read' : ''}`),
      findings.length ? el('ul', {class: 'findings'}, findings.map(finding => this.findingOf(finding, masks))) : el('p', {}, 'Nothing was found.'));
  },

  findingOf(finding, masks) {
    const rule = el('details', {class: 'rule', toggle: async event => {
      const body = event.target.querySelector('pre');
      if (event.target.open && !body.textContent) body.textContent = (await engine.run(['explain', finding.id])).out;
    }}, el('summary', {}, `${finding.id} ${finding.slug}`), el('pre', {}));
    const mask = masks.get(`${finding.file.replaceAll('/', '_')}.${finding.id}.png`);
    let picture = '';
    if (mask) {
      const url = URL.createObjectURL(new Blob([mask], {type: 'image/png'}));
      this.urls.push(url);
      picture = el('img', {src: url, alt: `Where ${finding.id} was found in ${finding.file}`, loading: 'lazy'});
    }
    const place = [finding.file, finding.bbox && `[${finding.bbox.join(', ')}]`, finding.pointer, finding.material].filter(Boolean).join(' ');
    return el('li', {class: 'finding'}, picture, el('div', {},
      el('p', {}, el('span', {class: `severity ${finding.severity}`}, finding.severity), ' ', el('span', {class: 'soft'}, place)),
      el('p', {}, `${finding.message}.`), finding.fix && el('p', {}, el('b', {}, 'Fix. '), finding.fix), rule));
  },
};
