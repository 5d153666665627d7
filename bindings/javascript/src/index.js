/** MIMo, the multimodal infant model, in JavaScript: `await load()`, then `new World("reach")`. */
export * from "./generated/constants.js";
export { Batch } from "./batch.js";
export { MimoError } from "./error.js";
export { convertDirections, convertPoints, convertPoses } from "./generated/conversions.js";
export { Layout } from "./layout.js";
export { apiVersion, faces, materials, mujocoVersion, parameters, rooms, scenes, statusName, supports, tasks, version } from "./library.js";
export { load } from "./memory.js";
export { Named } from "./named.js";
export { Recorder, Recording } from "./recording.js";
export { maturityAt, Scene } from "./scene.js";
export { Stage } from "./stage.js";
export { World } from "./world.js";

/**
 * @typedef {import("./generated/types.js").AgentConfig} AgentConfig
 * @typedef {import("./generated/types.js").EnvConfig} EnvConfig
 * @typedef {import("./generated/types.js").Growth} Growth
 * @typedef {import("./generated/types.js").Maturity} Maturity
 * @typedef {import("./layout.js").Field} Field
 * @typedef {import("./stage.js").StageParts} StageParts
 * @typedef {import("./stage.js").StagePicture} StagePicture
 * @typedef {import("./stage.js").StagePoses} StagePoses
 * @typedef {import("./stage.js").StageView} StageView
 * @typedef {import("./task.js").Task} Task
 * @typedef {import("./task.js").Moment} Moment
 * @typedef {import("./task.js").Verdict} Verdict
 * @typedef {import("./world.js").Step} Step
 * @typedef {import("./named.js").Picture} Picture
 */
