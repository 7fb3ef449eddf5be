// SPDX-License-Identifier: Apache-2.0
'use strict';
// Textures into the pair of an atlas, as `etak pack` makes it, saved as a ZIP.

const crcTable = Uint32Array.from({length: 256}, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xEDB88320 ^ n >>> 1 : n >>> 1;
  return n;
});
function crcOf(bytes) {
  let out = ~0;
  for (let i = 0; i < bytes.length; ++i) out = crcTable[(out ^ bytes[i]) & 255] ^ out >>> 8;
  return ~out >>> 0;
}

/** A ZIP of files (PKWARE, APPNOTE.TXT 6.3.10): stored, since pictures are compressed, with names in UTF-8 and no times. */
function zipOf(files) {
  const parts = [], ends = [];
  let at = 0;
  const record = (size, values) => {
    const out = new DataView(new ArrayBuffer(size));
    for (const [place, width, value] of values) out[`setUint${width}`](place, value, true);
    return new Uint8Array(out.buffer);
  };
  for (const [path, bytes] of Object.entries(files)) {
    const name = new TextEncoder().encode(path), crc = crcOf(bytes);
    // Version 2.0, names in UTF-8, stored, 1 January 1980.
    const common = first => [[first, 16, 20], [first + 2, 16, 0x800], [first + 8, 16, 0x21], [first + 10, 32, crc], [first + 14, 32, bytes.length],
      [first + 18, 32, bytes.length], [first + 22, 16, name.length]];
    parts.push(record(30, [[0, 32, 0x04034B50], ...common(4)]), name, bytes);
    ends.push(record(46, [[0, 32, 0x02014B50], [4, 16, 20], ...common(6), [42, 32, at]]), name);
    at += 30 + name.length + bytes.length;
  }
  const size = ends.reduce((sum, part) => sum + part.length, 0), count = ends.length / 2;
  return new Blob([...parts, ...ends, record(22, [[0, 32, 0x06054B50], [8, 16, count], [10, 16, count], [12, 32, size], [16, 32, at]])], {type: 'application/zip'});
}

/** A button that packs what was dropped; `told` is where it says what came of it. */
function packer(names, content) {
  const told = el('div', {});
  const button = el('button', {type: 'button', id: 'pack', click: async () => {
    button.disabled = true;
    told.replaceChildren(el('p', {class: 'soft'}, 'Packing ...'));
    // Pictures that were dropped without a folder get one.
    const plain = names.length > 1 || names[0] in content, folder = plain ? 'textures' : names[0];
    const files = plain ? Object.fromEntries(Object.entries(content).map(([path, bytes]) => [`textures/${path}`, bytes])) : content;
    const answer = await engine.run(['pack', '-o', 'atlas', '--fail-on', 'never', '--', folder], {files, collect: true});
    const made = Object.fromEntries(Object.entries(answer.files).filter(([path]) => path.startsWith('atlas/')));
    const lines = messages(answer.err).map(line => el('p', {class: answer.status ? 'problem' : 'soft'}, line));
    const count = Object.keys(made).length;
    if (count) save('etak-atlas.zip', zipOf(made), 'application/zip');
    told.replaceChildren(...lines, count ? el('p', {id: 'packed'}, `etak-atlas.zip has ${count} files (${fixed(answer.ms, 0)} ms).`)
      : el('p', {id: 'packed'}, 'Nothing was packed.'), answer.out.trim() ? el('pre', {class: 'values', tabindex: 0, 'aria-label': 'What packing saves',
        click: () => copy(answer.out, 'what packing saves')}, answer.out) : '');
    button.disabled = false;
  }}, 'Pack into an atlas');
  return [button, told];
}
