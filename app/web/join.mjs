// SPDX-License-Identifier: Apache-2.0
// node join.mjs PAGE BUILD: joins what needs nothing beside it and opens from a disk.
//   PAGE    the folder of page.html, of which BUILD/etak.html is made, and of element.js, of which BUILD/etak-element.js is
//   BUILD   the folder of etak.wasm and unpack.wasm
// In the page are replaced
//   <link rel="stylesheet" href="F">           by <style> with the text of F
//   <script src="F G"></script>                by <script> with the texts of F and G; all kinds of scripts, with their attributes
//   <script type="text/plain" id="..." src="F"></script>   the same; a text for the scripts: not run
//   an F that ends in .mjs                     by its text without imports and exports: its neighbours have the same scope
//   an F that ends in .wasm                    by its bytes, in base64
//   an F that ends in .wasm.lzma               by those of .wasm, packed by xz, in base64
//   {{styles}} and {{scripts}}                 by the hashes of what is in the page, for its Content-Security-Policy
// etak-element.js is element.js with what it imports and the module, as a classic script.
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const [pages, build] = process.argv.slice(2);
const place = name => [pages, join(pages, '..'), build].map(folder => join(folder, name)).find(existsSync)
  ?? (() => { throw new Error(`${name} is neither in ${pages}, above it, nor in ${build}`); })();

const texts = new Map();
function textOf(name) {
  if (!texts.has(name)) texts.set(name, read(name));
  return texts.get(name);
}

// A script ends at the first "</script", also within a text of JavaScript, where "<\/script" is the same.
function read(name) {
  if (name.endsWith('.wasm.lzma')) return packed(readFileSync(place(name.replace(/\.lzma$/, '')))).toString('base64');
  if (name.endsWith('.wasm')) return readFileSync(place(name)).toString('base64');
  const text = readFileSync(place(name), 'utf8').replaceAll('</script', '<\\/script');
  return name.endsWith('.css') || name.endsWith('.html') ? text : text.replace(/^import .*\n|^export (?=async |function |const |class )/gm, '');
}

// xz does not know the size of what it reads from a pipe; it belongs into the head.
function packed(bytes) {
  const out = execFileSync('xz', ['--format=lzma', '-9e', '-c'], {input: bytes, maxBuffer: 1 << 30});
  out.writeBigUInt64LE(BigInt(bytes.length), 5);
  return out;
}

const hashOf = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

function page() {
  const hashes = {styles: [], scripts: []};
  let html = readFileSync(place('page.html'), 'utf8');
  html = html.replace(/<link rel="stylesheet" href="([^"]+)">/g, (_, name) => {
    const text = textOf(name);
    hashes.styles.push(hashOf(text));
    return `<style>${text}</style>`;
  });
  html = html.replace(/<script([^>]*?) src="([^"]+)"([^>]*)><\/script>/g, (_, before, names, behind) => {
    const text = names.split(' ').map(textOf).join(''), attributes = before + behind;
    if (!/type="text\/plain"/.test(attributes)) hashes.scripts.push(hashOf(text));
    return `<script${attributes}>${text}</script>`;
  });
  for (const kind of Object.keys(hashes)) html = html.replaceAll(`{{${kind}}}`, () => hashes[kind].join(' '));
  return html;
}

function element() {
  const carried = {packed: textOf('etak.wasm.lzma'), unpacker: textOf('unpack.wasm'), worker: textOf('etak.mjs') + textOf('worker.mjs')};
  const scripts = ['program.mjs', 'drawing.mjs', 'element.js'].map(textOf).join('').replaceAll('import.meta.url', 'document.currentScript.src');
  return `(() => {\n'use strict';\nconst carried = ${JSON.stringify(carried)};\n${scripts}})();\n`;
}

for (const [name, text] of [['etak.html', page()], ['etak-element.js', element()]]) {
  writeFileSync(join(build, name), text);
  console.error(`join: ${name} has ${text.length} characters`);
}
