// SPDX-License-Identifier: Apache-2.0
// node page.mjs PAGE ETAK [PICTURES]: the page in a headless Chromium against the native program.
//   PAGE       etak.html, or its address
//   ETAK       the program
//   PICTURES   folder for pictures of the page at three widths in both themes; none are taken without it
import {execFileSync, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import {extname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import assert from 'node:assert/strict';
import {Browser} from './browser.mjs';

const [pageFile, etakFile, pictures] = process.argv.slice(2);
const address = /^https?:/.test(pageFile) ? pageFile : pathToFileURL(resolve(pageFile)).href;
const source = resolve(fileURLToPath(import.meta.url), '../../..');
const scratch = mkdtempSync(join(tmpdir(), 'etak-page-'));
const etak = (...words) => execFileSync(resolve(etakFile), words, {cwd: scratch, maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore'], encoding: 'utf8'});
const json = (...words) => JSON.parse(etak(...words, '--format', 'json'));
const triple = c => [c.r, c.g, c.b].map(v => v.toFixed(4)).join(' ');

let failures = 0;
/** One claim; what fails is told, and the others are tried. */
async function claim(text, body) {
  const begun = Date.now();
  try {
    await body();
    console.log(`ok    ${text} (${Date.now() - begun} ms)`);
  } catch (error) {
    ++failures;
    console.log(`FAIL  ${text}: ${error.stack}`);
  }
}

const ready = "document.documentElement?.dataset.ready === 'all'";
const text = id => `document.getElementById('${id}').textContent`;
const cardText = `document.getElementById('card').innerText`;
const set = (id, value, event = 'change') => `{ const field = document.getElementById('${id}'); field.value = ${JSON.stringify(value)}; field.dispatchEvent(new Event('${event}', {bubbles: true})); }`;
const shown = "JSON.stringify(Object.fromEntries([...grid.cells].map(([id, cell]) => [id, cell.hex.textContent])))";

async function opened(browser, fragment = '', how = {}) {
  const page = await browser.page(address + (fragment && `#${fragment}`), how);
  await page.until(ready, 60);
  return page;
}

/** Hex codes of all cells are those of the program under the same words. */
async function sameCodes(page, words) {
  const wanted = Object.fromEntries(json('f0', '--all', ...words).results.map(row => [row.path, row.hex ?? 'no F0 here']));
  const keys = Object.keys(wanted).sort(), want = JSON.stringify(keys.map(key => wanted[key]));
  await page.until(`(all => JSON.stringify(${JSON.stringify(keys)}.map(key => all[key])) === ${JSON.stringify(want)})(JSON.parse(${shown}))`, 20);
}

async function values(browser) {
  const page = await opened(browser, 'gold');
  await claim('every code of the grid is the program\'s', () => sameCodes(page, []));
  for (const id of ['gold', 'water', 'silicon', 'diamond', 'apple', 'anodised_titanium_40nm', 'gold/johnson-1972'])
    await claim(`the card of ${id} has the program's numbers`, async () => {
      const row = json('f0', id).results[0];
      await page.value(`location.hash = '#${id}'`);
      for (const part of [triple(row.linear), row.srgb8.join(' '), row.hex, row.Y.toFixed(4), ...(row.f82 ? [triple(row.f82.absolute)] : []), row.source])
        await page.until(`${cardText}.includes(${JSON.stringify(part.replace(/\s+/g, ' '))})`);
    });
  await claim('the values for an engine are the program\'s', async () => {
    await page.value(`location.hash = '#copper'`);
    const targets = json('export', 'copper', '--to', 'values').materials[0].targets;
    await page.until(`document.querySelector('#card h2').textContent === 'Copper' && document.querySelector('#part-engines pre')`);
    for (const target of targets) {
      await page.value(set('engine', target.id));
      assert.equal(await page.value("document.querySelector('#part-engines pre').textContent"), target.copy);
    }
    assert.ok(targets.length > 20);
  });
  await claim('the distance of two materials is the program\'s', async () => {
    await page.value(`location.hash = '#gold&b=silver'`);
    const near = json('nearest', 'gold', '-n', '1000', '--class', 'metal').nearest.find(each => each.id === 'silver');
    await page.until(`document.getElementById('difference')?.textContent.includes('${near.delta_e2000.toFixed(2)} (CIEDE2000)')`);
  });
  await claim('what a colour could be is what the program says', async () => {
    await page.value(`location.hash = '#view=colour&colour=ffe29b'`);
    await page.until(`${text('answer')}.startsWith('#ffe29b: sure')`);
    const best = json('identify', '#ffe29b').results[0].candidates[0];
    assert.ok((await page.value(text('answer'))).includes(best.p.toFixed(2)));
    await page.value(`document.getElementById('typed').value = '<b>x</b>'; document.getElementById('ask').requestSubmit()`);
    await page.until(`document.querySelector('#answer .problem')?.textContent.includes('<b>x</b>')`);
  });
  return page;
}

async function settings(page) {
  await page.value(`location.hash = '#gold'`);
  await claim('light, observer and surroundings change all codes at once', async () => {
    await page.value(set('set-illuminant', 'A'));
    await sameCodes(page, ['--illuminant', 'A']);
    await page.value(set('set-outside', 'water'));
    await sameCodes(page, ['--illuminant', 'A', '--outside', 'water']);
    await page.value(set('set-observer', '1964-10deg'));
    await sameCodes(page, ['--illuminant', 'A', '--outside', 'water', '--observer', '1964-10deg']);
  });
  await claim('surroundings that are none are told in the program\'s words', async () => {
    await page.value(set('set-outside', 'nonsuch'));
    await page.until(`${text('settings-problem')}.includes('nonsuch')`);
    await page.value("[...document.querySelectorAll('#settings button')].pop().click()");
    await sameCodes(page, []);
  });
  await claim('a film changes codes as a stack of the program does', async () => {
    await page.value(set('set-film', 'anatase'));
    await page.value(set('set-thickness', '120', 'input'));
    await page.value(set('set-thickness', '125', 'input'));
    const hex = json('f0', 'anatase:125nm/titanium').results[0].hex;
    await page.until(`JSON.parse(${shown}).titanium === '${hex}'`);
    await page.value(set('set-coat', 'pmma'));
    const coated = json('f0', 'pmma:1mm/anatase:125nm/titanium').results[0].hex;
    await page.until(`JSON.parse(${shown}).titanium === '${coated}'`);
  });
  await claim('roughness and model change balls', async () => {
    const picture = "grid.cells.get('gold').canvas.toDataURL()";
    await page.value("[...document.querySelectorAll('#settings button')].pop().click()");
    await page.until("grid.cells.get('gold').key === 'drawn'");
    const before = await page.value(picture);
    await page.value(set('set-roughness', '0.6', 'input'));
    await page.until(`grid.cells.get('gold').key === 'drawn' && ${picture} !== ${JSON.stringify(before)}`);
    await page.value(set('set-model', 'phong-schlick'));
    await page.until(`location.hash.includes('model=phong-schlick')`);
    await page.value("[...document.querySelectorAll('#settings button')].pop().click()");
  });
}

async function links(browser, page) {
  const link = 'gold/johnson-1972&b=silver&illuminant=A&outside=water&roughness=0.4&film=anatase&thickness=90';
  await claim('a link brings the same state back', async () => {
    const other = await opened(browser, link);
    assert.deepEqual(new Set((await other.value('location.hash.slice(1)')).split('&')), new Set(link.split('&')));
    const row = json('f0', 'anatase:90nm/gold/johnson-1972', '--illuminant', 'A', '--outside', 'water').results[0];
    await other.until(`${cardText}.includes('${row.hex}')`);
    assert.equal(await other.value("document.getElementById('set-outside').value"), 'water');
    await other.close();
  });
  for (const [broken, said] of [['nosuch', 'nosuch'], ['gold&colour=red', 'red'], ['gold&<img src=x onerror=alert(1)>=1', 'is broken in part'],
    ['%E0%A4%A', 'without two digits'], ['gold&illuminant=Z&observer=A', 'illuminant "Z"'], ['gold/../../x&b=', 'is broken in part']])
    await claim(`a broken link is one clear line: ${broken}`, async () => {
      await page.value(`location.hash = ${JSON.stringify(`#${broken}`)}`);
      await page.until(`!document.getElementById('problem').hidden && ${text('problem')}.includes(${JSON.stringify(said)})`);
      assert.ok(!(await page.value(text('problem'))).includes('\n'));
      assert.equal(await page.value("document.querySelectorAll('img[src=\"x\"]').length"), 0);
      await page.value("location.hash = '#silver'");
      await page.until("document.getElementById('problem').hidden");
    });
}

async function keys(page) {
  await claim('keys lead through the page', async () => {
    await page.value("document.body.focus(); scrollTo(0, 0)");
    await page.key('/');
    assert.equal(await page.value('document.activeElement.id'), 'search');
    await page.call('Input.insertText', {text: 'Au'});
    await page.until("grid.shown[0].id === 'gold'");
    await page.key('Escape');
    await page.until(`grid.shown.length === ${json('list').materials.length}`);
    await page.value("document.querySelector('#grid [tabindex=\"0\"]').focus()");
    const first = await page.value('document.activeElement.dataset.id');
    await page.key('ArrowRight');
    await page.key('ArrowDown');
    await page.key('ArrowUp');
    const next = await page.value('document.activeElement.dataset.id');
    assert.notEqual(next, first);
    await page.key('Enter');
    await page.until(`location.hash.startsWith('#${next}')`);
    await page.until("document.getElementById('big-ball')");
    await page.value("document.getElementById('big-ball').focus()");
    await page.key('ArrowRight');
    assert.notEqual(await page.value('orbit.turn'), 0);
    await page.key('Escape');
    await page.until("state.id === ''");
    await page.value("document.getElementById('tab-materials').focus()");
    await page.key('ArrowRight');
    await page.until("!document.getElementById('colour').hidden");
    await page.key('ArrowLeft');
    await page.until("!document.getElementById('materials').hidden");
  });
  await claim('what the card covers on a narrow window is out of reach', async () => {
    await page.size(400, 800);
    await page.value("location.hash = '#copper'");
    await page.until("document.querySelector('.library').inert && document.querySelector('header').inert");
    await page.size(1280, 900);
    await page.until("!document.querySelector('.library').inert");
  });
  await claim('everything that can be pressed has a name', async () => {
    await page.value("location.hash = '#gold&b=silver'");
    await page.until(`document.getElementById('difference')`);
    assert.deepEqual(JSON.parse(await page.value(`JSON.stringify([...document.querySelectorAll('button, input, select, canvas[tabindex], [role=tab], [role=listbox]')]
      .filter(each => !(each.getAttribute('aria-label') || each.textContent.trim() || each.labels?.length)).map(each => each.outerHTML.slice(0, 100)))`)), []);
  });
  await claim('a click copies, and says so', async () => {
    await page.value("navigator.clipboard ? Object.defineProperty(navigator.clipboard, 'writeText', {value: async text => { window.copiedText = text; }}) : 0");
    await page.value("[...document.querySelectorAll('#card .copy')].find(each => each.textContent === 'Copy citation').click()");
    await page.until("window.copiedText?.startsWith('etak, gold/')");
    await page.value("[...document.querySelectorAll('#card .copy')].find(each => each.textContent === 'Copy BibTeX').click()");
    await page.until("window.copiedText?.startsWith('@article{olmon2012optical,')");
    await page.until(`${text('live')}.startsWith('Copied')`);
  });
}

const hostile = '<img src=x onerror=alert(1)>';
function writeDrops() {
  const put = (name, content) => { mkdirSync(join(scratch, name, '..'), {recursive: true}); writeFileSync(join(scratch, name), content); return join(scratch, name); };
  const table = 'wavelength_nm,n,k\n360,1.5,0\n500,1.52,0\n830,1.5,0\n';
  const pageText = 'REFERENCES: "A. <b>Author</b>, <script>alert(1)</script> 2020"\nCOMMENTS: "x"\nDATA:\n  - type: tabulated nk\n    data: |\n        0.3 1.5 2.0\n        0.5 1.4 2.5\n        0.9 1.3 3.0\n';
  const png = name => readFileSync(join(source, 'tests/cli/validate_inputs', name));
  return {
    table: put('glass.csv', table), page: put('Author.yml', pageText),
    commas: put('commas.csv', 'nm;n;k\n360;1,5;0\n500;1,5;0\n830;1,5;0\n'),
    hostile: put(`${hostile.replaceAll('/', '')}.csv`, `${hostile},n,k\n1,2,3\n`), hostileTable: put('<b>bold<b>.csv', table),
    folder: (put('data/a/one.csv', table), put('data/b/two.yml', pageText), put('data/broken.csv', '\0\xff junk'), put('data/.hidden.csv', table), join(scratch, 'data')),
    textures: (put('set/crate_diff.png', png('crate_diff.png')), put('set/crate_spec.png', png('crate_spec.png')),
      put('set/&lt;i&gt;_spec.png', png('grey_spec.png')), put('set/broken_spec.png', 'junk'), put('set/sky.exr', 'v/1\x01'), join(scratch, 'set')),
    pair: (['crate_diff.png', 'crate_spec.png', 'wood_diff.png', 'wood_spec.png'].forEach(name => put(`pair/${name}`, png(name))), join(scratch, 'pair')),
    empty: put('empty.csv', ''), deep: put('deep.json', '['.repeat(200000)),
  };
}

async function drops(browser, page) {
  const files = writeDrops();
  const answered = async (wanted, ...paths) => {
    await page.value("complain(''); document.getElementById('results').replaceChildren(); document.getElementById('work').textContent = ''");
    await page.drop(...paths);
    await page.until(wanted);
  };
  const saved = async (button, name) => {
    const file = join(browser.profile, name);
    rmSync(file, {force: true});
    await page.value(`document.getElementById('${button}').click()`);
    for (let i = 0; i < 200 && !existsSync(file); ++i) await new Promise(done => setTimeout(done, 50));
    await new Promise(done => setTimeout(done, 200));
    return readFileSync(file, 'utf8');
  };
  const results = text('results');
  await claim('a table is answered as the program answers it', async () => {
    await answered(`${results}.includes('glass.csv')`, files.table);
    const row = json('f0', 'glass.csv').results[0];
    for (const part of [row.hex, triple(row.linear), triple(row.f82.absolute)]) assert.ok((await page.value(results)).includes(part), part);
    assert.equal(await saved('save-csv', 'f0.csv'), etak('f0', 'glass.csv', '--format', 'csv'));
  });
  await claim('decimal commas are read or refused as the program does', async () => {
    const native = spawnSync(resolve(etakFile), ['f0', 'commas.csv'], {cwd: scratch, encoding: 'utf8'}), words = native.stderr.split('\n')[0].replace('etak: ', '');
    await answered(`${results}.includes(${JSON.stringify(native.status ? words : 'commas.csv')})`, files.commas);
  });
  await claim('a page of refractiveindex.info is answered', async () => {
    await answered(`${results}.includes('${json('f0', 'Author.yml').results[0].hex}')`, files.page);
  });
  await claim('a folder is answered row by row, and what is broken is named', async () => {
    await answered(`${results}.includes('a/one.csv') && ${results}.includes('data/broken.csv')`, files.folder);
    assert.ok(!(await page.value(results)).includes('.hidden'));
  });
  await claim('names and cells with markup stay text', async () => {
    await answered(`${results}.includes('onerror')`, files.hostile);
    await answered(`${results}.includes('<b>bold<b>')`, files.hostileTable);
    assert.equal(await page.value("document.querySelectorAll('#results img, #results b').length"), 0);
  });
  await claim('textures are checked in the program\'s words', async () => {
    await answered(`${text('work')}.includes('errors')`, files.textures);
    const report = JSON.parse(spawnSync(resolve(etakFile), ['validate', '--format', 'json', 'set'], {cwd: scratch, encoding: 'utf8'}).stdout);
    const said = await page.value(results);
    for (const file of report.files) {
      assert.ok(said.includes(file.path), file.path);
      // A picture that no decoder at hand reads has other words in the program with its module of pictures.
      for (const finding of file.findings.filter(each => each.id !== 'ETK001')) assert.ok(said.includes(finding.message), finding.message);
    }
    assert.ok(said.includes('sky.exr'));
    assert.equal(await page.value("document.querySelectorAll('#results i').length"), 0);
    assert.ok(await page.value("document.querySelectorAll('.finding img').length") > 0, 'masks');
    await page.value("document.querySelector('.rule').open = true");
    await page.until("document.querySelector('.rule pre').textContent.includes('ETK')");
  });
  await claim('reports are saved as HTML, JSON and SARIF', async () => {
    assert.ok((await saved('save-html', 'etak-report.html')).startsWith('<!DOCTYPE html>'));
    assert.equal(JSON.parse(await saved('save-json', 'etak-report.json')).schema, 'etak-validation/1');
    assert.equal(JSON.parse(await saved('save-sarif', 'etak-report.sarif')).version, '2.1.0');
  });
  await claim('textures are packed as the program packs them, into a ZIP', async () => {
    await answered(`document.getElementById('pack')`, files.pair);
    await saved('pack', 'etak-atlas.zip');
    await page.until(`${text('packed')}.startsWith('etak-atlas.zip has')`);
    execFileSync('python3', ['-m', 'zipfile', '-e', join(browser.profile, 'etak-atlas.zip'), join(scratch, 'unzipped')]);  // checks the sums, too
    const out = spawnSync(resolve(etakFile), ['pack', 'pair', '-o', 'atlas', '--fail-on', 'never'], {cwd: scratch, encoding: 'utf8'}).stdout;
    assert.ok((await page.value(results)).includes(out.split('\n')[0]));
    const layout = folder => readFileSync(join(scratch, folder, 'layout.json'), 'utf8').replace(/"xxh128": \{[^}]*\}/, '');
    assert.equal(layout('unzipped/atlas'), layout('atlas'));
    assert.deepEqual(readdirSync(join(scratch, 'unzipped/atlas')).sort(), readdirSync(join(scratch, 'atlas')).sort());
    if (pictures) await page.picture(join(pictures, 'packed.png'));
  });
  await claim('empty, deep and huge files are one clear line, and the page lives on', async () => {
    await answered(`${results}.includes('empty.csv')`, files.empty);
    await answered(`${results}.includes('deep.json') || ${text('problem')}.includes('deep')`, files.deep);
    await page.value("files.take([{path: 'huge.csv', file: {size: 5e9}}])");
    await page.until(`${text('problem')}.includes('huge.csv: 5.0 GB')`);
    await answered(`${results}.includes('glass.csv')`, files.table);
  });
}

/** What the browser's program writes is what this machine's writes, by SHA-256. */
async function hashes(page) {
  const settings = [[], ['--illuminant', 'A'], ['--illuminant', 'D50'], ['--illuminant', 'E'], ['--observer', '1964-10deg'], ['--outside', 'water'],
    ['--space', 'acescg'], ['--space', 'rec2020'], ['--outside', '1.33'], ['--illuminant', 'A', '--observer', '1964-10deg', '--outside', 'water']];
  const lines = [...settings.flatMap(words => ['csv', 'json'].map(format => ['f0', '--all', '--format', format, ...words])),
    ['export', '--all', '--to', 'values', '--format', 'json'], ['export', 'gold', '--to', 'mtlx'], ['export', 'water', '--to', 'gltf'],
    ['f0', 'anatase:40nm/titanium', 'magnesium_fluoride:100nm/bk7', '-v'], ['identify', '#ffe29b', '--format', 'json'],
    ['identify', '#7f5fb0', '--film', 'titanium'], ['show', 'gold', '--format', 'json'], ['show', 'water'], ['nearest', 'gold'],
    ['curve', 'silver', '--format', 'json'], ['shader', 'copper', '--es', '--format', 'json', '--env', 'studio'],
    ...json('models').models.filter(each => each.kind !== 'diffuse').map(each => ['shader', 'gold', '--es', '--format', 'json', '--model', each.id])];
  await claim(`${lines.length} outputs have the hashes of those of the program`, async () => {
    const wanted = lines.map(words => createHash('sha256').update(etak(...words)).digest('hex'));
    const got = JSON.parse(await page.value(`(async () => {
      const hashes = [];
      for (const words of ${JSON.stringify(lines)}) {
        const digest = await crypto.subtle.digest('SHA-256', (await engine.run(words)).outBytes);
        hashes.push([...new Uint8Array(digest)].map(byte => byte.toString(16).padStart(2, '0')).join(''));
      }
      return JSON.stringify(hashes);
    })()`));
    assert.deepEqual(lines.filter((_, i) => got[i] !== wanted[i]).map(words => words.join(' ')), []);
  });
}

/** Spheres of the page's shaders against those of `etak render`, in codes. */
async function spheres(page) {
  const size = 256;
  for (const [id, model, light] of [['gold', 'ggx-f82', ['--lights', 'sources']], ['silicon', 'schueler-optimized-bounded', ['--lights', 'sources']],
    ['apple', 'ggx-schlick', ['--lights', 'sources']], ['gold', 'ggx-f82', ['--env', 'studio', '--ground', '0.5,0.5,0.5', '--tone', 'neutral', '--exposure', '0.7']]])
    await claim(`the sphere of ${id} by ${model}, ${light[1]}, is within 1 code of etak render`, async () => {
      const words = [id, '--model', model, ...light, '--size', String(size)];
      etak('render', ...words, '--ambient', 'moving', '--device', 'cpu', '-o', 'sphere.png', '--force', '-q');
      const png = readFileSync(join(scratch, 'sphere.png')).toString('base64');
      const far = JSON.parse(await page.value(`(async () => {
        const shader = await engine.json(['shader', '--es', ...${JSON.stringify(words)}]);
        balls.draw(shader, ${size});
        const mine = new Uint8Array(${size * size * 4}), gl = balls.gl;
        gl.readPixels(0, 0, ${size}, ${size}, gl.RGBA, gl.UNSIGNED_BYTE, mine);
        const bytes = Uint8Array.from(atob('${png}'), letter => letter.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], {type: 'image/png'}), {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
        const canvas = new OffscreenCanvas(${size}, ${size}), context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const theirs = context.getImageData(0, 0, ${size}, ${size}).data, counts = [0, 0, 0];
        for (let y = 0; y < ${size}; ++y) for (let x = 0; x < ${size}; ++x) for (let c = 0; c < 3; ++c)
          ++counts[Math.min(2, Math.abs(mine[4 * ((${size} - 1 - y) * ${size} + x) + c] - theirs[4 * (y * ${size} + x) + c]))];
        return JSON.stringify(counts);
      })()`));
      console.log(`      values equal, 1 code off, more: ${far.join(', ')}`);
      assert.ok(far[2] <= 1e-4 * size * size * 3, `${far[2]} values are more than a code off`);
    });
  await claim('the shaders of all models compile under WebGL 2', async () => {
    const models = json('models').models.filter(each => ['specular', 'both', 'diffuse'].includes(each.kind));
    const faults = JSON.parse(await page.value(`(async () => {
      const faults = [];
      let count = 0;
      for (const [id, kind] of ${JSON.stringify(models.map(each => [each.id, each.kind]))})
        for (const material of ['gold', 'pmma', 'apple'])
          for (const light of [['--lights', 'sources'], ['--env', 'studio', '--tone', 'neutral', '--orbit', '20']]) {
            let shader;
            try { shader = await engine.json(['shader', material, '--es', kind === 'diffuse' ? '--diffuse-model' : '--model', id, ...light]); } catch { continue; }
            ++count;
            try { balls.draw(shader, 32); } catch (error) { faults.push(id + ': ' + error.message); }
          }
      return JSON.stringify([count, faults]);
    })()`));
    assert.deepEqual(faults[1], []);
    assert.ok(faults[0] > 100, `${faults[0]} shaders`);
  });
}

/** No request but those for the page itself and for what it made; nothing printed, no element of a stranger. */
async function silence(page) {
  await claim('nothing was asked of any network, nothing printed', async () => {
    const strange = page.requests.filter(url => !url.startsWith('blob:') && !url.startsWith('data:') && url.split('#')[0] !== address);
    assert.deepEqual(strange, []);
    assert.deepEqual(page.printed, []);
    assert.equal(await page.value("document.querySelectorAll('script:not([id])').length"), await page.value("document.querySelectorAll('body > script:not([id])').length"));
  });
}

async function poorer(browser) {
  await claim('without WebGL 2 the page says why and shows flat colours', async () => {
    const plain = await Browser.open({webgl: false});
    try {
      const page = await opened(plain, 'gold');
      assert.ok((await page.value(text('notice'))).includes('no WebGL 2'));
      assert.equal(await page.value("getComputedStyle(grid.cells.get('gold').disc).backgroundColor"), 'rgb(255, 228, 156)');
      await page.until(`${cardText}.includes('#ffe49c')`);
    } finally { await plain.close(); }
  });
  const without = byte => `const all = WebAssembly.validate; WebAssembly.validate = bytes => !bytes.includes(${byte}) && all(bytes);`;
  for (const [name, script] of [['WebAssembly', 'delete window.WebAssembly'], ['exceptions', without(25)], ['128-bit vectors', without(253)]])
    await claim(`a browser without ${name} is told in one line`, async () => {
      const page = await browser.page('about:blank');
      await page.call('Page.addScriptToEvaluateOnNewDocument', {source: script});
      await page.call('Page.navigate', {url: address});
      await page.until(`document.getElementById('problem')?.textContent.includes('This browser has')`);
      assert.match(await page.value(text('problem')), new RegExp(`has (no|WebAssembly without) ${name},`));
      await page.close();
    });
  await claim('a program that stops is started anew, and the page says so', async () => {
    const page = await opened(browser, 'gold');
    await page.value("document.getElementById('stop').click()");
    await page.value("location.hash = '#silver'");
    await page.until(`${cardText}.includes('#fefdfc')`);
    await page.close();
  });
}

const elements = script => `<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width"><style>:root { color-scheme: light dark; font: 16px/1.4 "DejaVu Sans", sans-serif; }
  #large etak-material::part(swatch) { width: 200px; }</style>${script}<p>Of gold: <etak-material id="gold">a text for readers without scripts</etak-material></p>
  <p><etak-material id="gold/johnson-1972" illuminant="A"></etak-material></p><p><etak-material id="&lt;img src=x&gt;"></etak-material></p>
  <p><etak-material id="titanium" film="anatase:120nm" coat="pmma"></etak-material></p><p><etak-material id="water"></etak-material></p>
  <div id="large"><etak-material id="apple" gloss="0.9"></etak-material></div>`;
const inside = (at, what) => `document.querySelectorAll('etak-material')[${at}].shadowRoot?.${what}`;
const elementWords = [[0, ['gold']], [1, ['gold/johnson-1972', '--illuminant', 'A']], [3, ['pmma:1mm/anatase:120nm/titanium']], [4, ['water']], [5, ['apple']]];

/** What elements of a page say, and whether the others have a ball. */
async function elementsSay(page, drawn = true) {
  for (const [at, words] of elementWords) {
    const row = json('f0', ...words).results[0], what = row.class === 'surface' ? 'diffuse' : 'F0';
    await page.until(`${inside(at, 'textContent')}?.includes('${what} ${triple(row.linear)}, ${row.hex}')`);
    assert.equal(await page.value(inside(at, "querySelector('[role=img]').getAttribute('aria-label')")), `Ball of ${row.name}, ${what} ${row.hex}`);
    if (drawn) await page.until(inside(at, "querySelector('canvas').classList.contains('drawn')"));
  }
  await page.until(`${inside(2, 'textContent')} === '<img src=x>: no material, file or folder has this name; expected a name that etak list shows'`);
  assert.equal(await page.value(inside(2, "querySelectorAll('img').length")), 0);
}

/** <etak-material> in pages of somebody else's: one that serves it with etak.mjs and etak.wasm, one from a disk, one without WebGL. */
async function element(browser, own) {
  const folder = /^https?:/.test(pageFile) ? '' : resolve(pageFile, '..');
  if (!existsSync(join(folder, 'etak.wasm'))) { console.log('skip  <etak-material>: there is no etak.wasm beside the page'); return; }
  const kinds = {'.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm'};
  const server = createServer((request, answer) => {
    const name = request.url.slice(1);
    answer.setHeader('Content-Type', kinds[extname(name)] ?? 'text/html');
    answer.setHeader('Access-Control-Allow-Origin', '*');
    answer.end(kinds[extname(name)] ? readFileSync(join(folder, name))
      : elements(`<script type="module" src="${name === 'strange' ? `http://localhost:${server.address().port}/` : ''}element.js"></script>`));
  });
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  try {
    const page = await browser.page('about:blank'), here = `http://127.0.0.1:${server.address().port}/`;
    await page.call('Page.addScriptToEvaluateOnNewDocument', {source: `window.contexts = 0; const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function(kind, ...how) { window.contexts += kind === 'webgl2'; return get.call(this, kind, ...how); };`});
    await page.call('Page.navigate', {url: here});
    await claim('elements show materials as balls in another page, by one context of WebGL', async () => {
      await elementsSay(page);
      assert.equal(await page.value('window.contexts'), 1);
      assert.ok(page.requests.every(url => url.startsWith(here) || url === 'about:blank'), page.requests.join(' '));
    });
    await claim('the ball of an element is that of the page', async () => {
      const picture = await own.value(`(async () => {
        const canvas = document.createElement('canvas');
        balls.show(await engine.json(ballWords('gold', 'ggx-f82', 64)), canvas, 64);
        return canvas.toDataURL();
      })()`);
      await page.until(`${inside(0, "querySelector('canvas').toDataURL()")} === ${JSON.stringify(picture)}`);
    });
    await claim('attributes of an element change its ball and its numbers', async () => {
      const picture = inside(0, "querySelector('canvas').toDataURL()");
      for (const [name, value] of [['roughness', '0.7'], ['model', 'phong-schlick'], ['outside', 'water']]) {
        const before = await page.value(picture);
        await page.value(`document.querySelector('etak-material').setAttribute('${name}', '${value}')`);
        await page.until(`${inside(0, "querySelector('canvas.drawn')")} && ${picture} !== ${JSON.stringify(before)}`);
      }
      await page.until(`${inside(0, 'textContent')}.includes('${json('f0', 'gold', '--outside', 'water').results[0].hex}')`);
    });
    await page.close();
    await claim('an element can come from another server', async () => {
      const strange = await browser.page(`${here}strange`);
      await elementsSay(strange);
      await strange.close();
    });
  } finally {
    server.close();
  }
  const file = join(scratch, 'elements.html'), onDisk = pathToFileURL(file).href, script = pathToFileURL(join(folder, 'etak-element.js')).href;
  writeFileSync(file, elements(`<script src="${script}"></script>`));
  await claim('elements show balls in a page from a disk, which asks for nothing but their script', async () => {
    for (const [width, dark] of pictures ? [[1280, false], [1280, true], [360, false]] : [[1280, false]]) {
      const page = await browser.page(onDisk, {width, dark});
      await elementsSay(page);
      assert.deepEqual(page.requests.filter(url => !url.startsWith('blob:')), [onDisk, script]);
      assert.ok(await page.value('document.documentElement.scrollWidth') <= width);
      if (pictures) { mkdirSync(pictures, {recursive: true}); await page.picture(join(pictures, `elements-${width}${dark ? '-dark' : ''}.png`)); }
      await page.close();
    }
  });
  await claim('without WebGL 2 elements are discs of their colours', async () => {
    const plain = await Browser.open({webgl: false});
    try {
      const page = await plain.page(onDisk);
      await elementsSay(page, false);
      assert.equal(await page.value(`getComputedStyle(${inside(0, "querySelector('i')")}).backgroundColor`), 'rgb(255, 228, 156)');
      assert.equal(await page.value(`getComputedStyle(${inside(0, "querySelector('i')")}).visibility`), 'visible');
    } finally { await plain.close(); }
  });
}

async function takePictures(browser) {
  mkdirSync(pictures, {recursive: true});
  for (const [width, height] of [[360, 800], [1280, 900], [2560, 1440]])
    for (const dark of [false, true])
      for (const [name, fragment] of [['start', ''], ['card', 'gold&b=silver'], ['colour', 'view=colour&colour=ffe29b'], ['files', '']]) {
        const page = await opened(browser, fragment, {width, height, dark});
        if (name === 'files') { await page.drop(join(scratch, 'set')); await page.until(`${text('work')}.includes('errors')`); }
        await new Promise(done => setTimeout(done, 1500));
        await page.picture(join(pictures, `${name}-${width}${dark ? '-dark' : ''}.png`));
        assert.ok(await page.value('document.documentElement.scrollWidth') <= width, `${name} is wider than ${width}`);
        await page.close();
      }
}

const browser = await Browser.open();
try {
  const page = await values(browser);
  await settings(page);
  await links(browser, page);
  await hashes(page);
  await keys(page);
  await spheres(page);
  await drops(browser, page);
  await silence(page);
  await poorer(browser);
  await element(browser, page);
  if (pictures) await claim('no picture of the page is wider than its window', () => takePictures(browser));
} finally {
  await browser.close();
  rmSync(scratch, {recursive: true, force: true});
}
console.log(failures ? `${failures} claims failed` : 'all claims hold');
process.exitCode = failures ? 1 : 0;
