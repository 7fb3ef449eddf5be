// SPDX-License-Identifier: Apache-2.0
// The program `etak` in a worker. Its first message is {source}: a compiled module, the address of etak.wasm, or {packed, unpacker}, the
// same by LZMA and the module that unpacks it, both in base64. It answers with {module, times}, and then a run {id, words, options}
// with {id, answer} or {id, fault}.
import {start} from './etak.mjs';

function decoded(base64) {
  const text = atob(base64.trim()), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);  // ten times as fast as Uint8Array.from()
  return bytes;
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
