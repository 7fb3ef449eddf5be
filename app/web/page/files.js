// SPDX-License-Identifier: Apache-2.0
'use strict';
// Files and folders of the user's: tables, pages and databases become a table of F0; what holds pictures or scenes is checked.

const isPicture = path => /\.(png|jpe?g|dds|ktx2?|tga|exr|hdr|tiff?|webp|bmp|psd|gltf|glb|usda|mtlx)$/i.test(path);
const isData = path => /\.(ya?ml|csv|tsv|txt|dat|json)$/i.test(path);
// A module of 32 bits has 4 GiB, and pictures unpacked take several times their files.
const mostBytes = 1.5e9;
const mostRows = 400;

const files = {
  token: 0,

  open() {
    addEventListener('dragover', event => { event.preventDefault(); $('drop').classList.add('over'); });
    addEventListener('dragleave', () => $('drop').classList.remove('over'));
    addEventListener('drop', event => {
      event.preventDefault();
      $('drop').classList.remove('over');
      this.dropped(event.dataTransfer);
    });
    $('stop').addEventListener('click', () => { ++this.token; $('work').textContent = 'Stopped.'; engine.restart('it was stopped'); });
    for (const id of ['choose-files', 'choose-folder'])
      $(id).addEventListener('change', event => {
        this.take([...event.target.files].map(file => ({path: file.webkitRelativePath || file.name, file})));
        event.target.value = '';
      });
  },

  /** Files of a drop, with those of its folders. All must be asked for before anything is waited for. A page from a disk cannot
   *  read a folder by its entries in Chromium, but by its handle, which passes over names with characters that Windows forbids; other
   *  browsers have entries alone. */
  async dropped(transfer) {
    const items = [...transfer.items].filter(item => item.kind === 'file').map(item => ({file: item.getAsFile(),
      entry: item.webkitGetAsEntry?.(), handle: item.getAsFileSystemHandle?.().catch(() => null)}));
    const found = [];
    for (const {file, entry, handle} of items) {
      try {
        if (!entry?.isDirectory) found.push({path: file.name, file});
        else if (location.protocol === 'file:' && await handle) await this.walkHandle(await handle, entry.name, found);
        else await this.walkEntry(entry, found);
      } catch (error) {
        complain(`${entry?.name ?? file?.name}: this browser does not let the page read what was dropped (${error.message}); "Choose a folder" can.`);
        return undefined;
      }
    }
    // A picture over the colour's panel is one to pick from.
    if (state.view === 'colour' && found.length === 1 && found[0].file.type.startsWith('image/')) return colour.picture(found[0].file);
    return this.take(found);
  },

  async walkHandle(handle, path, found) {
    for await (const [name, child] of handle.entries())
      if (child.kind === 'directory') await this.walkHandle(child, `${path}/${name}`, found);
      else found.push({path: `${path}/${name}`, file: await child.getFile()});
  },

  async walkEntry(entry, found) {
    if (entry.isFile) {
      found.push({path: entry.fullPath.replace(/^\//, ''), file: await new Promise((done, failed) => entry.file(done, failed))});
      return;
    }
    const reader = entry.createReader();
    for (let some; (some = await new Promise((done, failed) => reader.readEntries(done, failed))).length;)
      for (const each of some) await this.walkEntry(each, found);
  },

  async take(found) {
    const token = ++this.token;
    showView('files');
    complain('');
    $('results').replaceChildren();
    // Hidden files, such as those of .git, are no data.
    const chosen = found.filter(({path}) => !path.split('/').some(part => part.startsWith('.')));
    if (!chosen.length) { $('work').textContent = found.length ? 'There is nothing but hidden files in this.' : ''; return; }
    const size = chosen.reduce((sum, {file}) => sum + file.size, 0);
    if (size > mostBytes) {
      complain(`${chosen.length === 1 ? chosen[0].path : `${chosen.length} files`}: ${fixed(size / 1e9, 1)} GB; a page can hold ${fixed(mostBytes / 1e9, 1)} GB. The program for the command line has no such limit.`);
      return;
    }
    $('work').textContent = `Reading ${chosen.length === 1 ? chosen[0].path : `${chosen.length} files`} ...`;
    const pictures = chosen.some(({path}) => isPicture(path)), content = {};
    const wanted = pictures ? chosen : chosen.filter(({path}) => isData(path) || !path.includes('/'));
    try {
      for (let i = 0; i < wanted.length; i += 64)
        await Promise.all(wanted.slice(i, i + 64).map(async ({path, file}) => { content[path] = new Uint8Array(await file.arrayBuffer()); }));
    } catch (error) {
      complain(`A file could not be read: ${error.message}`);
    }
    if (token !== this.token) return;
    const names = [...new Set(Object.keys(content).map(path => path.split('/')[0]))];
    if (!names.length) { $('work').textContent = 'There is nothing in this that etak reads.'; return; }
    const slow = setTimeout(() => { $('stop').hidden = false; }, 1500);
    try {
      await (pictures ? report.check(names, content, () => token === this.token) : this.rows(names, content, () => token === this.token));
    } catch (error) {
      complain(error.message);
      $('work').textContent = '';
    }
    clearTimeout(slow);
    $('stop').hidden = true;
  },

  /** F0 of tables, pages and folders of them. */
  async rows(names, content, wanted) {
    const words = ['f0', ...computeWords()], inputs = ['--', ...names];
    const answer = await engine.run([...words, '--format', 'json', ...inputs], {files: content});
    if (!wanted()) return;
    let results = [];
    try { results = JSON.parse(answer.out).results; } catch { /* nothing was answered: the messages say why */ }
    const said = messages(answer.err);
    const sum = / (answered|failed)/.test(said.at(-1) ?? '') ? said.pop() : said.length ? 'Nothing was answered' : '1 answered';
    $('work').textContent = `${sum} (${fixed(answer.ms, 0)} ms)`;
    const csv = async () => {
      const saved = await engine.run([...words, '--format', 'csv', ...inputs], {files: content});
      save('f0.csv', saved.out, 'text/csv');
    };
    const shown = results.filter(row => row.linear || row.refused).slice(0, mostRows);
    const cells = shown.map(row => [el('span', {}, swatch(row.hex), row.path), ...(row.linear
      ? [row.hex, row.srgb8.join(' '), triple(row.linear), triple(row.f82?.absolute), fixed(row.Y, 4), row.flags.join(', ')]
      : ['-', '-', '-', '-', '-', row.refused ?? 'refused'])]);
    $('results').replaceChildren(...[
      results.length > 0 && el('p', {class: 'tools'}, el('button', {type: 'button', id: 'save-csv', click: csv}, 'Save as CSV')),
      said.length > 0 && el('details', {open: said.length < 20, class: 'said'}, el('summary', {}, `${said.length} ${said.length === 1 ? 'message' : 'messages'} of the program`),
        el('ul', {id: 'said'}, said.slice(0, 1000).map(line => el('li', {}, line)))),
      shown.length > 0 && table(['file', 'hex', '8 bit', 'F0, linear', 'F82', 'Y', 'flags'], cells),
      results.length > shown.length && el('p', {class: 'soft'}, `${shown.length} of ${results.length} rows are shown; the CSV holds all.`)].filter(Boolean));
  },
};
