// SPDX-License-Identifier: Apache-2.0
// node judge.js FILE...: the codes of the errors and warnings that the Khronos validator has for each glTF file, as JSON by
// file; ends with 77 where there is no gltf-validator (NODE_PATH).
const fs = require('fs'), path = require('path');
let validator;
try { validator = require('gltf-validator'); } catch (e) { process.exit(77); }
(async () => {
  const out = {};
  for (const file of process.argv.slice(2)) {
    const beside = uri => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));
    const result = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
        {maxIssues: 0, externalResourceFunction: async uri => new Uint8Array(await beside(uri))});
    out[file] = result.issues.messages.filter(m => m.severity < 2).map(m => `${m.code} ${m.message} ${m.pointer}`);
  }
  console.log(JSON.stringify(out));
})();
