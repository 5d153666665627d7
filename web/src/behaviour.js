/** What the infant does: nothing, random movements, or what a network has learned. */

const FORMAT = "mimo-policy";
const NEW = ["age", "delays", "hold_s", "clock_s", "reflex"]; // members of version 2
const MEMBERS = ["format", "version", "what", "scene", "step_seconds", "fields", "actions", "mean", "deviation", "clip", "layers", "how", ...NEW];
const REFLEX = ["stiffness", "damping", "joints", "start"];
const MOST_PERIODS = 64;
const MOST_ROWS = 4096; // of a layer, and numbers of a field
const [ANGLES, VELOCITIES] = ["proprioception/position", "proprioception/velocity"]; // what a reflex feels

/** A value for a message. */
function told(value) {
  const text = JSON.stringify(value) ?? "missing";
  return text.length > 60 ? `${text.slice(0, 60)}...` : text;
}

function refuse(why) {
  throw new Error(`the policy is refused: ${why}`);
}

function refuseUnknown(owner, members, known) {
  for (const name of Object.keys(members)) {
    if (!known.includes(name)) refuse(`${owner} has no member ${told(name)}; expected ${known.join(", ")}`);
  }
}

function checkMembers(content) {
  if (content?.format !== FORMAT) refuse(`"format" is not "${FORMAT}"`);
  if (content.version === 2) return refuseUnknown("a policy", content, MEMBERS);
  if (content.version !== 1) refuse(`its version is ${told(content.version)}, and this page reads versions 1 and 2`);
  for (const name of NEW) {
    if (name in content) refuse(`"${name}" needs version 2, and its version is 1`);
  }
}

function list(name, value, count = value?.length) {
  if (!Array.isArray(value)) refuse(`"${name}" is ${told(value)}, expected a list`);
  if (value.length !== count) refuse(`"${name}" has ${value.length} elements, expected ${count}, one for each action`);
  return value;
}

function positive(name, value, least = Number.MIN_VALUE) {
  if (!(typeof value === "number" && Number.isFinite(Math.fround(value)) && value >= least)) {
    refuse(`"${name}" is ${told(value)}, expected a number ${least === 0 ? "from 0 on" : "above 0"}`);
  }
  return value;
}

function monthsOf(age) {
  if (age === undefined) return undefined;
  if (!(typeof age === "number" && age >= 0 && age <= 24)) refuse(`"age" is ${told(age)}, expected months from 0 to 24`);
  return age;
}

/** Shorter periods and longer holds are a mistake, and their quotients would end at infinity. */
function seconds(name, value) {
  if (!(typeof value === "number" && value >= 1e-3 && value <= 1e6)) refuse(`"${name}" is ${told(value)}, expected seconds from 0.001 to 1e+06`);
  return value;
}

function reflexOf(reflex, actions) {
  if (reflex === undefined) return undefined;
  if (typeof reflex !== "object" || reflex === null || Array.isArray(reflex)) refuse(`"reflex" is ${told(reflex)}, expected an object`);
  refuseUnknown('"reflex"', reflex, REFLEX);
  positive("stiffness", reflex.stiffness);
  positive("damping", reflex.damping, 0);
  for (const name of list("joints", reflex.joints, actions.length)) {
    if (typeof name !== "string") refuse(`"joints" holds ${told(name)}, expected names`);
  }
  for (const angle of list("start", reflex.start, actions.length)) {
    if (typeof angle !== "number" || !Number.isFinite(Math.fround(angle))) refuse(`"start" holds ${told(angle)}, expected a finite number`);
  }
  return reflex;
}

function textIn(content, name) {
  const text = content[name] ?? "";
  if (content.version > 1 && (content[name] === null || typeof text !== "string")) refuse(`"${name}" is ${told(content[name])}, expected text`);
  return typeof text === "string" ? text : "";
}

function size(name, value) {
  if (!(Number.isInteger(value) && value >= 1 && value <= MOST_ROWS)) refuse(`${name} is ${told(value)}, expected 1 to ${MOST_ROWS}`);
  return value;
}

/** A member, or what stands for a missing one. */
function memberOr(content, name, otherwise) {
  return name in content ? content[name] : otherwise;
}

function fieldsIn(content) {
  const fields = list("fields", content.fields);
  if (content.version === 1 && fields.length === 0) refuse('it has no list "fields"');
  for (const field of fields) {
    if (!Array.isArray(field) || field.length !== 2 || typeof field[0] !== "string") refuse('"fields" is no list of names and counts');
    size("a field's count", field[1]);
  }
  return fields;
}

function namesIn(content) {
  const names = list("actions", content.actions);
  if (!names.every((name) => typeof name === "string")) refuse('"actions" is no list of names');
  return names;
}

function bytesOf(text) {
  try {
    return Uint8Array.from(typeof text === "string" ? atob(text) : "", (one) => one.charCodeAt(0));
  } catch {
    return new Uint8Array(0);
  }
}

/** So many numbers of single precision in base 64. */
function numbers(name, text, count) {
  const bytes = bytesOf(text);
  if (typeof text !== "string" || bytes.length !== 4 * count) refuse(`"${name}" holds ${bytes.length} bytes of base 64, expected ${4 * count}: ${count} numbers`);
  const values = new Float32Array(bytes.buffer);
  if (!values.every(Number.isFinite)) refuse(`"${name}" holds what is no finite number`);
  return values;
}

/** A learned network, in the format of docs/guide/policies.md. */
export class Policy {
  constructor(content) {
    checkMembers(content);
    textIn(content, "what");
    this.scene = textIn(content, "scene");
    this.age = monthsOf(content.age);
    this.delays = memberOr(content, "delays", false);
    if (typeof this.delays !== "boolean") refuse(`"delays" is ${told(content.delays)}, expected true or false`);
    this.stepSeconds = positive("step_seconds", memberOr(content, "step_seconds", 0), 0);
    this.clip = positive("clip", memberOr(content, "clip", 10));
    this.fields = fieldsIn(content);
    this.names = namesIn(content);
    this.holdSeconds = content.hold_s === undefined ? undefined : seconds("hold_s", content.hold_s);
    this.periods = list("clock_s", memberOr(content, "clock_s", [])).map((period) => seconds("clock_s", period));
    if (this.periods.length > MOST_PERIODS) refuse(`"clock_s" has ${this.periods.length} periods, expected at most ${MOST_PERIODS}`);
    this.reflex = reflexOf(content.reflex, this.names);
    let width = this.fields.reduce((sum, [, count]) => sum + count, 2 * this.periods.length);
    [this.mean, this.deviation] = [numbers("mean", content.mean, width), numbers("deviation", content.deviation, width)];
    if (!this.deviation.every((one) => one > 0)) refuse('"deviation" holds a number that is not above 0');
    this.seen = new Float32Array(width);
    this.layers = list("layers", content.layers).map((layer) => {
      if (typeof layer !== "object" || layer === null || Array.isArray(layer)) refuse('"layers" is no list of layers');
      if (content.version > 1) refuseUnknown("a layer", layer, ["rows", "weights", "bias"]);
      const { rows, weights, bias } = layer;
      size('"rows" of a layer', rows);
      const found = { rows, weights: numbers("weights", weights, rows * width), bias: numbers("bias", bias, rows), out: new Float32Array(rows) };
      width = rows;
      return found;
    });
    if (this.layers.length === 0 || width !== this.names.length) refuse(`its last layer has ${width} rows, and it has ${this.names.length} actions`);
    this.last = -1; // the step of the episode in which it acted last; -1: never
  }

  /** Whether it knows what a world's infant feels and does. If so, it can act in that world from now on. */
  fits({ layout }) {
    const shapes = new Map(layout.fields.map(({ name, shape }) => [name, shape.reduce((all, one) => all * one, 1)]));
    const hold = this.holdSeconds === undefined ? 1 : this.holdSeconds / layout.stepSeconds;
    const joints = this.#joints(layout, shapes);
    const fits =
      (this.stepSeconds === 0 || Math.abs(this.stepSeconds - layout.stepSeconds) < 1e-9) &&
      (Math.round(hold) >= 1 && Math.abs(hold - Math.round(hold)) <= 1e-6 * hold) &&
      this.fields.every(([name, count]) => shapes.get(name) === count) &&
      this.names.length === layout.actions.length &&
      layout.actions.every(({ name }, i) => name === this.names[i]) &&
      joints.every((joint) => joint >= 0);
    if (fits) [this.hold, this.joints, this.last] = [Math.round(hold), joints, -1];
    return fits;
  }

  /** Where the reflex feels each action's joint; -1: nowhere. */
  #joints(layout, shapes) {
    if (!this.reflex) return [];
    if (!shapes.has(ANGLES) || shapes.get(VELOCITIES) !== shapes.get(ANGLES)) return [-1];
    const labels = Array.from({ length: shapes.get(ANGLES) }, (_, i) => layout.label(ANGLES, i));
    return this.reflex.joints.map((name) => labels.indexOf(name));
  }

  /** An earlier time of the world than before is another episode's. */
  act(world, action) {
    const time = world.time();
    const step = Math.round(time / world.layout.stepSeconds);
    const sameHold = Math.floor(step / this.hold) === Math.floor(this.last / this.hold);
    if (this.last < 0 || step % this.hold === 0 || !sameHold || step < this.last) this.#think(world, time);
    this.last = step;
    const { out } = this.layers.at(-1);
    world.layout.actions.forEach(({ low, high }, i) => {
      action[i] = this.reflex
        ? Math.max(low, Math.min(high, this.#pull(world.observation, i, out[i])))
        : low + ((high - low) * (Math.max(-1, Math.min(1, out[i])) + 1)) / 2;
    });
  }

  #pull(observation, i, goal) {
    const { stiffness, damping, start } = this.reflex;
    const joint = this.joints[i];
    return stiffness * (start[i] + goal - observation[ANGLES][joint]) - damping * observation[VELOCITIES][joint];
  }

  /** Renews what the layers give. */
  #think({ observation }, time) {
    let at = 0;
    const see = (value) => {
      this.seen[at] = Math.max(-this.clip, Math.min(this.clip, (value - this.mean[at]) / this.deviation[at]));
      at++;
    };
    for (const [name] of this.fields) observation[name].forEach(see);
    for (const period of this.periods) [Math.sin, Math.cos].forEach((turned) => see(turned((2 * Math.PI * time) / period)));
    let row = this.seen;
    this.layers.forEach(({ rows, weights, bias, out }, layer) => {
      for (let i = 0; i < rows; i++) {
        let sum = bias[i];
        for (let j = 0; j < row.length; j++) sum += weights[i * row.length + j] * row[j];
        out[i] = layer < this.layers.length - 1 ? Math.tanh(sum) : sum;
      }
      row = out;
    });
    if (!row.every(Number.isFinite)) refuse("its network gives what is no finite number");
  }
}

/** Random movements: each motor goes to a new strength about twice a second. */
export class Babble {
  act(world, action) {
    const { actions, stepSeconds } = world.layout;
    if (this.goals?.length !== action.length) this.goals = new Float32Array(action.length);
    actions.forEach(({ low, high }, i) => {
      if (Math.random() < 2 * stepSeconds) this.goals[i] = low + (high - low) * Math.random();
      action[i] += (this.goals[i] - action[i]) * Math.min(1, 5 * stepSeconds);
      action[i] = Math.max(low, Math.min(high, action[i]));
    });
  }
}

export const rest = {
  act({ layout }, action) {
    layout.actions.forEach(({ low, high }, i) => {
      action[i] = Math.max(low, Math.min(high, 0));
    });
  },
};
