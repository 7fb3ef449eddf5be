// SPDX-License-Identifier: Apache-2.0
// What the module is: exceptions, traps, hostile inputs, size, the package for npm, and times.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import test from 'node:test';
import {gzipSync, inflateSync} from 'node:zlib';
import {build, etak, filesBelow, fresh, inFolder, medianTime, module, nativeRun, root, wasm, write} from './support.mjs';

test('exceptions of C++ are thrown, caught, kept and thrown again', () => {
  const file = readFileSync(join(build, 'bin/etak_exceptions.wasm'));
  const {exports} = new WebAssembly.Instance(new WebAssembly.Module(file), {etak: {now: () => 0}});
  exports._initialize();
  const told = () => {
    const at = exports.told(), memory = Buffer.from(exports.memory.buffer);
    return memory.subarray(at, memory.indexOf(0, at)).toString().split('\n');
  };
  for (let i = 0; i < 3; ++i)
    assert.deepEqual(told(), ['again one', 'again one', 'b 2', 'c 3 uncaught 0', 'inner', 'int 1', 'text', 'alive 0',
      'in a destructor uncaught 1', 'int 2', 'no memory', 'out of range', '100000', '']);
});

test('the module asks its host for the time alone', () => {
  assert.deepEqual(WebAssembly.Module.imports(module).map(each => `${each.module}.${each.name}`), ['etak.now']);
});

test('module and page keep their sizes', context => {
  const packed = gzipSync(wasm, {level: 9}).length;
  context.diagnostic(`etak.wasm ${wasm.length} bytes, ${packed} by gzip`);
  assert.ok(packed < 2.8e6, `${packed} bytes by gzip`);
  const page = join(build, 'etak.html');
  if (existsSync(page)) assert.ok(readFileSync(page).length <= 2.4e6, `${readFileSync(page).length} bytes of etak.html`);
});

test('a run that needs more memory than there is ends with a sentence, and the next one works', async () => {
  const own = await fresh();
  const before = own.run(['f0', 'gold']);
  // A header of 60,000 x 60,000 texels.
  const png = Buffer.from('iVBORw0KGgoAAAANSUhEUgAA6mAAAOpgCAYAAAA=', 'base64');
  const deep = own.run(['validate', 'x.gltf'], {files: {'x.gltf': '['.repeat(5e6)}});
  assert.notEqual(deep.status, 0);
  assert.match(deep.out + deep.err, /x\.gltf/);
  const huge = own.run(['validate', 'x.png'], {files: {'x.png': png}});
  assert.notEqual(huge.status, 0);
  assert.ok(huge.err.length + huge.out.length > 0);
  assert.deepEqual(own.run(['f0', 'gold']), before);
});

// Of so little memory that the table does not fit into the module, that the program cannot read it, and that it cannot compute with it.
for (const [pages, status, said] of [[90, 134, /^etak f0: the program had to stop, most likely because there is not enough memory\n$/],
  [150, 2, /^etak: x\.csv: needs more memory than there is, for its 3 MiB; expected .*\n$/],
  [600, 2, /^etak: x\.csv: needs more memory than there is, for 3 MiB of text; expected .*\n$/]])
  test(`a table in ${pages} pages of memory ends with a sentence, and the next run works`, () => {
    const script = `import {readFileSync} from 'node:fs';
import {start} from ${JSON.stringify(join(build, 'etak.mjs'))};
const etak = await start(readFileSync(${JSON.stringify(join(build, 'etak.wasm'))})), gold = () => JSON.stringify(etak.run(['f0', 'gold']));
const table = 'wavelength_nm,n,k\\n' + Array.from({length: 2e5}, (_, i) => (300 + i * 0.005) + ',1.5,0.00' + (i % 9 + 1) + '\\n').join('');
const before = gold(), {status, err} = etak.run(['f0', 'x.csv'], {files: {'x.csv': table}});
console.log(JSON.stringify({status, err, same: gold() === before}));`;
    const got = JSON.parse(execFileSync('node', [`--wasm-max-mem-pages=${pages}`, '--input-type=module', '-e', script], {encoding: 'utf8'}));
    assert.equal(got.status, status);
    assert.match(got.err, said);
    assert.ok(got.same);
  });

test('a trap is status 134 and one line, and the next run has a new instance', async () => {
  const own = await fresh(), before = own.run(['f0', 'gold']);
  const got = own.run(['f0', '-'], {stdin: {length: 2 ** 31 - 1}});  // no bytes: the copy fails
  assert.equal(got.status, 134);
  assert.match(got.err, /^etak f0: .+\n$/);
  assert.deepEqual(own.run(['f0', 'gold']), before);
});

test('nothing of the fuzz corpus stops the module', () => {
  const ends = ['.png', '.dds', '.ktx2', '.gltf', '.glb', '.yml', '.csv', '.json', '.mtlx', '.usda', '.toml', ''];
  for (const [path, bytes] of filesBelow(join(root, 'tests/fuzz/corpus')))
    for (const end of ends)
      for (const cut of [bytes, bytes.subarray(0, bytes.length >> 1)])
        for (const verb of ['f0', 'validate']) {
          const got = etak.run([verb, `x${end}`], {files: {[`x${end}`]: cut}});
          assert.ok(got.status <= 2, `${verb} ${path} as x${end}: ${got.status} ${got.err}`);
        }
});

test('a thousand runs leave no memory behind', async () => {
  const own = await fresh(), files = {'a.csv': 'wavelength_nm,n,k\n360,1.5,0\n830,1.5,0\n'};
  const rounds = count => {
    for (let i = 0; i < count; ++i) {
      own.run(['f0', 'gold', 'a.csv', '-v'], {files});
      own.run(['f0', '-'], {stdin: files['a.csv']});
      own.run(['f0', 'golt']);
    }
    return own.memory();
  };
  const first = rounds(50);
  assert.equal(rounds(300), first);
});

test('the package for npm works where nothing else is', {skip: readdirSync(build).some(name => name.endsWith('.tgz')) ? false : 'no package'}, () => {
  inFolder(folder => {
    const packed = readdirSync(build).find(name => name.endsWith('.tgz'));
    execFileSync('tar', ['-xzf', join(build, packed), '-C', folder]);
    writeFileSync(join(folder, 'try.mjs'), `import {start} from './package/index.mjs';
const etak = await start();
console.log(etak.run(['f0', 'gold']).out + etak.f0('copper').results.length);`);
    const out = execFileSync('node', [join(folder, 'try.mjs')]).toString();
    assert.ok(out.includes('gold') && out.endsWith('1\n'), out);
  });
});

/** The pixels of a PNG of 8 bits that is not interlaced, as bytes. */
function pixelsOf(png) {
  const parts = [], width = png.readUInt32BE(16), channels = {0: 1, 2: 3, 4: 2, 6: 4}[png[25]];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  const rows = inflateSync(Buffer.concat(parts)), length = width * channels, out = Buffer.alloc(rows.length / (length + 1) * length);
  for (let i = 0; i < out.length; ++i) {
    const y = Math.floor(i / length), left = i % length >= channels, kind = rows[y * (length + 1)];
    const a = left ? out[i - channels] : 0, b = y ? out[i - length] : 0, c = left && y ? out[i - length - channels] : 0;
    const [pa, pb, pc] = [a, b, c].map(each => Math.abs(a + b - c - each)), paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    out[i] = rows[y * (length + 1) + 1 + i % length] + [0, a, b, a + b >> 1, paeth][kind];
  }
  return {width, channels, pixels: out.toString('base64')};
}

test('textures are packed into the pixels and the layout of the native program', () => {
  const names = ['crate_diff.png', 'crate_spec.png', 'wood_diff.png', 'wood_spec.png', 'grey_spec.png'];
  const files = names.map(name => [`set/${name}`, readFileSync(join(root, 'tests/cli/validate_inputs', name))]);
  for (const words of [[], ['--bleed'], ['--gutter', '4'], ['--mips', '3']])
    inFolder(folder => {
      write(folder, files);
      const line = ['pack', 'set', '-o', 'out', '--fail-on', 'never', ...words], there = nativeRun(line, {cwd: folder});
      const here = etak.run(line, {files: new Map(files), collect: true});
      assert.deepEqual([here.status, there.status], [0, 0], here.err);
      const made = filesBelow(join(folder, 'out'));
      assert.deepEqual(Object.keys(here.files).sort(), made.map(([path]) => `out/${path}`).sort());
      for (const [path, bytes] of made) {
        const mine = Buffer.from(here.files[`out/${path}`]);
        // Sums of files, whose bytes are another compressor's.
        const layout = text => text.toString().replace(/"xxh128": \{[^}]*\}/, '');
        if (path.endsWith('.png')) assert.deepEqual(pixelsOf(mine), pixelsOf(bytes), path);
        else assert.equal(layout(mine), layout(bytes), path);
      }
    });
});

test('materials in the documentation have the numbers of the program', () => {
  const told = {F0: 0, diffuse: 0};
  for (const [path, bytes] of filesBelow(join(root, 'resources/doc')).filter(([path]) => path.endsWith('.md') && path !== 'web.md'))
    for (const [, id, film, text] of bytes.toString().matchAll(/<etak-material id="([^"]+)"(?: film="([^"]+)")?>([^<]*)</g)) {
      const row = etak.f0(film ? `${film}/${id}` : id).results[0], what = row.class === 'surface' ? 'diffuse' : 'F0';
      const numbers = [row.linear.r, row.linear.g, row.linear.b].map(value => value.toFixed(4)).join(' ');
      assert.equal(text, `${row.name}: ${what} ${numbers}, ${row.hex}`, path);
      ++told[what];
    }
  assert.ok(told.F0 >= 5 && told.diffuse >= 1);
});

test('a table of all materials is there at once', async context => {
  const begin = performance.now();
  const own = await fresh(), started = performance.now();
  own.run(['f0', '--all', '--format', 'csv']);
  const first = performance.now(), kinds = ['A', 'D50', 'E', 'D65'];
  const warm = medianTime(20, i => own.run(['f0', '--all', '--format', 'csv', '--illuminant', kinds[i % 4]]));
  context.diagnostic(`start ${(started - begin).toFixed(1)} ms, first table ${(first - started).toFixed(1)} ms, later ${warm.toFixed(1)} ms`);
  assert.ok(warm < 400, `${warm} ms`);  // ten times what an idle machine takes
});
