/** What both pages have in common: their elements, what they say, the scene, and the loop of pictures. */
import { Stage } from "./stage.js";

const PATIENCE = 40; // ms of each picture for steps

/** The elements of the page, by their ids. */
export const page = Object.fromEntries([...document.querySelectorAll("[id]")].map((element) => [element.id, element]));

/** Says on the page what went wrong, in a sentence. */
export function say(error) {
  page.message.hidden = !error;
  const text = typeof error === "string" ? error : (error?.message ?? "");
  page.message.textContent = text && text[0].toUpperCase() + text.slice(1) + (/[.!?]$/.test(text) ? "" : ".");
}

/** Does something that may be refused. */
export function trying(act) {
  try {
    say(null);
    return act();
  } catch (error) {
    say(error);
    return undefined;
  }
}

/** The scene in 3-D; null without WebGL, which the page says in its place. */
export function openStage() {
  try {
    return new Stage(page.scene);
  } catch (error) {
    const told = document.createElement("p");
    told.textContent = `This browser has no WebGL, so the room is not drawn; everything else works (${error.message}).`;
    page.scene.replaceWith(told);
    return null;
  }
}

/**
 * Shows what `make` makes, picture by picture, and pauses where that cannot go on. What goes wrong is said.
 * @param {() => Promise<Shown>} make
 */
export async function start(make) {
  page.angles.open = innerWidth > 760; // long, on a phone
  try {
    const shown = (globalThis.mimoPage = await make());
    const next = (now) => {
      try {
        shown.tick(now);
      } catch (error) {
        shown.pause(true);
        say(error);
      }
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  } catch (error) {
    page.clock.textContent = "";
    say(error);
  }
}

/** What runs and rests: `advance` does a step, false where there is none. */
export class Shown {
  running = true;
  pace = new Pace();

  pause(paused) {
    this.running = !paused;
    page.run.textContent = paused ? "Run" : "Pause";
  }

  /** Steps a world as far as time has gone on, and draws. */
  go(now, world) {
    if (this.running) {
      this.pace.run(now, Number(page.speed.value), world.layout.stepSeconds, () => this.advance());
    } else {
      this.pace.rest(now);
    }
    this.stage?.touch();
    this.stage?.draw();
    this.senses.draw(now);
  }

  /** How fast it runs, for the clock. */
  get speed() {
    return this.running ? `, ${this.pace.rate.toFixed(1)}× real time` : ", paused";
  }
}

/** Lets as much simulated time go by as the clock says, as far as this machine keeps up. */
class Pace {
  rate = 1; // of real time, lately
  #due = 0;

  /**
   * @param {number} now ms
   * @param {number} speed of simulated time; Infinity: as fast as it goes
   * @param {number} length of a step, s
   * @param {() => boolean} advance does a step; false where there is none
   */
  run(now, speed, length, advance) {
    const seconds = Math.min((now - (this.last ?? now)) / 1000, 0.2);
    this.last = now;
    this.#due += seconds === 0 ? 0 : seconds * speed;
    const until = performance.now() + PATIENCE;
    let done = 0;
    while (this.#due >= length && performance.now() < until && advance()) {
      this.#due -= length;
      done += length;
    }
    this.#due = Math.min(this.#due, length);
    if (seconds > 0) this.rate += (done / seconds - this.rate) * Math.min(1, seconds);
  }

  /** What goes by meanwhile does not count. */
  rest(now) {
    this.last = now;
  }
}
