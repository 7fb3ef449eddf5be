// SPDX-License-Identifier: Apache-2.0
// node run_wgsl.cjs FILE: compiles the WGSL texts of FILE by Dawn, the WebGPU of Chromium (npm: webgpu), and evaluates
// etak_brdf for each of their directions. FILE: {"texts": [...], "directions": [[lx, ly, lz, vx, vy, vz], ...]}.
// Prints "MESSAGE" lines of the compiler, then a line of numbers for each text. Exits with 77 without an adapter.
const { readFileSync } = require('fs');
const { create, globals } = require('webgpu');
Object.assign(globalThis, globals);

const main = (count) => `
@group(0) @binding(0) var<storage, read> given: array<f32>;
@group(0) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) place: vec3u) {
  let i = place.x;
  if (i >= ${count}u) { return; }
  let at = 6u * i;
  let value = etak_brdf(vec3f(given[at], given[at + 1u], given[at + 2u]), vec3f(given[at + 3u], given[at + 4u], given[at + 5u]));
  found[3u * i] = value.x;
  found[3u * i + 1u] = value.y;
  found[3u * i + 2u] = value.z;
}`;

async function run() {
  const gpu = create(['backend=opengles']);
  const adapter = await gpu.requestAdapter({ featureLevel: 'compatibility' });
  if (!adapter) process.exit(77);
  const device = await adapter.requestDevice();
  const { texts, directions } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
  const count = directions.length;
  const buffer = (size, usage) => device.createBuffer({ size, usage });
  const given = buffer(24 * count, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
  device.queue.writeBuffer(given, 0, new Float32Array(directions.flat()));
  for (const [number, text] of texts.entries()) {
    const module = device.createShaderModule({ code: text + main(count) });
    for (const each of (await module.getCompilationInfo()).messages)
      console.log(`MESSAGE text ${number}, line ${each.lineNum}: ${each.message}`);
    const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module, entryPoint: 'main' } });
    const found = buffer(12 * count, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
    const read = buffer(12 * count, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({
      layout: pipeline.getBindGroupLayout(0),
      entries: [{ binding: 0, resource: { buffer: given } }, { binding: 1, resource: { buffer: found } }],
    }));
    pass.dispatchWorkgroups(Math.ceil(count / 64));
    pass.end();
    encoder.copyBufferToBuffer(found, 0, read, 0, 12 * count);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    console.log(Array.from(new Float32Array(read.getMappedRange())).join(' '));
    read.destroy();
    found.destroy();
  }
  process.exit(0);
}
run();
