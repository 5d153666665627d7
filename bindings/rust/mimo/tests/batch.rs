//! Many worlds do what single ones do.
use mimo::sys::{MIMO_AUTORESET_SAME_STEP, MIMO_BODY, MIMO_BODY_POSITION};
use mimo::{Batch, BatchConfig, Env, EnvConfig, Scene};

fn reach(worlds: u32, steps: u32) -> Batch {
    let mut scene = Scene::builtin("reach").unwrap();
    let agent = scene.default_agent().unwrap();
    scene.add_agent(&agent).unwrap();
    let mut env = EnvConfig::new().unwrap();
    env.max_steps(steps);
    let mut config = BatchConfig::new(worlds).unwrap();
    config.threads(2).autoreset(MIMO_AUTORESET_SAME_STEP);
    Batch::new(&scene, &env, &config).unwrap()
}

#[test]
fn worlds_equal_single_ones() {
    let mut batch = reach(3, 0);
    let mut blocks = batch.new_blocks().unwrap();
    let mut results = batch.new_results().unwrap();
    let count = batch.world(0).unwrap().action_size().unwrap();
    let actions: Vec<f32> = (0..3 * count).map(|i| (i % 7) as f32 / 7.0 - 0.4).collect();
    batch.reset(Some(&[5, 6, 7]), Some(&mut blocks)).unwrap();
    batch.step(&actions, Some(&mut blocks), &mut results).unwrap();

    let mut single = Env::make("reach").unwrap();
    let mut block = single.new_block().unwrap();
    for world in 0..3 {
        single.reset(Some(5 + world as u64), None).unwrap();
        let step = single.step(&actions[world * count..][..count], Some(&mut block)).unwrap();
        assert_eq!(blocks.world(world).as_bytes(), block.as_bytes());
        assert_eq!(results.reward[world], step.reward);
    }
}

#[test]
fn final_blocks_are_of_the_old_episode() {
    let mut batch = reach(2, 1);
    let mut blocks = batch.new_blocks().unwrap();
    let mut results = batch.new_results().unwrap();
    results.final_blocks = Some(batch.new_blocks().unwrap());
    batch.reset(Some(&[1, 2]), Some(&mut blocks)).unwrap();
    batch.step(&[], Some(&mut blocks), &mut results).unwrap();
    assert_eq!((results.truncated, results.was_reset), (vec![1, 1], vec![1, 1]));
    assert_eq!(results.final_written, [1, 1]);
    assert_ne!(results.final_blocks.unwrap().as_bytes(), blocks.as_bytes());
}

#[test]
fn quantities_of_all_worlds_and_errors() {
    let mut batch = reach(2, 0);
    batch.reset(Some(&[1, 2]), None).unwrap();
    let head = batch.world(1).unwrap().find(MIMO_BODY, "head").unwrap();
    let mut places = [0.0; 6];
    batch.get_into(MIMO_BODY_POSITION, &[head], &mut places).unwrap();
    assert_eq!(places[3..].to_vec(), batch.world(1).unwrap().get(MIMO_BODY_POSITION, &[head]).unwrap());

    let count = batch.world(0).unwrap().action_size().unwrap();
    let mut actions = vec![0.0; 2 * count];
    actions[count] = f32::NAN;
    let mut results = batch.new_results().unwrap();
    assert!(batch.step(&actions, None, &mut results).is_err());
    assert_eq!(batch.world_error(0).unwrap(), "");
    assert!(batch.world_error(1).unwrap().contains("not a number"));
    assert!(batch.world(2).is_err());
}

#[test]
fn futures_of_one_present_and_masks() {
    let mut batch = reach(3, 0);
    let (mut first, mut second) = (batch.new_blocks().unwrap(), batch.new_blocks().unwrap());
    let mut results = batch.new_results().unwrap();
    let count = batch.world(0).unwrap().action_size().unwrap();
    let actions = vec![0.3; 3 * count];
    batch.reset(Some(&[5, 6, 7]), None).unwrap();
    let states = batch.save().unwrap();
    batch.step(&actions, Some(&mut first), &mut results).unwrap();
    batch.load(&states, None).unwrap();
    batch.step(&actions, Some(&mut second), &mut results).unwrap();
    assert_eq!(first.as_bytes(), second.as_bytes());

    // The present of world 1 in worlds 0 and 1; world 2 goes on by itself.
    batch.load(&states, None).unwrap();
    let one = states.len() / 3;
    batch.load(&states[one..2 * one], Some(&[true, true, false])).unwrap();
    batch.step(&actions, Some(&mut second), &mut results).unwrap();
    assert_eq!(second.world(0).as_bytes(), first.world(1).as_bytes());
    assert_eq!(second.world(2).as_bytes(), first.world(2).as_bytes());
    assert!(batch.load(&states, Some(&[true])).is_err());

    let before = second.clone();
    batch.reset_where(&[false, true, false], Some(&mut second)).unwrap();
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
