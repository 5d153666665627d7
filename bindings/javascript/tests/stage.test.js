// Stages of plain arrays: what they show, and what they refuse. Numbers are from geometry.
import assert from "node:assert/strict";
import test from "node:test";
import * as mimo from "../src/index.js";
import { needed } from "./support.js";

const { Form, Lamp, LogLevel, Stage, TextureType } = mimo;

const BALL = { forms: [Form.SPHERE], sizes: [0.5, 0, 0], colors: [1, 0, 0, 1], objectType: 5 };
const FLAT = { ambient: [1, 1, 1], diffuse: [0, 0, 0], specular: [0, 0, 0] }; // colours as they are painted
const PLACE = { geomPositions: [0, 0, 0], geomQuaternions: [1, 0, 0, 0] };
const UPRIGHT = [1, 0, 0, 0, 1, 0, 0, 0, 1];
const SIDE = 33;
const MIDDLE = 16 * SIDE + 16;

const above = (more = {}) => ({ position: [0, 0, 3], rotation: UPRIGHT, width: SIDE, height: SIDE, ...more });

/** Runs with a stage of one red ball at the origin. */
function withBall(use, more = {}) {
  const stage = new Stage({ geoms: BALL, air: FLAT, ...more });
  try {
    use(stage);
  } finally {
    stage.close();
  }
}

test("a camera 3 m above a ball of half a metre sees it 2.5 m away, red, as object 0 of type 5", needed, () => {
  withBall((stage) => {
    const { rgba, depth, segmentation, width, height } = stage.draw(PLACE, above({ depth: true, segmentation: true }));
    assert.deepEqual([width, height, rgba.length, depth.length, segmentation.length], [33, 33, 33 * 33 * 4, 33 * 33, 33 * 33 * 2]);
    assert.deepEqual([...rgba.slice(4 * MIDDLE, 4 * MIDDLE + 4)], [255, 0, 0, 255]);
    assert.ok(Math.abs(depth[MIDDLE] - 2.5) < 1e-5, `${depth[MIDDLE]}`);
    assert.deepEqual([...segmentation.slice(2 * MIDDLE, 2 * MIDDLE + 2)], [0, 5]);
    assert.deepEqual([...segmentation.slice(0, 2)], [-1, -1]);
    assert.deepEqual(Object.keys(stage.draw(PLACE, above())), ["width", "height", "rgba"]);
  });
});

test("views show the pose that they name", needed, () => {
  withBall((stage) => {
    const poses = [0, 1].map((z) => ({ ...PLACE, geomPositions: new Float64Array([0, 0, z]) }));
    const views = [1, 0].map((pose) => above({ rgba: false, depth: true, pose }));
    const seen = stage.draw(poses, views).map(({ depth }) => depth[MIDDLE]);
    assert.ok(Math.abs(seen[0] - 1.5) < 1e-5 && Math.abs(seen[1] - 2.5) < 1e-5, `${seen}`);
  });
});

test("an update replaces a part and leaves the others", needed, () => {
  withBall((stage) => {
    stage.update({ geoms: { ...BALL, colors: new Float32Array([0, 1, 0, 1]) } });
    assert.deepEqual([...stage.draw(PLACE, above()).rgba.slice(4 * MIDDLE, 4 * MIDDLE + 3)], [0, 255, 0]);
  });
});

test("a mesh, a texture, a material and a lamp", needed, () => {
  // A square of 2 m at z = 0, its left half black and its right half white, under a lamp that shines straight down.
  const meshes = {
    vertexCounts: [4],
    texcoordCounts: [4],
    triangleCounts: [2],
    vertices: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
    texcoords: [0, 1, 1, 1, 1, 0, 0, 0],
    triangles: [0, 1, 2, 0, 2, 3],
  };
  const stage = new Stage({
    geoms: { forms: [Form.MESH], sizes: [0, 0, 0], colors: [0.5, 0.5, 0.5, 1], materials: [0], data: [0] },
    meshes,
    materials: { colors: [1, 1, 1, 1], textures: [0], specular: [0] },
    textures: { types: [TextureType.FLAT], widths: [2], heights: [1], pixels: Uint8Array.of(0, 0, 0, 255, 255, 255) },
    lights: { types: [Lamp.SUN], diffuse: [1, 1, 1] },
    air: { headlight: false },
  });
  const poses = { ...PLACE, lightPositions: [0, 0, 2], lightDirections: [0, 0, -1] };
  const { rgba } = stage.draw(poses, above({ fovy: 30 }));
  // 33 pixels see 6 m times the tangent of 15 degrees. Between the texture's two pixels, whose middles are half a metre left
  // and right of the middle, brightness grows evenly.
  const metres = (8 * 6 * Math.tan(Math.PI / 12)) / SIDE;
  const [left, right] = [rgba[4 * (MIDDLE - 8)], rgba[4 * (MIDDLE + 8)]];
  assert.ok(Math.abs(left - 255 * (0.5 - metres)) < 1 && Math.abs(right - 255 * (0.5 + metres)) < 1, `${left}, ${right}`);
  stage.close();
});

test("what is wrong with a stage is named", needed, () => {
  const make = (parts) => () => new Stage(parts);
  assert.throws(make({ geoms: { ...BALL, sizes: [1, 0, 0, 1, 0, 0] } }), /RangeError: sizes has 2 elements, expected 1, as forms/);
  assert.throws(make({ geoms: { ...BALL, sizes: [1, 0] } }), /sizes has 2 numbers, expected a multiple of 3/);
  assert.throws(make({ geoms: { ...BALL, forms: [2.5] } }), /forms\[0\] is 2.5, expected a whole number/);
  assert.throws(make({ geoms: { ...BALL, forms: new Float64Array([2.5]) } }), /forms\[0\] is 2.5, expected a whole number/);
  assert.throws(make({ textures: { types: [0], widths: [1], heights: [1], pixels: [0, 0, 300] } }), /pixels\[2\] is 300, .* from 0 to 255/);
  assert.throws(make({ geoms: { ...BALL, colours: [] } }), /there is no option colours; there are .*colors/);
  assert.throws(make({ geoms: { ...BALL, count: 1 } }), /there is no option count/);
  assert.throws(make({ geom: BALL }), /there is no option geom; there are .*geoms/);
  assert.throws(make({ geoms: { ...BALL, materials: [3] } }), { code: "INVALID_ARGUMENT", message: /geoms: materials\[0\] is 3/ });
  withBall((stage) => {
    assert.throws(() => stage.draw({ ...PLACE, geomPositions: [0, 0, NaN] }, above()), { message: /geom_positions\[0, 2\] is nan/ });
    assert.throws(() => stage.draw(PLACE, above({ pose: 1 })), { message: /pose is 1, but there are 1 poses/ });
    assert.throws(() => stage.draw(PLACE, above({ width: 0 })), /width is 0, expected a whole number from 1 to 16384/);
    assert.throws(() => stage.draw(PLACE, above({ rotation: [1, 0, 0] })), /rotation has 3 numbers, expected 9/);
    assert.throws(() => stage.draw(PLACE, { ...above(), position: undefined }), /position is undefined, expected an array/);
    assert.equal(stage.draw(PLACE, above()).rgba[4 * MIDDLE], 255);
  });
});

test("what a stage does not draw is told once", needed, () => {
  const told = [];
  withBall(() => {}, { geoms: { ...BALL, forms: [100] }, log: (record) => told.push(record) });
  assert.deepEqual(
    told.map(({ level, text }) => [level, text]),
    [[LogLevel.WARNING, "geom 0 is not drawn: its form is 100, expected 0 to 8"]],
  );
});

test("a closed stage says so", needed, () => {
  const stage = new Stage();
  stage.close();
  assert.throws(() => stage.draw({}, above()), { code: "BAD_HANDLE", message: "this Stage is closed" });
});
