//! Steps, terms of rewards, timing, and lists of names.
use mimo::{
    Batch, BatchConfig, Disable, Env, EnvConfig, Kind, Movement, ObjectConfig, PictureConfig, Quantity,
    Reset, Scene, Status, Touch, Vision,
};
use std::time::Duration;

/// A ball at a height of 2 m in an empty world.
fn ball(config: &EnvConfig) -> Env {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(ObjectConfig::new("ball").unwrap().position([0.0, 0.0, 2.0])).unwrap();
    Env::new(&scene, config).unwrap()
}

/// The paper's tasks have steps of 10 ms, two physics steps of 5 ms each (docs/tasks.md).
#[test]
fn worlds_know_their_task_and_time_steps() {
    let env = Env::make("reach").unwrap();
    let known = (env.task().unwrap(), env.frame_skip().unwrap(), env.timestep().unwrap());
    assert_eq!(known, ("reach".to_string(), 2, 0.005));
    let mut config = EnvConfig::new().unwrap();
    config.frame_skip(3);
    let mut env = ball(&config);
    assert_eq!((env.task().unwrap().as_str(), env.frame_skip()), ("none", Ok(3)));
    let mut results = env.new_results().unwrap();
    assert!(results.reward.is_empty() && results.terms.is_empty());
    env.step_into(&[], None, &mut results).unwrap();
    assert!((env.time().unwrap() - 0.015).abs() < 1e-15);
}

/// Semi-implicit Euler with h = 5 ms: after n steps a ball has fallen by g h^2 n (n + 1) / 2.
#[test]
fn bare_physics_steps_are_counted() {
    let mut env = ball(&EnvConfig::new().unwrap());
    let joint = env.find(Kind::JOINT, "ball").unwrap();
    env.physics_step(7).unwrap();
    env.physics_step(0).unwrap();
    let height = env.get(Quantity::JOINT_POSITION, &[joint]).unwrap()[2];
    assert!((height - (2.0 - 9.81 * 0.005 * 0.005 * 28.0)).abs() < 1e-12, "{}", height);
    assert_eq!(env.physics_step(1_000_001).unwrap_err().status(), Status::INVALID_ARGUMENT);
}

/// A ball without gravity does not move; unknown flags are an error.
#[test]
fn parts_of_physics_can_be_disabled() {
    let mut config = EnvConfig::new().unwrap();
    config.disable(Disable::GRAVITY);
    let mut env = ball(&config);
    env.physics_step(20).unwrap();
    let joint = env.find(Kind::JOINT, "ball").unwrap();
    assert_eq!(env.get(Quantity::JOINT_POSITION, &[joint]).unwrap()[2], 2.0);
    config.disable(Disable::from_raw(0x80));
    let refused = Env::new(&Scene::empty().unwrap(), &config).err().unwrap();
    assert!(
        refused.status() == Status::UNSUPPORTED && refused.to_string().contains("disable"),
        "{}",
        refused
    );
}

/// The distance of reach is that between the right fingers and the ball, and the reward is the sum of
/// all terms (docs/tasks.md).
#[test]
fn rewards_are_sums_of_terms() {
    let mut env = Env::make("reach").unwrap();
    env.reset(Reset::new().seed(3), None).unwrap();
    let mut results = env.new_results().unwrap();
    env.step_into(&[], None, &mut results).unwrap();
    let terms = env.layout().unwrap().terms().unwrap();
    assert_eq!(terms.iter().map(|term| term.name.as_str()).collect::<Vec<_>>(), ["distance", "success"]);
    assert_eq!(results.terms.iter().sum::<f64>(), results.reward[0]);
    let ids = ["right_fingers", "target"].map(|name| env.find(Kind::BODY, name).unwrap());
    let at = env.get(Quantity::BODY_POSITION, &ids).unwrap();
    let distance = (0..3).map(|i| (at[i] - at[3 + i]).powi(2)).sum::<f64>().sqrt();
    assert!((results.terms[0] + distance).abs() < 1e-12 && distance > 0.1, "{:?} {}", results, distance);
}

#[test]
fn timing_counts_the_parts_of_steps() {
    let mut scene = Scene::builtin("reach").unwrap();
    scene.add_agents(None).unwrap();
    let mut config = EnvConfig::new().unwrap();
    let mut silent = Env::new(&scene, &config).unwrap();
    let mut env = Env::new(&scene, config.timing(true)).unwrap();
    let mut block = env.new_block().unwrap();
    for _ in 0..3 {
        env.step(&[], Some(&mut block)).unwrap();
        silent.step(&[], Some(&mut block)).unwrap();
    }
    let spent = env.timing().unwrap();
    let parts = spent.physics + spent.proprioception;
    assert!(spent.steps == 3 && Duration::ZERO < spent.physics && parts < spent.total, "{:?}", spent);
    assert!(spent.proprioception > Duration::ZERO, "{:?}", spent);
    assert_eq!((spent.touch, spent.vision), (Duration::ZERO, Duration::ZERO)); // reach has neither
    env.reset_timing().unwrap();
    for timing in [env.timing().unwrap(), silent.timing().unwrap()] {
        assert!(timing.steps == 0 && timing.total.is_zero() && timing.physics.is_zero(), "{:?}", timing);
    }
}

/// A pinhole camera with a field of view of 90 degrees and 480 rows: a point as far to the side as it is
/// away lies at the edge, 240 pixels from the middle.
#[test]
fn project_matches_a_pinhole_camera() {
    let env = ball(&EnvConfig::new().unwrap());
    let mut ahead = PictureConfig::new(640, 480).unwrap();
    ahead.free([0.0, 0.0, 1.0], 2.0, 90.0, 0.0).fovy(90.0); // looks along +y: right is +x
    let seen = env.project(&ahead, &[[0.0, 0.0, 1.0], [0.5, 0.0, 1.25], [0.0, -3.0, 1.0]]).unwrap();
    let near = |one: [f64; 3], other: [f64; 3]| (0..3).all(|i| (one[i] - other[i]).abs() < 1e-9);
    assert!(near(seen[0], [320.0, 240.0, 2.0]), "{:?}", seen);
    assert!(near(seen[1], [320.0 + 240.0 * 0.25, 240.0 - 240.0 * 0.125, 2.0]), "{:?}", seen);
    assert!(seen[2][2] < 0.0, "{:?}", seen); // behind the camera
    assert_eq!(env.project(&ahead, &[]), Ok(vec![]));
    let third = ahead.camera("eye_third").unwrap();
    assert_eq!(env.project(third, &[[0.0; 3]]).unwrap_err().status(), Status::NOT_FOUND);
}

/// There are never more threads than worlds; the default is at most the number of cores.
#[test]
fn batches_know_their_size() {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(&ObjectConfig::new("ball").unwrap()).unwrap();
    let size = |worlds, threads| {
        let mut config = BatchConfig::new(worlds).unwrap();
        let batch = Batch::new(&scene, &EnvConfig::new().unwrap(), config.threads(threads)).unwrap();
        (batch.worlds(), batch.threads())
    };
    assert_eq!((size(5, 2), size(2, 8)), ((5, 2), (2, 2)));
    let cores = std::thread::available_parallelism().unwrap().get();
    assert!((1..=cores.max(1)).contains(&size(3, 0).1));
}

/// Worlds accept all listed names; the success of reach is worth 100, as in the paper.
#[test]
fn tasks_and_parameters_are_listed() {
    let tasks = mimo::tasks();
    for task in
        ["none", "reach", "standup", "selfbody", "catch", "rollover", "selftouch", "handregard", "behaviour"]
    {
        assert!(tasks.contains(&task.to_string()), "{:?}", tasks);
    }
    let mut scene = Scene::builtin("reach").unwrap();
    let all = mimo::parameters().unwrap();
    for one in &all {
        let (task, _) = one.name.split_once('/').unwrap();
        assert!(tasks.contains(&task.to_string()), "{}", one.name);
        assert!(one.low <= one.standard && one.standard <= one.high && !one.description.is_empty());
        assert_eq!(scene.parameter(&one.name), Ok(one.standard));
        scene.set_parameter(&one.name, one.low).unwrap();
        assert_eq!(scene.parameter(&one.name), Ok(one.low));
        assert!(scene.set_parameter(&one.name, one.low - 1.0).is_err());
        scene.set_parameter(&one.name, one.high).unwrap();
        assert!(scene.set_parameter(&one.name, one.high + 1.0).is_err());
    }
    let success = all.iter().find(|one| one.name == "reach/success_reward").unwrap();
    assert_eq!(success.standard, 100.0);
}

/// Holding an infant still takes its weight, at the third degree of freedom of its free joint.
#[test]
fn follow_returns_the_forces_of_a_movement() {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = scene.default_agent().unwrap();
    scene.add_agent(agent.vision(Vision::empty()).touch(Touch::empty())).unwrap();
    let mut env = Env::new(&scene, EnvConfig::new().unwrap().frame_skip(1)).unwrap();
    let still = env.get_all(Quantity::JOINT_POSITION).unwrap();
    let mut block = env.new_block().unwrap();
    env.follow(&still, None).unwrap();
    let forces = env.follow(&still, Some(&mut block)).unwrap();
    let mass = env.agent(0).unwrap().mass;
    assert!((forces[2] - 9.81 * mass).abs() < 1e-6, "{}", forces[2]);
    let error = env.follow(&still[1..], None).unwrap_err();
    assert!(
        error.status() == Status::INVALID_ARGUMENT && error.message().contains("position_count"),
        "{}",
        error
    );
}

/// WHO's window of sitting without support: 3.8 to 9.2 months, for ten seconds.
#[test]
fn behaviours_say_what_they_measure() {
    let sit = Scene::builtin("sit").unwrap().behaviour().unwrap();
    assert_eq!(
        (sit.measure.as_str(), sit.unit.as_str(), sit.hold_seconds),
        ("tilt upper_body z", "deg", 10.0)
    );
    assert_eq!((sit.norm_early, sit.norm_late), (3.8, 9.2));
    let error = Scene::builtin("reach").unwrap().behaviour().unwrap_err();
    assert_eq!(error.status(), Status::NOT_FOUND);
}

/// The same episode has the same movements.
#[test]
fn infants_move_by_themselves() {
    let mut scene = Scene::builtin("rollover").unwrap();
    let mut agent = scene.default_agent().unwrap();
    scene.add_agent(agent.touch(Touch::empty())).unwrap();
    let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let mut courses = Vec::new();
    for _ in 0..2 {
        let mut actions = vec![0.0f32; env.agent(0).unwrap().actions.len()];
        env.reset(Reset::new().seed(1), None).unwrap();
        env.spontaneous(0, Movement::ALL, &mut actions).unwrap();
        courses.push(actions);
    }
    assert!(courses[0].iter().any(|&action| action != 0.0));
    assert_eq!(courses[0], courses[1]);
}
