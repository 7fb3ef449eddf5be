// SPDX-License-Identifier: Apache-2.0
// The program `etak` in a worker. Its first message is {source}: a compiled module, the address of etak.wasm, or {packed, unpacker}, the
// same by LZMA and the module that unpacks it, both as texts of join.mjs. It answers with {module, times}, and then a run {id, words, options}
// with {id, answer} or {id, fault}.
import {start} from './etak.mjs';

/** The bytes of a text of join.mjs: seven bits a character, or fourteen in one above 255, of which the first seven are one of `apart`. */
function decoded(text) {
  const apart = [0, 10, 13, 34, 60, 92], bytes = new Uint8Array(text.length * 2);
  let bits = 0, count = 0, size = 0;
  const take = seven => {
    bits = bits << 7 | seven;
    count += 7;
    if (count < 8) return;
    count -= 8;
    bytes[size++] = bits >> count;
    bits &= (1 << count) - 1;
  };
  for (let i = 0; i < text.length; ++i) {
    const letter = text.charCodeAt(i);
    if (letter < 128) take(letter);
    else { take(apart[letter - 256 >> 7]); take(letter & 127); }
  }
  return bytes.slice(4, 4 + new DataView(bytes.buffer).getUint32(0, true));
}

async function unpacked({packed, unpacker}) {
  const {instance: {exports: door}} = await WebAssembly.instantiate(decoded(unpacker));
  const bytes = decoded(packed), size = new DataView(bytes.buffer).getUint32(5, true);
  const from = door.room(bytes.length), to = door.room(size);
  new Uint8Array(door.memory.buffer).set(bytes, from);
  door.unpack(from, to, size);
  return new Uint8Array(door.memory.buffer, to, size);
}

async function fetched(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

let etak;
onmessage = async ({data: {source, id, words, options}}) => {
  const begun = performance.now();
  try {
    if (source) {
      const bytes = typeof source === 'string' ? await fetched(source) : source.packed ? await unpacked(source) : null;
      const unpack = performance.now() - begun, module = bytes ? await WebAssembly.compile(bytes) : source;
      etak = await start(module);
      postMessage({module, times: {unpack, start: performance.now() - begun - unpack}});
    } else {
      postMessage({id, answer: {...etak.run(words, options), ms: performance.now() - begun}});
    }
  } catch (error) {
    postMessage({id, fault: String(error && error.message || error)});
  }
};
