// validate_gltf.js FOLDER-OF-gltf-validator FOLDER: Khronos' validator finds nothing in FOLDER/clip.glb.
const validator = require(process.argv[2]);
const bytes = require('fs').readFileSync(process.argv[3] + '/clip.glb');
validator.validateBytes(new Uint8Array(bytes), {maxIssues: 20}).then((report) => {
  const issues = report.issues;
  console.log(JSON.stringify(issues, null, 1));
  process.exit(issues.messages.length === 0 ? 0 : 1);
});
