// SPDX-License-Identifier: Apache-2.0
// node join.mjs PAGE BUILD OUT: joins the page with its styles, scripts and the module to one file, which needs nothing
// beside it and opens from a disk.
//   PAGE    page.html, beside which its other files are
//   BUILD   the folder of etak.wasm and etak.mjs
//   OUT     the file to write
// In the page are replaced
//   <link rel="stylesheet" href="F">           by <style> with the text of F
//   <script src="F"></script>                  by <script> with the text of F; all kinds of scripts, with their attributes
//   <script type="text/plain" id="..." src="F"></script>   the same; a text for the scripts: not run
//   an F that ends in .wasm                    by its bytes, in base64
//   an F that ends in .wasm.lzma               by those of .wasm, packed by xz, in base64
//   {{styles}} and {{scripts}}                 by the hashes of what is in the page, for its Content-Security-Policy
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';

const [page, build, out] = process.argv.slice(2);
const place = name => [dirname(page), build].map(folder => join(folder, name)).find(existsSync)
  ?? (() => { throw new Error(`${page}: names ${name}, which is neither beside it nor in ${build}`); })();

// A script ends at the first "</script", also within a text of JavaScript, where "<\/script" is the same.
function textOf(name) {
  if (name.endsWith('.wasm.lzma')) return packed(readFileSync(place(name.replace(/\.lzma$/, '')))).toString('base64');
  if (name.endsWith('.wasm')) return readFileSync(place(name)).toString('base64');
  return readFileSync(place(name), 'utf8').replaceAll('</script', '<\\/script');
}

// xz does not know the size of what it reads from a pipe; it belongs into the head.
function packed(bytes) {
  const out = execFileSync('xz', ['--format=lzma', '-9e', '-c'], {input: bytes, maxBuffer: 1 << 30});
  out.writeBigUInt64LE(BigInt(bytes.length), 5);
  return out;
}

const hashOf = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

const hashes = {styles: [], scripts: []};
let html = readFileSync(page, 'utf8');
html = html.replace(/<link rel="stylesheet" href="([^"]+)">/g, (_, name) => {
  const text = textOf(name);
  hashes.styles.push(hashOf(text));
  return `<style>${text}</style>`;
});
html = html.replace(/<script([^>]*?) src="([^"]+)"([^>]*)><\/script>/g, (_, before, name, behind) => {
  const text = textOf(name), attributes = before + behind;
  if (!/type="text\/plain"/.test(attributes)) hashes.scripts.push(hashOf(text));
  return `<script${attributes}>${text}</script>`;
});
for (const kind of Object.keys(hashes)) html = html.replaceAll(`{{${kind}}}`, () => hashes[kind].join(' '));
writeFileSync(out, html);
console.error(`join: ${out} has ${html.length} characters`);
