// Pictures without a simulation: a snowman on a chequered floor, drawn from plain arrays: node camera_only.mjs
import { Form, Lamp, load, Stage, TextureType } from "libmimo";

await load();
const stage = new Stage({
  geoms: {
    forms: [Form.PLANE, Form.SPHERE, Form.SPHERE, Form.SPHERE, Form.CAPSULE],
    sizes: [0, 0, 0, 0.5, 0, 0, 0.35, 0, 0, 0.22, 0, 0, 0.04, 0.1, 0],
    colors: [0.5, 0.5, 0.5, 1, 0.9, 0.9, 1, 1, 0.9, 0.9, 1, 1, 0.9, 0.9, 1, 1, 1, 0.5, 0.1, 1],
    materials: [0, -1, -1, -1, -1],
  },
  materials: { colors: [1, 1, 1, 1], textures: [0], repeats: [1, 1], uniform: [1] }, // one repeat a metre
  textures: { types: [TextureType.FLAT], widths: [2], heights: [2], pixels: [60, 90, 60, 200, 220, 200, 200, 220, 200, 60, 90, 60] },
  lights: { types: [Lamp.SUN] },
});

const quarter = Math.SQRT1_2; // the nose, along its own z, points to -y
const poses = {
  geomPositions: [0, 0, 0, 0, 0, 0.45, 0, 0, 1.1, 0, 0, 1.55, 0, -0.25, 1.55],
  geomQuaternions: [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, quarter, quarter, 0, 0],
  lightPositions: [0, 0, 5],
  lightDirections: [0.48, 0.6, -0.64],
};
// 4 m before it, looking along y: right is x, up is z, backward is -y.
const view = { position: [0, -4, 1], rotation: [1, 0, 0, 0, 0, -1, 0, 1, 0], depth: true, segmentation: true };
const { width, height, rgba, depth, segmentation } = stage.draw(poses, view);
stage.close();

const middle = (height / 2) * width + width / 2;
const names = ["the floor", "the belly", "the chest", "the head", "the nose"];
console.log(`${rgba.length / 4} pixels; in the middle, ${depth[middle].toFixed(2)} m away: ${names[segmentation[2 * middle]]}`);
