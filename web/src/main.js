/** The page: a world, the scene in 3-D, what the infant senses, and what visitors may change. */
import * as mimo from "../../bindings/javascript/src/index.js";
import { Babble, Policy, rest } from "./behaviour.js";
import { openStage, page, Shown, start, trying } from "./page.js";
import { Pull } from "./pull.js";
import { Senses } from "./senses.js";

const PIXELS = 64; // of an eye, across

class Page extends Shown {
  episodes = 0;
  reached = 0;

  /** @param {Policy[]} policies of scenes */
  constructor(policies, stage) {
    super();
    this.stage = stage;
    this.pull = stage && new Pull(stage);
    this.senses = new Senses(page);
    this.policies = policies;
    this.behaviours = { babble: new Babble(), rest };
    this.#fill(page.scenes, mimo.scenes(), "reach");
    this.#fill(page.tasks, ["the scene's", ...mimo.tasks()], "the scene's");
    this.#fill(page.faces, mimo.faces(), "neutral");
    page.scenes.onchange = () => {
      page.tasks.value = "the scene's";
      const policy = this.#learnedIn(page.scenes.value);
      if (policy) page.age.value = policy.age ?? 18;
      this.make();
    };
    page.tasks.onchange = () => this.make();
    page.behaviour.onchange = () => this.#choose();
    page.faces.onchange = () => this.#face();
    page.age.oninput = () => this.#tellAge();
    page.age.onchange = () => this.grow();
    page.run.onclick = () => this.pause(this.running);
    page.step.onclick = () => {
      this.pause(true);
      this.advance();
    };
    page.again.onclick = () => this.begin();
    page.save.onclick = () => this.#save();
    page.load.onchange = () => this.#load();
    for (const button of [page.run, page.step, page.again]) button.disabled = false;
    this.make();
  }

  #fill(list, names, chosen) {
    list.replaceChildren(...names.map((name) => new Option(name, name, false, name === chosen)));
  }

  /** The policy of a scene, where somebody has learned in it. */
  #learnedIn(scene) {
    return this.policies.find((policy) => policy.scene === scene);
  }

  /** Body and eyes are as old as the slider says; nerves only where a policy has learned with their delays. */
  #growth() {
    const { Mature } = mimo;
    const delays = this.#learnedIn(page.scenes.value)?.delays ? Mature.DELAYS : 0;
    return { age: Number(page.age.value), maturity: Mature.BODY | Mature.EYES | delays };
  }

  /** Makes the world that is chosen; a refused one leaves the old one. */
  make() {
    trying(() => {
      const scene = new mimo.Scene(page.scenes.value);
      let world;
      try {
        scene.addAgents({
          vision: mimo.Vision.RGB,
          ...{ visionWidth: PIXELS, visionHeight: PIXELS },
          touch: mimo.Touch.FORCE,
          hearing: mimo.Hearing.EARS,
          growth: this.#growth(),
        });
        const task = page.tasks.value;
        world = new mimo.World(scene, task === "the scene's" ? {} : { task });
      } finally {
        scene.close();
      }
      this.world?.close();
      this.world = world;
      this.action = new Float32Array(world.layout.actions.length);
      const policy = this.#learnedIn(page.scenes.value);
      const fits = policy?.fits(world) ?? false;
      this.behaviours.learned = policy;
      page.behaviour.options[0].disabled = !fits;
      page.behaviour.value = fits ? "learned" : page.behaviour.value === "learned" ? "babble" : page.behaviour.value;
      this.shown = false;
      this.begin(1);
      this.renew(false);
    });
  }

  /** Gives the infants the age of the slider. */
  grow() {
    trying(() => {
      this.pull?.release();
      this.world.reset({ age: this.#growth() });
      this.renew(true);
    });
  }

  /** Draws all that depends on the bodies anew. */
  renew(keepView) {
    this.stage?.show(this.world, keepView);
    this.senses.show(this.world);
    this.#tellAge();
    this.#choose();
    this.#face();
    const { mass, height } = this.world.agent(0);
    page.body.textContent = `${mass.toFixed(1)} kg, ${(100 * height).toFixed(0)} cm, ${this.world.layout.actions.length} motors, ${this.world.layout.fields.length} fields of senses`;
    this.shown = true;
  }

  /** Starts an episode. */
  begin(seed) {
    trying(() => {
      this.pull?.release();
      this.world.reset({ seed });
      this.action.fill(0);
    });
  }

  #tellAge() {
    const age = Number(page.age.value);
    page.months.textContent = age === 0 ? "birth" : age === 1 ? "1 month" : `${age} months`;
  }

  #choose() {
    this.behaviour = this.behaviours[page.behaviour.value];
  }

  #face() {
    trying(() => {
      this.world.setFace(page.faces.value);
      this.stage?.renewFace();
    });
  }

  advance() {
    const { world } = this;
    this.behaviour.act(world, this.action);
    this.pull?.apply(world.layout.stepSeconds);
    const { terminated, truncated, outcome } = world.step(this.action);
    this.senses.hear();
    this.stage?.move();
    if (terminated.some(Boolean) || truncated.some(Boolean)) {
      this.episodes++;
      if (outcome[0] === mimo.Outcome.SUCCESS) this.reached++;
      this.begin();
    }
    return true;
  }

  tick(now) {
    if (!this.shown) return;
    this.go(now, this.world);
    const success = this.episodes > 0 ? `, ${this.reached} of ${this.episodes} episodes succeeded` : "";
    page.clock.textContent = `${this.world.time().toFixed(2)} s${this.speed}${success}`;
  }

  #save() {
    trying(() => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([this.world.saveState()]));
      link.download = `mimo-${page.scenes.value}.state`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  async #load() {
    const [file] = page.load.files;
    page.load.value = "";
    if (!file) return;
    const bytes = new Uint8Array(await file.arrayBuffer());
    trying(() => {
      this.world.loadState(bytes);
      this.world.observe();
      this.stage?.move();
    });
  }
}

async function read(name) {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name} is missing beside the page: the server answers ${answer.status}`);
  return answer;
}

start(async () => {
  if (location.protocol === "file:") {
    throw new Error("a browser lets no page read the module from a file: serve the folder, for example with python3 -m http.server, and open http://localhost:8000");
  }
  const stage = openStage();
  const [policies] = await Promise.all([read("policies.json").then((answer) => answer.json()), mimo.load("mimo.wasm")]);
  return new Page(policies.map((content) => new Policy(content)), stage);
});
