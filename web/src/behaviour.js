/** What the infant does: nothing, random movements, or what a network has learned. */

/** Numbers of single precision in base 64. */
function numbers(text) {
  const bytes = Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/** A learned network, in the format of docs/guide/policies.md. */
export class Policy {
  constructor(content) {
    if (content.format !== "mimo-policy" || content.version !== 1) throw new Error("the policy is no mimo-policy of version 1");
    this.stepSeconds = content.step_seconds ?? 0;
    this.clip = content.clip ?? 10;
    this.fields = content.fields;
    this.names = content.actions;
    [this.mean, this.deviation] = [numbers(content.mean), numbers(content.deviation)];
    this.layers = content.layers.map(({ rows, weights, bias }) => ({ rows, weights: numbers(weights), bias: numbers(bias), out: new Float32Array(rows) }));
    this.seen = new Float32Array(this.mean.length);
  }

  /** Whether it knows what a world's infant feels and does. */
  fits({ layout }) {
    const shapes = new Map(layout.fields.map(({ name, shape }) => [name, shape.reduce((all, one) => all * one, 1)]));
    return (
      (this.stepSeconds === 0 || Math.abs(this.stepSeconds - layout.stepSeconds) < 1e-9) &&
      this.fields.every(([name, count]) => shapes.get(name) === count) &&
      this.names.length === layout.actions.length &&
      layout.actions.every(({ name }, i) => name === this.names[i])
    );
  }

  act(world, action) {
    let at = 0;
    for (const [name] of this.fields) {
      for (const value of world.observation[name]) {
        this.seen[at] = Math.max(-this.clip, Math.min(this.clip, (value - this.mean[at]) / this.deviation[at]));
        at++;
      }
    }
    let row = this.seen;
    this.layers.forEach(({ rows, weights, bias, out }, layer) => {
      for (let i = 0; i < rows; i++) {
        let sum = bias[i];
        for (let j = 0; j < row.length; j++) sum += weights[i * row.length + j] * row[j];
        out[i] = layer < this.layers.length - 1 ? Math.tanh(sum) : sum;
      }
      row = out;
    });
    world.layout.actions.forEach(({ low, high }, i) => {
      action[i] = low + ((high - low) * (Math.max(-1, Math.min(1, row[i])) + 1)) / 2;
    });
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
