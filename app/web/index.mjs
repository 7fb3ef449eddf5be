// SPDX-License-Identifier: Apache-2.0
// The package for npm: etak.mjs with the etak.wasm beside it.
import {start as startWith} from './etak.mjs';

async function bytes() {
  const url = new URL('etak.wasm', import.meta.url);
  if (url.protocol === 'file:') return (await import('node:fs/promises')).readFile(url);
  return (await fetch(url)).arrayBuffer();
}

export const start = (source = bytes()) => startWith(source);
