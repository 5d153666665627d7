// A minute of an infant that babbles with its right arm, and what its skin feels: node hello.mjs
import { faces, load, Scene, Touch, World } from "libmimo";

await load();
const scene = new Scene("reach");
scene.addAgent({ touch: Touch.FORCE, growth: { age: 6 } });
const world = new World(scene);
world.setFace(faces()[0]);
world.reset({ seed: 1 });

const { actions, stepSeconds } = world.layout;
let action = actions.map(() => 0);
let touched = 0;
for (let step = 0; step * stepSeconds < 60; step++) {
  if (step % 50 === 0) action = actions.map(({ low, high }) => low + (high - low) * Math.random());
  const { terminated, truncated } = world.step(action);
  if (world.observation["touch/force"].some((newtons) => newtons !== 0)) touched++;
  if (terminated[0] || truncated[0]) world.reset();
}
console.log(`The skin felt something in ${touched} of ${Math.round(60 / stepSeconds)} steps`);
