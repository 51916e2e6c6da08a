// The npm package under node: errors, saved states, meshes of its user's.   test_package.mjs FOLDER
// Ends with 77 where the package is not there.
import assert from 'node:assert';
import { existsSync } from 'node:fs';

const file = `${process.argv[2]}/taut-cloth/index.js`;
if (!existsSync(file)) {
  console.log(`skipped: ${file} is not there; \`cmake --workflow --preset web\` makes it`);
  process.exit(77);
}
const { load, TautError } = await import(file);
const taut = await load();
assert(taut.scenes.includes('tshirt-walk') && taut.fabrics.includes('silk'));

const cloth = taut.cloth({ scene: 'tshirt-wind-1', settings: { 'garment.file': 'tshirt_1028' } });
const start = cloth.positions(new Float64Array(3 * cloth.info.vertex_count));
assert.equal(cloth.triangles().length, 3 * 1028);
const frame = cloth.step();
assert(frame.is_bound_kept && frame.max_surface_stretch <= 0.01 && frame.measured_crossings === 0);
assert.equal(frame.state_hash, cloth.stateHash);
assert.notDeepEqual(cloth.positions(new Float64Array(start.length)), start);
assert.equal(Math.max(...cloth.stretch()), frame.max_surface_stretch);

const saved = cloth.save();
const next = cloth.step().state_hash;
cloth.restore(saved);
assert.equal(cloth.step().state_hash, next);
cloth.setForces([0], [0, 5, 0]);
cloth.restore(saved);
assert.notEqual(cloth.step().state_hash, next);

assert.throws(() => cloth.set('nothing', 1), (error) => error instanceof TautError && error.result === 3);
assert.throws(() => taut.cloth({ scene: 'nowhere' }), /there is no scene 'nowhere'/);
assert.throws(() => taut.cloth({ positions: [0, 0], triangles: [] }), /without faces/);
assert.throws(() => taut.cloth(), /expected exactly one of scene, text and positions/);

const told = [];
const own = taut.cloth({ positions: [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1], triangles: [0, 2, 1, 1, 2, 3],
  settings: { 'wind.direction': [0, 0, 1] }, log: (line) => told.push(line) });
own.pins = Uint32Array.of(0, 1);
own.movePins([0], [0, 0.01, 0]);
own.step();
assert.deepEqual([...own.pins], [0, 1]);
assert.equal(own.positions(new Float64Array(12))[1], 0.01);
own.close();
assert.throws(() => own.step(), /no such cloth/);
