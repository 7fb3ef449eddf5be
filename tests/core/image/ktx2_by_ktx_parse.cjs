// SPDX-License-Identifier: Apache-2.0
// Prints what the npm package ktx-parse finds in a KTX 2.0 file, one value on each line, for test_containers.cpp.
const { readFileSync } = require('fs');
const { pathToFileURL } = require('url');

// require.resolve() finds the package, because import() ignores NODE_PATH.
import(pathToFileURL(require.resolve('ktx-parse'))).then(({ read }) => {
  const file = read(new Uint8Array(readFileSync(process.argv[2])));
  const block = file.dataFormatDescriptor[0];
  const put = (name, value) => console.log(name + ' ' + value);
  put('format', file.vkFormat);
  put('typeSize', file.typeSize);
  put('size', [file.pixelWidth, file.pixelHeight, file.pixelDepth].join(' '));
  put('layers faces', [file.layerCount, file.faceCount].join(' '));
  put('scheme', file.supercompressionScheme);
  put('blocks', file.dataFormatDescriptor.length);
  put('model primaries transfer flags', [block.colorModel, block.colorPrimaries, block.transferFunction, block.flags].join(' '));
  put('version vendor type', [block.versionNumber, block.vendorId, block.descriptorType].join(' '));
  put('texel block', Array.from(block.texelBlockDimension).join(' '));
  put('planes', Array.from(block.bytesPlane).join(' '));
  for (const s of block.samples)
    put('sample', [s.bitOffset, s.bitLength, s.channelType ?? s.channelID, ...s.samplePosition, s.sampleLower, s.sampleUpper].join(' '));
  for (const key of Object.keys(file.keyValue)) put(key, file.keyValue[key]);
  for (const level of file.levels)
    put('level', [level.levelData.length, level.uncompressedByteLength, level.levelData.reduce((sum, byte) => sum + byte, 0)].join(' '));
}).catch((error) => {
  console.log(error);
  process.exit(1);
});
