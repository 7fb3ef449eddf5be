// SPDX-License-Identifier: Apache-2.0
// The module answers as the native program does, byte for byte: core takes sine, power and the like from core/math, since those of C
// libraries differ in the last digit.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {comparing, data, etak, filesBelow, inFolder, native, root, sameAnswer} from './support.mjs';

const settings = [[], ['--illuminant', 'A'], ['--illuminant', 'D50'], ['--illuminant', 'E'], ['--observer', '1964-10deg'],
  ['--outside', 'water'], ['--outside', '1.33'], ['--space', 'acescg'], ['--space', 'rec2020'], ['--space', 'display-p3'],
  ['--space', 'xyz'], ['--coat', 'pmma'], ['--illuminant', 'A', '--observer', '1964-10deg', '--outside', 'water', '--bands']];

comparing('F0 of all materials is equal in CSV and JSON under all settings', () => {
  for (const setting of settings)
    for (const format of ['csv', 'json']) sameAnswer(['f0', '--all', '--format', format, ...setting]);
});

comparing('tables, pages and texts of F0 are equal', () => {
  for (const format of ['table', 'html', 'jsonl']) sameAnswer(['f0', '--all', '--format', format]);
  for (const words of [['-v'], ['--sort', 'y'], ['--class', 'metal'], ['--all-datasets', '--format', 'csv']])
    sameAnswer(['f0', '--all', ...words]);
});

const ids = etak.list().materials.map(each => each.id);

comparing('lists, records, models, rules and help are equal', () => {
  for (const words of [['list'], ['list', '--format', 'json'], ['models'], ['models', '--format', 'json'], ['help'], ['--version'],
    ['validate', '--list-rules'], ['validate', '--list-rules', '--format', 'json']]) {
    if (words[0] === 'help') continue;  // it names the verbs that there are
    sameAnswer(words);
  }
  for (const verb of ['f0', 'list', 'show', 'nearest', 'identify', 'import', 'export', 'eval', 'models', 'curve', 'shader', 'validate',
    'explain']) {
    sameAnswer(['help', verb]);
    sameAnswer([verb, '--help-all']);
  }
  for (const id of ids) sameAnswer(['show', id, '--format', 'json']);
  for (const id of ['gold', 'water', 'pmma']) sameAnswer(['show', id]);
  for (const rule of JSON.parse(etak.run(['validate', '--list-rules', '--format', 'json']).out).rules) sameAnswer(['explain', rule.id]);
});

comparing('values of all materials for all targets are equal, and files for renderers', () => {
  sameAnswer(['export', '--all', '--to', 'values', '--format', 'json']);
  for (const id of ['gold', 'pmma', 'water', 'silicon', 'titanium'])
    for (const to of ['values', 'mtlx', 'gltf', 'unreal,blender,filament'])
      sameAnswer(['export', id, '--to', to]);
  sameAnswer(['export', 'gold', '--to', 'values', '--coat', 'pmma', '--roughness', '0.3', '--format', 'json']);
});

comparing('shaders of all models are equal', () => {
  const models = JSON.parse(etak.run(['models', '--format', 'json']).out).models.map(each => each.id);
  assert.ok(models.length > 20);
  for (const model of models)
    for (const id of ['gold', 'pmma'])
      for (const words of [[], ['--es', '--format', 'json']]) sameAnswer(['shader', id, '--model', model, ...words]);
  for (const words of [['--env', 'studio'], ['--lights', 'sources'], ['--shape', 'quad']])
    sameAnswer(['shader', 'copper', '--es', '--format', 'json', ...words]);
});

comparing('bands, stacks, coats, colours, formulas and curves are equal', () => {
  for (const words of [['f0', '--all', '--bands', '--format', 'csv'], ['f0', 'anatase:40nm/titanium', 'anatase:120nm/titanium', '-v'],
    ['f0', 'magnesium_fluoride:100nm/bk7', '--format', 'json'], ['f0', 'gold', '--coat', '1.5'], ['identify', '#ffe29b'],
    ['identify', '#ffe29b', '--format', 'json'], ['identify', '#7f5fb0', '--film', 'titanium'], ['nearest', '#ffe29b'],
    ['nearest', 'gold', '--format', 'json'], ['eval', '--list'], ['curve', 'gold', 'copper'], ['curve', 'gold', '--format', 'csv'],
    ['curve', 'silver', '--format', 'json'], ['curve', 'bk7', '--format', 'csv', '--coat', 'water']])
    sameAnswer(words);
});

comparing('mistakes are told in the same words', () => {
  for (const words of [['f0', 'golt'], ['f0'], ['f0', 'gold', '--illuminant', 'X'], ['f0', 'none.csv'], ['export', 'gold', '--to', 'nothing'],
    ['show', 'milk'], ['shader', 'gold', '--model', 'x'], ['f0', '--nothing'], ['validate', 'none.png'], ['eval', 'x'], ['f0', '-o', 'no/x.csv', 'gold']])
    sameAnswer(words);
});

comparing('tables, pages and standard input are read alike', () => {
  const table = 'wavelength_nm;n;k\n360;1,5;0\n500;1,5;0,1\n830;1,6;0\n';
  const files = [['a table.csv', table], ['ü/日本.csv', table.replaceAll(',', '.').replaceAll(';', ',')], ['broken.csv', 'wavelength_nm,n\n1,x\n'],
    ['empty.csv', ''], ['notes.md', 'no table']];
  sameAnswer(['f0', 'a table.csv', 'ü/日本.csv', '-v'], files);
  sameAnswer(['f0', 'ü/日本.csv', '--format', 'json'], files);
  sameAnswer(['f0', '.', '--format', 'csv'], files);
  sameAnswer(['f0', 'broken.csv'], files);
  sameAnswer(['f0', 'empty.csv'], files);
  sameAnswer(['f0', '-', '--format', 'csv'], [], {stdin: table});
  sameAnswer(['import', 'a table.csv', '-o', 'm.json', '--id', 'mine', '--name', 'Mine', '--class', 'metal'], files);
});

comparing('files that the program writes are collected', () => {
  const got = etak.run(['f0', '--all', '-o', 'out/f0.csv'], {files: {'out/readme': 'x'}, collect: true});
  assert.equal(got.status, 0, got.err);
  assert.deepEqual(Object.keys(got.files), ['out/f0.csv']);
  assert.equal(Buffer.from(got.files['out/f0.csv']).toString(), etak.run(['f0', '--all', '--format', 'csv']).out);
  assert.equal(etak.run(['f0', '--all', '-o', 'out/f0.csv'], {files: {'out/f0.csv': 'x'}, collect: true}).status, 2);
});

comparing('all pages of the public database are equal', {skip: existsSync(data) ? false : `there is no ${data}`}, () => {
  inFolder(folder => {
    execFileSync('tar', ['-xJf', join(data, 'refractiveindex.info-database.tar.xz'), '-C', folder]);
    const rows = sameAnswer(['f0', '.', '--format', 'csv'], filesBelow(folder), {cwd: folder}).out.split('\n').length;
    assert.ok(rows > 3400, `${rows} rows`);
  });
});

// The pictures in a page have the same pixels in other bytes: the module deflates by code of its own.
const less = text => text.replaceAll(/base64,[^"]*/g, '');

comparing('findings of textures and scenes are equal', {skip: existsSync(data) ? false : `there is no ${data}`}, () => {
  const assets = join(data, 'assets'), files = filesBelow(assets);
  const textures = files.filter(([path]) => path.endsWith('.png'));
  assert.ok(textures.length >= 60);
  for (const [path, bytes] of textures) sameAnswer(['validate', path], [[path, bytes]]);
  for (const format of ['json', 'sarif', 'html', 'text']) sameAnswer(['validate', '.', '--format', format], files, {cwd: assets, less});
});

comparing('the demo with its mistakes has equal findings', {skip: existsSync(`${native}-demo-scene`) ? false : 'no etak-demo-scene'}, () => {
  inFolder(folder => {
    execFileSync(`${native}-demo-scene`, [join(folder, 'scene'), join(folder, 'mistakes')]);
    for (const format of ['text', 'json', 'html', 'sarif', 'junit'])
      sameAnswer(['validate', 'mistakes', 'scene', '--format', format], filesBelow(folder), {cwd: folder, less});
  });
});

comparing('broken files of the fuzz corpus are refused in the same words', () => {
  for (const kind of ['png', 'containers', 'gltf', 'pictures', 'blocks']) {
    const folder = join(root, 'tests/fuzz/corpus', kind);
    for (const [path, bytes] of filesBelow(folder))
      for (const end of ['.png', '.dds', '.ktx2', '.gltf']) sameAnswer(['validate', `x${end}`], [[`x${end}`, bytes]]);
  }
});
