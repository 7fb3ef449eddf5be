// SPDX-License-Identifier: Apache-2.0
// What the tests of the module share: the module, the native program, and what both answer to the same line.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, relative} from 'node:path';
import test from 'node:test';
import {fileURLToPath} from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const build = process.env.ETAK_WEB ?? join(root, 'build/web');
export const native = process.env.ETAK ?? join(root, 'build/release/bin/etak');
export const data = join(root, '../shared/data');

const {start} = await import(join(build, 'etak.mjs'));
export const wasm = readFileSync(join(build, 'etak.wasm'));
export const module = await WebAssembly.compile(wasm);
export const fresh = () => start(module);
export const etak = await fresh();

/** All files below a folder, by their paths from it. */
export function filesBelow(folder, from = folder) {
  return readdirSync(folder, {withFileTypes: true}).flatMap(entry => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesBelow(path, from) : [[relative(from, path), readFileSync(path)]];
  });
}

/** Does work(folder) in a folder of its own, which ends with it. */
export function inFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'etak-web-'));
  try {
    return work(folder);
  } finally {
    rmSync(folder, {recursive: true});
  }
}

export function write(folder, files) {
  for (const [path, content] of files) {
    mkdirSync(dirname(join(folder, path)), {recursive: true});
    writeFileSync(join(folder, path), content);
  }
}

// Without the pictures module beside it, as the module for the web has none.
const bare = mkdtempSync(join(tmpdir(), 'etak-bare-'));
process.on('exit', () => rmSync(bare, {recursive: true}));
const program = join(bare, 'etak');
writeFileSync(program, readFileSync(native), {mode: 0o755});

// What app/web/pictures.cpp says in place of the native program, which names the file that it lacks.
const inBrowser = 'needs OpenImageIO, OpenColorIO or another library that etak does not have in a browser; ' +
  'expected PNG, DDS, KTX2 without Zstandard and built-in spaces, or etak as a program';

/** What the native program answers; its own folder is said to be the root, as that of the module is. */
export function nativeRun(words, {cwd = bare, stdin = ''} = {}) {
  const got = spawnSync(program, words, {cwd, input: stdin, maxBuffer: 1 << 30, env: {PATH: process.env.PATH}});
  const [out, err] = [got.stdout, got.stderr].map(bytes => bytes.toString().replaceAll(bare, '')
    .replaceAll(/needs libetak-pictures\.so; .*? and memory for them/g, inBrowser));
  return {status: got.status, outBytes: Buffer.from(out), out, err};
}

const failures = [];

/** A test of which every sameAnswer() is done before it fails. */
export function comparing(name, options, work = options) {
  test(name, work === options ? {} : options, () => {
    failures.length = 0;
    work();
    assert.equal(failures.length, 0, `${failures.length} lines differ:\n${failures.slice(0, 12).join('\n')}`);
  });
}

/** The same line is answered with the same bytes and status by both, else the test fails; files are [path, bytes].
 *  `less` leaves out what need not be equal. */
export function sameAnswer(words, files = [], {cwd, stdin, less = text => text} = {}) {
  const here = etak.run(words, {files: new Map(files), stdin});
  const there = cwd !== undefined || files.length === 0
    ? nativeRun(words, {cwd, stdin})
    : inFolder(folder => (write(folder, files), nativeRun(words, {cwd: folder, stdin})));
  const line = `etak ${words.join(' ')}`;
  if (here.status !== there.status) failures.push(`${line}: status ${here.status} in place of ${there.status}`);
  if (here.err !== there.err) failures.push(`${line}: standard error: ${firstDifference(here.err, there.err)}`);
  if (Buffer.compare(here.outBytes, there.outBytes) !== 0 && less(here.out) !== less(there.out))
    failures.push(`${line}: ${firstDifference(here.out, there.out)}`);
  return here;
}

function firstDifference(a, b) {
  const here = a.split('\n'), there = b.split('\n');
  const line = here.findIndex((text, i) => text !== there[i]);
  const [mine, other] = [here[line] ?? '', there[line] ?? ''];
  const at = [...mine].findIndex((letter, i) => letter !== other[i]), from = Math.max(0, at - 80);
  const differing = here.filter((text, i) => text !== there[i]).length;
  return `${differing} of ${here.length} lines differ; line ${line + 1} from letter ${from + 1} on is
  ${mine.slice(from, from + 160)}\nin place of\n  ${other.slice(from, from + 160)}`;
}

/** The median time of `count` calls in milliseconds. */
export function medianTime(count, work) {
  const times = Array.from({length: count}, (_, i) => {
    const begin = performance.now();
    work(i);
    return performance.now() - begin;
  });
  return times.sort((a, b) => a - b)[count >> 1];
}
