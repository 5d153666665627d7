/** A spring between a body and the pointer. */
import { Quantity } from "../../bindings/javascript/src/index.js";
import { toWorld } from "./stage.js";

const STIFFNESS = 200; // N/m
const LARGEST = 60; // N

export class Pull {
  /**
   * @param {import("./stage.js").Stage} stage
   * @param {() => void} [begun] is called when somebody takes hold of a body
   */
  constructor(stage, begun = () => {}) {
    this.stage = stage;
    this.begun = begun;
    const { canvas } = stage;
    canvas.addEventListener("pointerdown", (event) => this.#begin(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => this.release());
  }

  #begin(event) {
    const hit = event.button === 0 && this.stage.world ? this.stage.pick(event.clientX, event.clientY) : null;
    if (!hit) return;
    event.stopImmediatePropagation();
    this.stage.canvas.setPointerCapture(event.pointerId);
    this.body = hit.body;
    this.at = this.stage.bodies[hit.body].worldToLocal(hit.point.clone());
    this.target = hit.point;
    this.begun();
  }

  #move(event) {
    if (this.target) this.target = this.stage.beside(event.clientX, event.clientY, this.target);
  }

  release() {
    if (this.target && this.stage.world) this.stage.world.set(Quantity.BODY_FORCE, [this.body], new Float64Array(6));
    this.target = null;
    this.stage.line.visible = false;
  }

  /** Sets the force of the next step; smaller for light bodies, which a stiff spring would fling. */
  apply(seconds) {
    if (!this.target) return;
    const { world, bodies } = this.stage;
    const held = bodies[this.body].localToWorld(this.at.clone());
    const [mass] = world.get(Quantity.BODY_MASS, [this.body]);
    const stiffness = Math.min(STIFFNESS, mass / seconds ** 2);
    const damping = Math.min(Math.sqrt(stiffness * mass), (0.25 * mass) / seconds);
    const velocity = world.get(Quantity.BODY_VELOCITY, [this.body]);
    const [from, to] = [toWorld(held), toWorld(this.target)];
    const force = to.map((one, i) => stiffness * (one - from[i]) - damping * velocity[i]);
    const size = Math.hypot(...force);
    const share = size > LARGEST ? LARGEST / size : 1;
    world.set(Quantity.BODY_FORCE, [this.body], [...force.map((one) => one * share), 0, 0, 0]);
    const ends = this.stage.line.geometry.attributes.position;
    ends.setXYZ(0, held.x, held.y, held.z);
    ends.setXYZ(1, this.target.x, this.target.y, this.target.z);
    ends.needsUpdate = true;
    this.stage.line.visible = true;
  }
}
