/** What the infant senses, drawn beside the scene. */
import { Kind, Quantity, Receptor } from "../../bindings/javascript/src/index.js";
import { sizeOf } from "./stage.js";

const SECONDS = 1; // of sound
// Small pictures that change all the time: a graphics card would only wait for them.
const ON_CPU = { willReadFrequently: true };
const PAUSE = 80; // ms between two pictures
const ROWS = 5; // of touched bodies
const words = (name) => name.replace(/^.*[:/]/, "").replaceAll("_", " ");

export class Senses {
  constructor(page) {
    this.page = page;
    this.rows = Array.from({ length: ROWS }, () => {
      const row = document.createElement("li");
      row.append(...["span", "i", "span"].map((tag) => document.createElement(tag)));
      page.touch.append(row);
      return row;
    });
  }

  /** Begins with a world, or with its new body. */
  show(world) {
    this.world = world;
    this.next = 0;
    const named = (end) => world.layout.fields.find(({ name }) => name.endsWith(end));
    this.eyes = ["left", "right"].map((side) => this.#eye(this.page[side], named(`vision/eye_${side}`)));
    this.ears = ["left", "right"].map((side) => this.#ear(named(`hearing/ear_${side}`)));
    this.skin = this.#skin(named("touch/force"));
    this.joints = this.#joints(named("proprioception/position"));
  }

  #eye(canvas, field) {
    if (!field) return null;
    [canvas.height, canvas.width] = field.shape;
    const context = canvas.getContext("2d", ON_CPU);
    return { name: field.name, context, picture: context.createImageData(canvas.width, canvas.height) };
  }

  #ear(field) {
    return field ? { name: field.name, kept: new Float32Array(SECONDS * field.sampleRate), next: 0 } : null;
  }

  #skin(field) {
    if (!field) return null;
    const owners = this.world.layout.receptors(field.name, Receptor.BODY);
    return { name: field.name, width: field.shape[1], owners: Int32Array.from(owners), sums: new Float32Array(this.world.count(Kind.BODY)), names: this.world.names(Kind.BODY) };
  }

  #joints(field) {
    if (!field) return null;
    const labels = Array.from({ length: field.shape[0] }, (_, i) => this.world.layout.label(field.name, i));
    const ids = labels.map((label) => this.world.find(Kind.JOINT, label));
    return { name: field.name, labels: labels.map(words), ranges: this.world.get(Quantity.JOINT_RANGE, ids) };
  }

  /** Keeps what was heard in a step. */
  hear() {
    for (const ear of this.ears) {
      if (!ear) continue;
      for (const value of this.world.observation[ear.name]) {
        ear.kept[ear.next] = value;
        ear.next = (ear.next + 1) % ear.kept.length;
      }
    }
  }

  draw(now) {
    if (now < (this.next ?? 0)) return;
    this.next = now + PAUSE;
    this.eyes.forEach((eye) => eye && this.#drawEye(eye));
    this.#drawSound();
    if (this.skin) this.#drawTouch();
    if (this.joints) this.#drawJoints();
  }

  #drawEye({ name, context, picture }) {
    const seen = this.world.observation[name];
    const to = picture.data;
    for (let i = 0, j = 0; i < seen.length; i += 3, j += 4) {
      [to[j], to[j + 1], to[j + 2], to[j + 3]] = [seen[i], seen[i + 1], seen[i + 2], 255];
    }
    context.putImageData(picture, 0, 0);
  }

  #drawSound() {
    const canvas = this.page.sound;
    const context = fitted(canvas);
    const { width, height } = canvas;
    context.strokeStyle = getComputedStyle(canvas).color;
    const ears = this.ears.filter(Boolean);
    const loudest = Math.max(0.002, ...ears.map(({ kept }) => kept.reduce((most, one) => Math.max(most, Math.abs(one)), 0)));
    ears.forEach(({ kept, next }, row) => {
      const [middle, half] = [(height * (row + 0.5)) / ears.length, (0.46 * height) / ears.length];
      context.beginPath();
      for (let x = 0; x < width; x++) {
        const [first, last] = [x, x + 1].map((one) => Math.floor((one * kept.length) / width));
        let [low, high] = [Infinity, -Infinity];
        for (let i = first; i < last; i++) {
          const value = kept[(next + i) % kept.length];
          [low, high] = [Math.min(low, value), Math.max(high, value)];
        }
        context.moveTo(x + 0.5, middle - (half * high) / loudest - 0.5);
        context.lineTo(x + 0.5, middle - (half * low) / loudest + 0.5);
      }
      context.stroke();
    });
  }

  #drawTouch() {
    const { name, width, owners, sums, names } = this.skin;
    const forces = this.world.observation[name];
    sums.fill(0);
    for (let i = 0; i < owners.length; i++) {
      const force = sizeOf(forces, width, i);
      if (force > 0) sums[owners[i]] += force;
    }
    const touched = Array.from(sums.keys()).filter((body) => sums[body] > 0).sort((one, two) => sums[two] - sums[one]);
    this.rows.forEach((row, i) => {
      const body = touched[i];
      const [label, bar, value] = row.children;
      label.textContent = body === undefined ? "" : words(names[body]);
      bar.style.width = body === undefined ? "0" : `${Math.min(100, 25 * Math.log10(1 + 100 * sums[body]))}%`;
      value.textContent = body === undefined ? "" : sums[body].toFixed(sums[body] < 10 ? 2 : 0);
    });
  }

  #drawJoints() {
    const canvas = this.page.joints;
    const { name, labels, ranges } = this.joints;
    const columns = canvas.clientWidth > 420 ? 2 : 1;
    const row = 15;
    const high = row * Math.ceil(labels.length / columns);
    if (canvas.clientHeight !== high) canvas.style.height = `${high}px`;
    const context = fitted(canvas);
    context.scale(devicePixelRatio, devicePixelRatio);
    context.font = "11px system-ui, sans-serif";
    const color = (context.fillStyle = getComputedStyle(canvas).color);
    const values = this.world.observation[name];
    const wide = canvas.clientWidth / columns;
    labels.forEach((label, i) => {
      const [x, y] = [wide * (i % columns), row * Math.floor(i / columns)];
      const [low, high] = [ranges[2 * i], ranges[2 * i + 1]];
      const [from, to] = [x + 0.62 * wide, x + wide - 10];
      const at = from + (to - from) * Math.max(0, Math.min(1, (values[i] - low) / (high - low || 1)));
      context.fillStyle = color;
      context.fillText(label, x, y + 11, 0.58 * wide);
      context.globalAlpha = 0.25;
      context.fillRect(from, y + 7, to - from, 2);
      context.globalAlpha = 1;
      context.fillStyle = "#d7191e";
      context.fillRect(at - 1.5, y + 3, 3, 10);
    });
  }
}

/** A cleared context of a canvas that has as many pixels as it covers. */
function fitted(canvas) {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((one) => Math.max(1, Math.round(one * devicePixelRatio)));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d", ON_CPU);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}
