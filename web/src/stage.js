/** The scene in 3-D: the world's geoms with their textures, lights on the skin where it is touched, and a hand that pulls. */
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Axes, convertPoints, Kind, Receptor, TextureType } from "../../bindings/javascript/src/index.js";

const FLOOR = 5; // half the size of endless planes, m
const SEGMENTS = 16; // of a circle
const FACES = 6;
const MARGIN = 8; // share of a cube's face that is repeated around it, so that small mipmaps show no seams
const ABOVE = 0.004; // m above the skin, so that the lights are not half inside
const [WEAK, STRONG] = [0.02, 10]; // N, of the weakest and the strongest light

export class Stage {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0xdfe6ee);
    this.camera = new THREE.PerspectiveCamera(42, 1, 0.02, 60);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxDistance = 8;
    const lamp = new THREE.DirectionalLight(0xffffff, 2.3);
    lamp.position.set(-0.6, 2, 1);
    this.scene.add(new THREE.AmbientLight(0xffffff, 1.5), lamp);
    this.bodies = [];
    this.textures = new Map();
    this.root = new THREE.Group();
    this.line = new THREE.Line(
      new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(new Float32Array(6), 3)),
      new THREE.LineBasicMaterial({ color: 0xd7191e }),
    );
    this.line.frustumCulled = false;
    this.line.visible = false;
    this.scene.add(this.root, this.line);
    this.#prepare();
  }

  /** Has the graphics card translate what will draw, while the module is still loading. */
  #prepare() {
    const [skin, map] = [lights(), new THREE.DataTexture(new Uint8Array(4), 1, 1)];
    map.colorSpace = THREE.SRGBColorSpace;
    const kinds = [surface(null, 1), surface(map, 1)].map((material) => new THREE.Mesh(new THREE.BufferGeometry(), material));
    this.kept = new THREE.Group().add(...kinds, new THREE.Points(new THREE.BufferGeometry(), skin), this.line.clone());
    this.renderer.compile(this.kept, this.camera, this.scene);
  }

  /** Draws another world, or the same one with other bodies. @param {any} world */
  show(world, keepView = false) {
    this.clear();
    this.world = world;
    this.poses = new Float32Array(7 * world.count(Kind.BODY));
    world.poses(Kind.BODY, Axes.GLTF, this.poses);
    this.bodies = Array.from({ length: this.poses.length / 7 }, () => new THREE.Group());
    this.root.add(...this.bodies);
    this.move();
    const geoms = world.poses(Kind.GEOM, Axes.GLTF);
    for (let geom = 0; geom < geoms.length / 7; geom++) this.#add(geom, geoms.subarray(7 * geom, 7 * geom + 7));
    this.#addSkin();
    if (!keepView) this.#look();
  }

  clear() {
    this.root.traverse((node) => {
      node.geometry?.dispose();
      node.material?.dispose();
    });
    this.root.clear();
    for (const { made } of this.textures.values()) made.dispose();
    this.textures.clear();
    this.skin = [];
  }

  #add(geom, pose) {
    const { world } = this;
    const look = world.appearance(geom);
    if (!look.visible) return;
    const body = world.bodyOf(Kind.GEOM, geom);
    const { positions, normals, texcoords, indices } = world.mesh(geom, { axes: Axes.GLTF, plane: FLOOR, segments: SEGMENTS });
    const texture = this.#texture(look.texture);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    if (texture) geometry.setAttribute("uv", new THREE.BufferAttribute(places(texture.given, texcoords), 2));
    geometry.setIndex(new THREE.BufferAttribute(indices, 1));
    const material = surface(texture?.made ?? null, look.color[3]);
    const bright = look.color.slice(0, 3).map((one) => one * (1.2 + look.emission));
    material.color.setRGB(...bright.map((one) => one / Math.max(1, ...bright)), THREE.SRGBColorSpace);
    const mesh = new THREE.Mesh(geometry, material);
    mesh.userData = { body, geom };
    this.bodies[body].attach(placed(mesh, pose));
    this.bodies[body].updateMatrixWorld();
  }

  /** A texture of the world, which is made once for all geoms that have it. */
  #texture(number) {
    if (number < 0) return null;
    if (!this.textures.has(number)) {
      const given = this.world.texture(number);
      this.textures.set(number, { given, made: picture(given) });
    }
    return this.textures.get(number);
  }

  /** Another face is another texture of the head. */
  renewFace() {
    this.root.traverse((node) => {
      if (node.userData.geom === undefined) return;
      const made = this.#texture(this.world.appearance(node.userData.geom).texture)?.made;
      if (made) node.material.map = made;
    });
  }

  /** Points on the skin of all infants, dark until they are touched. */
  #addSkin() {
    const { layout } = this.world;
    for (const { name, shape } of layout.fields.filter(({ name }) => name.endsWith("touch/force"))) {
      const owners = layout.receptors(name, Receptor.BODY);
      const normals = layout.receptors(name, Receptor.FRAME); // three directions each, the normal first
      const outside = layout.receptors(name, Receptor.POSITION).map((one, i) => one + ABOVE * normals[9 * Math.floor(i / 3) + (i % 3)]);
      const at = convertPoints(outside, Axes.GLTF);
      for (const body of new Set(owners)) {
        const members = Array.from(owners.keys()).filter((one) => owners[one] === body);
        const geometry = new THREE.BufferGeometry();
        const places = Float32Array.from(members.flatMap((one) => [...at.subarray(3 * one, 3 * one + 3)]));
        geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
        geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(4 * members.length), 4));
        const points = new THREE.Points(geometry, lights());
        points.renderOrder = 1;
        this.bodies[body].add(points);
        this.skin.push({ field: name, width: shape[1], first: members[0], count: members.length, points, lit: false });
      }
    }
  }

  /** Lets the skin light up where forces act on it. */
  touch() {
    const seen = this.world.observation;
    for (const part of this.skin) {
      const forces = seen[part.field];
      const color = part.points.geometry.attributes.color;
      let lit = false;
      for (let i = 0; i < part.count; i++) {
        const force = sizeOf(forces, part.width, part.first + i);
        const share = force <= WEAK ? 0 : Math.min(1, Math.log(force / WEAK) / Math.log(STRONG / WEAK));
        lit ||= share > 0;
        color.setXYZW(i, 1, 0.85 * (1 - share), 0.2 * (1 - share), share > 0 ? 0.45 + 0.55 * share : 0);
      }
      if (lit || part.lit) color.needsUpdate = true;
      part.points.visible = part.lit = lit;
    }
  }

  /** Takes the bodies' poses. */
  move() {
    this.world.poses(Kind.BODY, Axes.GLTF, this.poses);
    for (let i = 0; i < this.bodies.length; i++) placed(this.bodies[i], this.poses.subarray(7 * i, 7 * i + 7));
    this.root.updateMatrixWorld();
  }

  #look() {
    const box = new THREE.Box3();
    for (const group of this.bodies.slice(1)) for (const part of group.children) if (part.isMesh) box.expandByObject(part);
    const middle = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
    const size = box.isEmpty() ? 1 : Math.min(box.getSize(new THREE.Vector3()).length(), 1.6);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(new THREE.Vector3(0.75, 0.45, 1).multiplyScalar(size * 1.05));
    this.controls.update();
  }

  /** What lies under a place of the canvas: a body and the point, or null. */
  pick(x, y) {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    this.ray ??= new THREE.Raycaster();
    this.ray.setFromCamera(new THREE.Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height), this.camera);
    const hit = this.ray.intersectObject(this.root, true).find(({ object }) => object.isMesh);
    return hit && hit.object.userData.body !== 0 ? { body: hit.object.userData.body, point: hit.point } : null;
  }

  /** The point under a place of the canvas, as far away as another one. */
  beside(x, y, point) {
    this.pick(x, y);
    const facing = this.camera.getWorldDirection(new THREE.Vector3());
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(facing, point);
    return this.ray.ray.intersectPlane(plane, new THREE.Vector3());
  }

  draw() {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = this.renderer.getPixelRatio();
    if (this.canvas.width !== Math.floor(clientWidth * ratio) || this.canvas.height !== Math.floor(clientHeight * ratio)) {
      this.renderer.setSize(clientWidth, clientHeight, false);
      this.camera.aspect = clientWidth / clientHeight;
      this.camera.updateProjectionMatrix();
    }
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
  }
}

const surface = (map, opacity) => new THREE.MeshLambertMaterial({ map, transparent: opacity < 1, opacity });
const lights = () => new THREE.PointsMaterial({ size: 0.016, vertexColors: true, transparent: true, depthWrite: false });

/** A node at a pose of glTF: position, and a quaternion x y z w. */
function placed(node, [x, y, z, a, b, c, d]) {
  node.position.set(x, y, z);
  node.quaternion.set(a, b, c, d);
  return node;
}

const isCube = ({ type, width, height }) => type === TextureType.CUBE && height === FACES * width;

/** A texture as a picture; a cube's faces, which lie above one another, get margins that repeat their borders. */
function picture(texture) {
  const { width, height, pixels } = texture;
  const margin = isCube(texture) ? Math.floor(width / MARGIN) : 0;
  const [wide, faces, tall] = [width + 2 * margin, margin ? FACES : 1, margin ? width : height];
  const high = faces * (tall + 2 * margin);
  const all = new Uint32Array(wide * high);
  const from = new Uint32Array(pixels.buffer, pixels.byteOffset, width * height);
  for (let y = 0; y < high; y++) {
    const face = Math.floor(y / (tall + 2 * margin));
    const row = face * tall + clamped((y % (tall + 2 * margin)) - margin, tall);
    for (let x = 0; x < wide; x++) all[y * wide + x] = from[row * width + clamped(x - margin, width)];
  }
  const made = new THREE.DataTexture(new Uint8Array(all.buffer), wide, high);
  made.colorSpace = THREE.SRGBColorSpace;
  made.wrapS = made.wrapT = margin ? THREE.ClampToEdgeWrapping : THREE.RepeatWrapping;
  made.magFilter = THREE.LinearFilter;
  made.minFilter = THREE.LinearMipmapLinearFilter;
  made.generateMipmaps = true;
  made.anisotropy = 4;
  made.needsUpdate = true;
  return made;
}

/** Texture coordinates in that picture. */
function places(texture, texcoords) {
  if (!isCube(texture)) return texcoords;
  const edge = texture.width;
  const margin = Math.floor(edge / MARGIN);
  const inside = (share) => (margin + share * edge) / (edge + 2 * margin);
  const found = new Float32Array(texcoords.length);
  for (let i = 0; i < found.length; i += 2) {
    const down = texcoords[i + 1] * FACES;
    const face = clamped(Math.floor(down), FACES);
    found[i] = inside(texcoords[i]);
    found[i + 1] = (face + inside(down - face)) / FACES;
  }
  return found;
}

const clamped = (value, count) => Math.max(0, Math.min(count - 1, value));

/** The size of a sensor's force, which has one number or three. */
export function sizeOf(forces, width, sensor) {
  const at = width * sensor;
  return width === 1 ? forces[at] : Math.hypot(forces[at], forces[at + 1], forces[at + 2]);
}

/** A point of glTF's frame in the library's: x forward, z up. @param {{x: number, y: number, z: number}} point */
export const toWorld = ({ x, y, z }) => [z, x, y];
