// SPDX-License-Identifier: Apache-2.0
// node join.mjs PAGE BUILD: joins what needs nothing beside it and opens from a disk.
//   PAGE    the folder of page.html, of which BUILD/etak.html is made, and of element.js, of which BUILD/etak-element.js is
//   BUILD   the folder of etak.wasm and unpack.wasm
// In the page are replaced
//   <link rel="stylesheet" href="F">           by <style> with the text of F
//   <script src="F G"></script>                by <script> with the texts of F and G; all kinds of scripts, with their attributes
//   <script type="text/plain" id="..." src="F"></script>   the same; a text for the scripts: not run
//   an F that ends in .mjs                     by its text without imports and exports: its neighbours have the same scope
//   an F that ends in .wasm                    by its bytes as a text of seven bits a character, which worker.mjs decodes
//   an F that ends in .wasm.lzma               by those of .wasm, packed by xz, in the same form
//   {{shaders}}                                by the texts of the shaders of a metal and of a clear body, as the module says them
//   {{styles}} and {{scripts}}                 by the hashes of what is in the page, for its Content-Security-Policy
// etak-element.js is element.js with what it imports and the module, as a classic script.
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {start} from './etak.mjs';
import {ballWords, nearestModel} from './page/drawing.mjs';

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
  if (name.endsWith('.wasm.lzma')) return lettered(packed(readFileSync(place(name.replace(/\.lzma$/, '')))));
  if (name.endsWith('.wasm')) return lettered(readFileSync(place(name)));
  const text = readFileSync(place(name), 'utf8').replaceAll('</script', '<\\/script');
  return name.endsWith('.css') || name.endsWith('.html') ? text : text.replace(/^import .*\n|^export (?=async |function |const |class )/gm, '');
}

// xz does not know the size of what it reads from a pipe; it belongs into the head.
function packed(bytes) {
  const out = execFileSync('xz', ['--format=lzma', '-9e', '-c'], {input: bytes, maxBuffer: 1 << 30});
  out.writeBigUInt64LE(BigInt(bytes.length), 5);
  return out;
}

// The size and the bytes, seven bits a character, which is a seventh more than the bytes; base64 is a third more. What a script of HTML or a
// text of JavaScript cannot hold as it is, is one letter above 255 together with the seven bits that follow.
function lettered(bytes) {
  const apart = [0, 10, 13, 34, 60, 92], sevens = [], size = Buffer.alloc(4);
  let bits = 0, count = 0, out = '';
  size.writeUInt32LE(bytes.length);
  for (const byte of Buffer.concat([size, bytes, Buffer.alloc(1)])) {
    bits = bits << 8 | byte;
    for (count += 8; count >= 7; bits &= (1 << count) - 1) sevens.push(bits >> (count -= 7));
  }
  for (let i = 0; i < sevens.length; ++i) {
    const at = apart.indexOf(sevens[i]);
    out += String.fromCharCode(at < 0 ? sevens[i] : 256 + (at << 7 | (sevens[++i] ?? 0)));
  }
  return out;
}

const hashOf = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

const etak = await start(readFileSync(place('etak.wasm')));
function shaderOf(subject, kind) {
  const {vertex, fragment} = JSON.parse(etak.run([...ballWords(subject, nearestModel(kind), 32), '--format', 'json', '-q']).out);
  return {vertex, fragment, uniforms: []};
}

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
  html = html.replace('{{shaders}}', () => JSON.stringify([shaderOf('gold', 'metal'), shaderOf('water', 'liquid')]));
  for (const kind of Object.keys(hashes)) html = html.replaceAll(`{{${kind}}}`, () => hashes[kind].join(' '));
  return html;
}

function element() {
  const carried = {packed: textOf('etak.wasm.lzma'), unpacker: textOf('unpack.wasm'), worker: textOf('etak.mjs') + textOf('worker.mjs')};
  const scripts = ['program.mjs', 'drawing.mjs', 'element.js'].map(textOf).join('').replaceAll('import.meta.url', 'document.currentScript.src');
  // In ASCII, since a script is read in the encoding of its page.
  const ascii = text => text.replace(/[^\x00-\x7f]/g, letter => `\\u${letter.charCodeAt(0).toString(16).padStart(4, '0')}`);
  const entries = Object.entries(carried).map(([name, text]) => `${name}: ${name === 'worker' ? JSON.stringify(text) : `"${ascii(text)}"`}`);
  return `(() => {\n'use strict';\nconst carried = {${entries.join(', ')}};\n${scripts}})();\n`;
}

for (const [name, text] of [['etak.html', page()], ['etak-element.js', element()]]) {
  writeFileSync(join(build, name), text);
  console.error(`join: ${name} has ${text.length} characters`);
}
