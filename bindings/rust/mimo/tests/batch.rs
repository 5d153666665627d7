//! Batches.
use mimo::{Autoreset, Batch, BatchConfig, BatchReset, Env, EnvConfig, Kind, Quantity, Reset, Scene, Status};

fn reach(worlds: u32, steps: u32) -> Batch {
    let mut scene = Scene::builtin("reach").unwrap();
    let agent = scene.default_agent().unwrap();
    scene.add_agent(&agent).unwrap();
    let mut env = EnvConfig::new().unwrap();
    env.max_steps(steps);
    let mut config = BatchConfig::new(worlds).unwrap();
    config.threads(2).autoreset(Autoreset::SAME_STEP);
    Batch::new(&scene, &env, &config).unwrap()
}

#[test]
fn worlds_equal_single_worlds() {
    let mut batch = reach(3, 0);
    let mut blocks = batch.new_blocks().unwrap();
    let mut results = batch.new_results().unwrap();
    let count = batch.layout().unwrap().action_count();
    let actions: Vec<f32> = (0..3 * count).map(|i| (i % 7) as f32 / 7.0 - 0.4).collect();
    batch.reset(BatchReset::new().seeds(&[5, 6, 7]), Some(&mut blocks)).unwrap();
    batch.step(&actions, Some(&mut blocks), &mut results).unwrap();

    let mut single = Env::make("reach").unwrap();
    let (mut block, mut step) = (single.new_block().unwrap(), single.new_results().unwrap());
    assert_eq!(batch.layout().unwrap().fields(), single.layout().unwrap().fields());
    let terms = single.layout().unwrap().term_count();
    for world in 0..3 {
        single.reset(Reset::new().seed(5 + world as u64), None).unwrap();
        single.step_into(&actions[world * count..][..count], Some(&mut block), &mut step).unwrap();
        assert_eq!(blocks.world(world).as_bytes(), block.as_bytes());
        assert_eq!(results.reward[world..=world], step.reward);
        assert_eq!(results.terms[world * terms..][..terms], step.terms);
    }
}

#[test]
fn final_blocks_belong_to_the_old_episode() {
    let mut batch = reach(2, 1);
    let mut blocks = batch.new_blocks().unwrap();
    let mut results = batch.new_results().unwrap();
    results.final_blocks = Some(batch.new_blocks().unwrap());
    batch.reset(BatchReset::new().seeds(&[1, 2]), Some(&mut blocks)).unwrap();
    batch.step(&[], Some(&mut blocks), &mut results).unwrap();
    assert_eq!((results.truncated, results.was_reset), (vec![true, true], vec![true, true]));
    assert_eq!(results.final_written, [true, true]);
    assert_ne!(results.final_blocks.unwrap().as_bytes(), blocks.as_bytes());
}

#[test]
fn quantities_are_read_in_all_worlds() {
    let mut batch = reach(2, 0);
    batch.reset(BatchReset::new().seeds(&[1, 2]), None).unwrap();
    let head = batch.world(1).unwrap().find(Kind::BODY, "head").unwrap();
    let mut places = [0.0; 6];
    batch.get_into(Quantity::BODY_POSITION, &[head], &mut places).unwrap();
    assert_eq!(places[3..].to_vec(), batch.world(1).unwrap().get(Quantity::BODY_POSITION, &[head]).unwrap());

    let count = batch.layout().unwrap().action_count();
    let mut actions = vec![0.0; 2 * count];
    actions[count] = f32::NAN;
    let mut results = batch.new_results().unwrap();
    assert!(batch.step(&actions, None, &mut results).is_err());
    assert_eq!(batch.world_error(0), Ok(None));
    let refused = batch.world_error(1).unwrap().unwrap();
    assert_eq!(refused.status(), Status::INVALID_ARGUMENT);
    assert!(refused.message().contains("not a number"));
    results.terms.pop();
    assert_eq!(batch.step(&[], None, &mut results).unwrap_err().status(), Status::BUFFER_TOO_SMALL);
    results.outcome.pop();
    let error = batch.step(&[], None, &mut results).unwrap_err();
    assert_eq!(error.message(), "arrays of the results have lengths [2, 2, 1], expected 2 each");
    assert!(batch.world(2).is_err());
}

#[test]
fn one_state_loads_into_selected_worlds() {
    let mut batch = reach(3, 0);
    let (mut first, mut second) = (batch.new_blocks().unwrap(), batch.new_blocks().unwrap());
    let mut results = batch.new_results().unwrap();
    let count = batch.layout().unwrap().action_count();
    let actions = vec![0.3; 3 * count];
    batch.reset(BatchReset::new().seeds(&[5, 6, 7]), None).unwrap();
    let states = batch.save().unwrap();
    batch.step(&actions, Some(&mut first), &mut results).unwrap();
    batch.load(&states, None).unwrap();
    batch.step(&actions, Some(&mut second), &mut results).unwrap();
    assert_eq!(first.as_bytes(), second.as_bytes());

    // Worlds 0 and 1 continue from the state of world 1; world 2 continues from its own.
    batch.load(&states, None).unwrap();
    let one = states.len() / 3;
    batch.load(&states[one..2 * one], Some(&[true, true, false])).unwrap();
    batch.step(&actions, Some(&mut second), &mut results).unwrap();
    assert_eq!(second.world(0).as_bytes(), first.world(1).as_bytes());
    assert_eq!(second.world(2).as_bytes(), first.world(2).as_bytes());
    assert!(batch.load(&states, Some(&[true])).is_err());

    let before = second.clone();
    batch.reset(BatchReset::new().mask(&[false, true, false]), Some(&mut second)).unwrap();
    assert_eq!(batch.world(1).unwrap().time().unwrap(), 0.0);
    assert!(batch.world(0).unwrap().time().unwrap() > 0.0);
    assert_eq!(second.world(0).as_bytes(), before.world(0).as_bytes());
    assert_ne!(second.world(1).as_bytes(), before.world(1).as_bytes());

    batch.set_face(0, "anger", Some(&[false, true, false])).unwrap();
    assert_eq!(batch.world(1).unwrap().face(0).unwrap(), "anger");
    assert_eq!(batch.world(0).unwrap().face(0).unwrap(), "neutral");
    let mut now = batch.new_blocks().unwrap();
    batch.observe(&mut now).unwrap();
    assert_eq!(now.world(1).as_bytes(), second.world(1).as_bytes());
}

/// All worlds have seeds, but only one is reset: it gets the random numbers of a single world with that
/// seed.
#[test]
fn reset_takes_seeds_and_a_mask() {
    let mut batch = reach(2, 0);
    let mut blocks = batch.new_blocks().unwrap();
    batch.reset(BatchReset::new(), Some(&mut blocks)).unwrap();
    let before = blocks.clone();
    batch.reset(BatchReset::new().seeds(&[8, 9]).mask(&[false, true]), Some(&mut blocks)).unwrap();
    let mut single = Env::make("reach").unwrap();
    let mut block = single.new_block().unwrap();
    single.reset(Reset::new().seed(9), Some(&mut block)).unwrap();
    assert_eq!(blocks.world(0).as_bytes(), before.world(0).as_bytes());
    assert_eq!(blocks.world(1).as_bytes(), block.as_bytes());
    let error = batch.reset(BatchReset::new().seeds(&[8, 9]).mask(&[true]), None).unwrap_err();
    assert_eq!(error.message(), "seeds, mask and ages have 2 and 1 entries, expected equal numbers");
    assert!(batch.reset(BatchReset::new().seeds(&[8]), None).is_err());
}

/// A joint at 1e200 rad/s makes MuJoCo's simulation fail.
#[test]
fn a_failed_world_stops_no_other() {
    let mut batch = reach(2, 0);
    let mut results = batch.new_results().unwrap();
    let world = batch.world(1).unwrap();
    let elbow = world.find(Kind::JOINT, "robot:left_elbow").unwrap();
    world.set(Quantity::JOINT_VELOCITY, &[elbow], &[1e200]).unwrap();
    assert_eq!(batch.step(&[], None, &mut results).unwrap_err().status(), Status::SIMULATION);
    assert_eq!(results.status, [Status::OK, Status::SIMULATION]);
    assert_eq!(format!("{:?} {}", results.status, results.status[1]), "[OK, SIMULATION] MIMO_E_SIMULATION");
    assert_eq!(batch.world_error(1).unwrap().unwrap().status(), Status::SIMULATION);
}
