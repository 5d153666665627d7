/** A recording in a world of its own: played, and compared step by step with what the file kept. */
import { AS_RECORDED, FieldType, Hearing, MimoError, Quantity, Replay, Status, Touch, Vision } from "../../bindings/javascript/src/index.js";

const KINDS = { [FieldType.U8]: "u8", [FieldType.I32]: "i32", [FieldType.F32]: "f32", [FieldType.F64]: "f64" };
const PIXELS = 64; // of an eye that is added, across
const [SAME, DIFFERENT] = [1, 2];

// What every recording has: the dataset, its type, and the same numbers of a world.
const OF_JOINTS = [
  ["joints/position", "f64", (world) => world.get(Quantity.JOINT_POSITION)],
  ["joints/velocity", "f64", (world) => world.get(Quantity.JOINT_VELOCITY)],
];
const OF_RESULTS = [
  ["rewards", "f64", ({ results }) => results.reward],
  ["terms", "f64", ({ results }) => results.terms],
  ["terminated", "u8", ({ results }) => results.terminated],
  ["truncated", "u8", ({ results }) => results.truncated],
  ["outcome", "i32", ({ results }) => results.outcome],
];

/** How many steps of a dataset were the same to the last bit, and how far the others were off. */
class Table {
  same = 0;
  different = 0;
  largest = 0;
  first = Infinity; // step that differed

  constructor(steps, name = "", kind = "", now = () => []) {
    Object.assign(this, { name, kind, now });
    this.steps = new Uint8Array(steps);
  }

  mark(step, difference) {
    if (this.steps[step] === 0) difference === null ? this.same++ : this.different++;
    this.steps[step] ||= difference === null ? SAME : DIFFERENT;
    if (difference === null) return;
    this.first = Math.min(this.first, step);
    this.largest = Math.max(this.largest, difference);
  }
}

export class Player {
  next = 0; // step
  world = null;
  byJoints = ""; // why joints are set as recorded, and nothing is compared

  /** @param {import("../../bindings/javascript/src/index.js").Recording} recording */
  constructor(recording) {
    this.recording = recording;
    this.info = recording.info;
    this.count = this.info.steps;
    this.all = new Table(this.count);
    this.task = this.#ownTask();
    const always = this.task ? OF_JOINTS : [...OF_JOINTS, ...OF_RESULTS];
    this.always = always.filter(([name]) => this.#has(name)).map((one) => new Table(this.count, ...one));
    this.kept = new Set(this.#has("states/step") ? Array.from(recording.read("states/step", "u64"), Number) : []);
    this.actions = this.#has("actions");
    this.open(false);
    this.lacks = ["vision/", "touch/", "hearing/"].filter((sense) => !this.world.layout.fields.some(({ name }) => name.includes(sense)));
  }

  /** The task of the user's own, which is not in the file; what it told is not compared. */
  #ownTask() {
    if (!this.#has("world")) return null;
    const calls = JSON.parse(new TextDecoder().decode(this.recording.read("world", "u8")));
    return calls.filter(({ call }) => call === "set_task").at(-1)?.task ?? null;
  }

  /** All that is compared. */
  get tables() {
    return [...this.always, ...(this.added ? [] : this.fields)];
  }

  /** Makes the world, with the senses that were not recorded or without. */
  open(added) {
    const senses = added && {
      proprioception: AS_RECORDED,
      vestibular: AS_RECORDED,
      vision: this.lacks.includes("vision/") ? Vision.RGB : AS_RECORDED,
      ...{ visionWidth: PIXELS, visionHeight: PIXELS },
      touch: this.lacks.includes("touch/") ? Touch.FORCE : AS_RECORDED,
      hearing: this.lacks.includes("hearing/") ? Hearing.EARS : AS_RECORDED,
    };
    const made = this.#make(senses ? { senses } : {});
    this.world?.close();
    this.world = made;
    this.added = added;
    // A sense that is added may change what others remember: then fields are not compared.
    this.fields ??= this.#recordedFields();
    this.seek(this.next);
  }

  /** Where a renderer was recorded that the module lacks, rays draw. */
  #make(options) {
    try {
      return this.recording.world(options);
    } catch (error) {
      if (!(error instanceof MimoError)) throw error;
      return this.recording.world({ ...options, config: { renderer: "ray" } });
    }
  }

  #has(dataset) {
    try {
      return this.recording.size(dataset).rows > 0;
    } catch (error) {
      if (error instanceof MimoError && error.status === Status.NOT_FOUND) return false;
      throw error;
    }
  }

  #recordedFields() {
    const told = (this.task?.fields ?? []).map(({ name }) => name);
    return this.world.layout.fields
      .filter(({ name }) => this.#has(`fields/${name}`) && !told.some((one) => name.endsWith(one)))
      .map(({ name, dtype }) => new Table(this.count, `fields/${name}`, KINDS[dtype], ({ observation }) => observation[name]));
  }

  /** Brings the world to where it was after so many steps. */
  seek(step) {
    this.#load(step);
    while (this.next < step && this.#play());
  }

  #load(step) {
    const how = this.byJoints ? Replay.JOINTS : 0;
    try {
      this.next = this.recording.seek(this.world, step, how);
    } catch (error) {
      if (this.byJoints || !(error instanceof MimoError) || error.status !== Status.MISMATCH) throw error;
      this.byJoints = error.message;
      this.next = this.recording.seek(this.world, step, Replay.JOINTS);
    }
    this.parted = false;
    this.world.observe();
  }

  /** Plays a step; false at the end. What has parted begins anew from the next kept state. */
  step() {
    if (this.parted && this.kept.has(this.next)) this.#load(this.next);
    return this.#play();
  }

  #play() {
    if (this.next >= this.count || this.recording.step(this.world) === null) return false;
    if (!this.byJoints) this.#compare(this.next);
    this.next++;
    return true;
  }

  #compare(step) {
    let parted = false;
    for (const table of this.tables) {
      const difference = differenceOf(this.recording.read(table.name, table.kind, step, 1), table.now(this.world));
      table.mark(step, difference);
      parted ||= difference !== null;
    }
    this.all.mark(step, parted ? 0 : null);
    this.parted ||= parted;
  }

  /** The action of the last step that was played, without what it left alone. */
  lastAction() {
    const action = new Float32Array(this.world.layout.actions.length);
    if (this.actions && this.next > 0) action.set(this.recording.read("actions", "f32", this.next - 1, 1));
    return action.map((one) => (Number.isNaN(one) ? 0 : one));
  }

  /** What was found so far, in a sentence. */
  verdict() {
    const { all, count } = this;
    const done = all.same + all.different;
    if (this.byJoints) {
      return `Joints are where the file has them, and nothing can be compared: ${this.byJoints}.`;
    }
    if (done === 0) return `Nothing is compared yet of ${count} steps.`;
    if (all.different === 0) {
      return done === count
        ? `Verified: all ${count} steps are the same as in the file, to the last bit.`
        : `Verified ${done} of ${count} steps: the same as in the file so far, to the last bit.`;
    }
    // Fields that differed before a sense was added are no longer compared, but count.
    const [first] = [...this.always, ...this.fields].filter(({ different }) => different > 0).sort((one, two) => one.first - two.first);
    const seconds = (this.info.stepSeconds * (first.first + 1)).toFixed(2);
    return `${all.same} of ${done} steps are the same as in the file, to the last bit. ${first.name} differs first in step ${first.first + 1}, at ${seconds} s, by ${first.largest.toPrecision(2)} at most.`;
  }
}

/** Null where all bytes are the same, else the largest difference of numbers. */
function differenceOf(kept, now) {
  const [one, two] = [kept, now].map((array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
  let at = one.length === two.length ? 0 : -1;
  while (at >= 0 && at < one.length && one[at] === two[at]) at++;
  if (at === one.length) return null;
  let largest = 0;
  for (let i = 0; i < kept.length; i++) {
    const difference = Math.abs(kept[i] - now[i]);
    if (difference > largest || Number.isNaN(difference)) largest = Number.isNaN(difference) ? Infinity : difference;
  }
  return largest;
}
