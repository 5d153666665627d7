/** The page of mimo export --html: plays the recording inside it, compares, and lets the reader take over. */
import { load, Recording } from "../../bindings/javascript/src/index.js";
import { Babble, rest } from "./behaviour.js";
import { openStage, page, Shown, start, trying } from "./page.js";
import { Player } from "./player.js";
import { Pull } from "./pull.js";
import { Senses } from "./senses.js";
import { bytesIn, moduleIn, roundAsIn, textIn } from "./inside.js";

const PAUSE = 250; // ms between two reports of what was compared

class RecordingPage extends Shown {
  own = false; // the reader has taken over
  told = 0; // ms, when the report was written

  constructor(player, stage, name) {
    super();
    this.player = player;
    this.stage = stage;
    this.pull = stage && new Pull(stage, () => this.takeOver());
    this.senses = new Senses(page);
    const same = { act: () => {} };
    this.behaviours = { same, rest, babble: new Babble() };
    page.title.textContent = document.title = name;
    page.at.max = player.count;
    page.run.onclick = () => this.pause(this.running);
    page.step.onclick = () => {
      this.pause(true);
      trying(() => this.advance());
    };
    page.again.onclick = () => this.goTo(0);
    page.own.onclick = () => (this.own ? this.goTo(player.next) : this.takeOver());
    page.at.oninput = () => this.goTo(Number(page.at.value));
    page.add.onclick = () => this.#add();
    page.licences.ontoggle = () => this.#showLicences();
    for (const button of [page.run, page.step, page.again, page.own, page.at]) button.disabled = false;
    page.add.hidden = player.lacks.length === 0;
    this.renew();
  }

  /** Draws all that depends on the bodies anew. */
  renew(keepView = false) {
    const { world, info } = this.player;
    this.stage?.show(world, keepView);
    this.senses.show(world);
    const { mass, height } = world.agent(0);
    this.height = height;
    page.seen.hidden = this.senses.eyes.every((eye) => !eye);
    page.heard.hidden = this.senses.ears.every((ear) => !ear);
    page.felt.hidden = !this.senses.skin;
    page.angles.hidden = !this.senses.joints;
    page.body.textContent = `${mass.toFixed(1)} kg, ${(100 * height).toFixed(0)} cm, ${world.layout.actions.length} motors. Recorded with ${info.build.replace(/,? build.*/, "")}, seed ${info.seed}, ${(info.steps * info.stepSeconds).toFixed(2)} s in ${info.steps} steps.`;
  }

  /** From here on the reader decides; the recording stays where it was left. */
  takeOver() {
    if (this.own) return;
    this.own = true;
    this.action = this.player.lastAction();
    this.pause(false);
    this.#showOwner();
  }

  /** Goes to a step of the recording. */
  goTo(step) {
    trying(() => {
      this.pull?.release();
      this.own = false;
      this.player.seek(step);
      this.#follow();
      this.#showOwner();
    });
  }

  #showOwner() {
    page.own.textContent = this.own ? "Back to the recording" : "Take over";
    page.does.hidden = !this.own;
    page.room.classList.toggle("own", this.own);
  }

  /** The world as it is now; infants may have become older. */
  #follow() {
    if (this.player.info.bodies > 1 && this.player.world.agent(0).height !== this.height) this.renew(true);
    this.stage?.move();
  }

  /** A step of the recording, or of the reader's; false where there is none. */
  advance() {
    if (this.own) {
      this.#actAlone();
    } else if (!this.player.step()) {
      this.pause(true);
      return false;
    }
    this.senses.hear();
    this.#follow();
    return true;
  }

  #actAlone() {
    const { world } = this.player;
    this.behaviours[page.behaviour.value].act(world, this.action);
    this.pull?.apply(world.layout.stepSeconds);
    const { terminated, truncated } = world.step(this.action);
    if (terminated.some(Boolean) || truncated.some(Boolean)) world.reset();
  }

  #add() {
    trying(() => {
      this.pull?.release();
      this.own = false;
      this.player.open(true);
      page.add.hidden = true;
      this.renew(true);
      this.#showOwner();
    });
  }

  async #showLicences() {
    if (page.licences.open) page.texts.textContent ||= await textIn(page.packed);
  }

  tick(now) {
    const { player } = this;
    if (this.running && !this.own && player.next === player.count && this.ended) this.goTo(0);
    this.go(now, player.world);
    this.ended = !this.running && player.next === player.count;
    page.at.value = player.next;
    const { stepSeconds } = player.info;
    const where = this.own ? `${player.world.time().toFixed(2)} s, yours` : `${(player.next * stepSeconds).toFixed(2)} of ${(player.count * stepSeconds).toFixed(2)} s`;
    page.clock.textContent = where + this.speed;
    if (now - this.told > PAUSE || !this.running) this.#report(now);
  }

  #report(now) {
    this.told = now;
    const { player } = this;
    const found = player.all.different > 0 ? "differs" : player.all.same > 0 && !player.byJoints ? "same" : "";
    page.verdict.className = found;
    page.verdict.textContent = player.verdict();
    page.compared.hidden = player.byJoints;
    const rows = player.tables.map(({ name, same, different, first, largest }) => [
      name,
      `${same} of ${same + different}`,
      different > 0 ? `from step ${first + 1} on, by ${largest.toPrecision(2)} at most` : "",
    ]);
    page.rows.replaceChildren(...rows.map(rowOf));
  }
}

function rowOf(texts) {
  const row = document.createElement("tr");
  row.append(...texts.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
  return row;
}

start(async () => {
  const { recording, rounding } = page;
  if (!recording) throw new Error("this page has no recording yet: mimo export --html run.html run.h5 puts one into it");
  const stage = openStage();
  await load(moduleIn(page.module));
  roundAsIn(rounding);
  const { name } = recording.dataset;
  return new RecordingPage(new Player(new Recording(bytesIn(recording), name)), stage, name);
});
