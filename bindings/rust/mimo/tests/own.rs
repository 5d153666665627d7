//! Own tasks, scenes, limits, locks, gravity.
use mimo::{
    Act, AgentConfig, Batch, BatchConfig, BatchReset, Env, EnvConfig, Error, Kind, Moment, Outcome, Place,
    Quantity, Reset, Result, Scene, Status, Task, TaskField, Touch, Verdict, Vestibular, Vision, World,
};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

/// Counts its steps in its memory, and ends the episode with success at the third.
struct Counter {
    dropped: Arc<AtomicUsize>,
}

impl Drop for Counter {
    fn drop(&mut self) {
        self.dropped.fetch_add(1, Ordering::SeqCst);
    }
}

impl Task for Counter {
    fn memory(&self) -> usize {
        2
    }

    fn reset(&self, world: &mut World, moment: &mut Moment) -> Result<()> {
        assert_eq!(moment.memory, [0.0, 0.0]);
        world.random(&mut moment.memory[1..])?;
        let joint = world.find(Kind::JOINT, "robot:left_elbow")?;
        world.set(Quantity::JOINT_POSITION, &[joint], &[-0.5 - 0.1 * moment.world as f64])
    }

    fn evaluate(&self, world: &mut World, moment: &mut Moment, verdict: &mut Verdict) -> Result<()> {
        assert!(world.time()? > 0.0 && moment.agent == 0 && moment.memory[1] > 0.0);
        assert!(moment.fields.is_empty() && moment.action.is_none() && moment.block.is_none());
        moment.memory[0] += 1.0;
        assert_eq!(moment.step as f64, moment.memory[0]);
        verdict.reward = moment.memory[0];
        if moment.memory[0] == 3.0 {
            verdict.outcome = Outcome::SUCCESS;
        }
        Ok(())
    }
}

fn scene(task: impl Task + 'static) -> Scene {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty());
    scene.add_agent(&agent).unwrap();
    scene.set_task(task).unwrap();
    scene
}

#[test]
fn own_task_rewards_and_ends_episodes() {
    let dropped = Arc::new(AtomicUsize::new(0));
    let scene = scene(Counter { dropped: dropped.clone() });
    let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let mut config = BatchConfig::new(2).unwrap();
    config.threads(2);
    let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &config).unwrap();
    drop(scene);
    env.reset(Reset::new().seed(1), None).unwrap();
    env.step(&[], None).unwrap();
    let mut twin = env.try_clone().unwrap();
    drop(env);
    assert_eq!(dropped.load(Ordering::SeqCst), 0);
    let step = twin.step(&[], None).unwrap();
    assert_eq!((step.reward, step.terminated), (2.0, false));
    let step = twin.step(&[], None).unwrap();
    assert_eq!((step.reward, step.terminated, step.outcome), (3.0, true, Outcome::SUCCESS));

    batch.reset(BatchReset::new().seeds(&[1, 2]), None).unwrap();
    let joint = batch.world(0).unwrap().find(Kind::JOINT, "robot:left_elbow").unwrap();
    let mut angles = [0.0; 2];
    batch.get_into(Quantity::JOINT_POSITION, &[joint], &mut angles).unwrap();
    assert_eq!(angles, [-0.5, -0.6]);
    let mut results = batch.new_results().unwrap();
    let meanwhile = batch.step_while(&[], None, &mut results, || 41 + 1).unwrap();
    assert_eq!((meanwhile, results.reward.as_slice()), (42, &[1.0, 1.0][..]));
    drop((twin, batch));
    assert_eq!(dropped.load(Ordering::SeqCst), 1);
}

/// A room, a cup in it, and a handle that is fastened to the cup.
#[test]
fn scenes_take_rooms_models_and_welds() {
    const CUP: &str = "<mujoco><worldbody><body><geom name='side' size='.03'/></body></worldbody></mujoco>";
    assert!(mimo::rooms().contains(&"playroom".to_string()));
    let mut scene = Scene::empty().unwrap();
    scene.set_room("playroom").unwrap();
    assert!(scene.set_room("playroom").is_err());
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty());
    assert_eq!(scene.add_agents(Some(&agent)), Ok(1));
    let mut cup = mimo::ModelConfig::xml("cup", CUP).unwrap();
    scene.add_model(cup.position([1.0, 0.5, 0.5])).unwrap();
    scene.weld("cup", None, None).unwrap();
    scene.lock("robot:left_elbow", -0.5).unwrap();
    scene.set_pose("robot:right_elbow", -0.7).unwrap();
    let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    env.reset(Reset::new().seed(1), None).unwrap();
    let joints = ["robot:left_elbow", "robot:right_elbow"].map(|name| env.find(Kind::JOINT, name).unwrap());
    assert_eq!(env.get(Quantity::JOINT_POSITION, &joints).unwrap(), [-0.5, -0.7]);
    assert_eq!(env.locked(joints[0]).unwrap(), Some(-0.5));
    assert_eq!(
        env.body_of(Kind::GEOM, env.find(Kind::GEOM, "cup/side").unwrap()),
        env.find(Kind::BODY, "cup")
    );
    for _ in 0..50 {
        env.step(&[], None).unwrap();
    }
    let cup = env.find(Kind::BODY, "cup").unwrap();
    assert!(env.get(Quantity::BODY_POSITION, &[cup]).unwrap()[2] > 0.45); // it would be on the floor otherwise
}

/// Skin of 33.0 degrees after 1 s on 10 degrees: two half-spaces in contact (J Appl Physiol 1957;11:211
/// has the effusivity of skin) through 350 W/(m^2 K) give 28.21 degrees on copper and 30.26 on hardwood.
#[test]
fn metal_feels_colder_than_wood() {
    const TABLE: &str = "<mujoco><option timestep='.005'/><worldbody><body name='table'><geom type='box' size='1 1 .1'
        pos='0 0 -.1'/></body><body name='arm' pos='0 0 .0999'><freejoint/><geom size='.1'/></body></worldbody></mujoco>";
    let felt = |material: &str| {
        let mut scene = Scene::xml(TABLE).unwrap();
        let mut agent = AgentConfig::new().unwrap();
        agent
            .body("scene")
            .unwrap()
            .root("arm")
            .unwrap()
            .vision(Vision::empty())
            .vestibular(Vestibular::empty())
            .touch(Touch::TEMPERATURE);
        scene.add_agent(&agent).unwrap();
        scene.set_touch(0, "arm", 0.05).unwrap();
        scene.set_temperature("table", 10.0).unwrap();
        scene.set_material("table", material).unwrap();
        let mut env = Env::new(&scene, EnvConfig::new().unwrap().frame_skip(1)).unwrap();
        let mut block = env.new_block().unwrap();
        env.reset(Reset::new().seed(1), None).unwrap();
        for _ in 0..200 {
            env.step(&[], Some(&mut block)).unwrap();
        }
        let skin = block.f32("touch/temperature").unwrap();
        skin.iter().fold(f32::INFINITY, |least, &one| least.min(one))
    };
    assert!((felt("copper") - 28.21).abs() < 0.1);
    assert!((felt("hardwood") - 30.26).abs() < 0.1);
    assert!(mimo::materials().contains(&"cork".to_string()));
    let mut scene = Scene::xml(TABLE).unwrap();
    assert!(scene.set_material("table", "kryptonite").unwrap_err().to_string().contains("copper"));
    assert!(scene.set_temperature("table", -274.0).unwrap_err().to_string().contains("-274"));
    assert!(scene.set_room_temperature(81.0).is_err());
    scene.set_room_temperature(20.0).unwrap();
}

/// A perfect sense with twice the gain, and two steps late.
#[test]
fn senses_have_limits() {
    let build = |limits: Option<mimo::Limits>| {
        let mut scene = Scene::builtin("reach").unwrap();
        let agent = scene.default_agent().unwrap();
        scene.add_agent(&agent).unwrap();
        if let Some(limits) = limits {
            scene.limit_sense(0, "proprioception/velocity", &limits).unwrap();
        }
        scene.read_joint(0, "robot:right_elbow").unwrap();
        let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
        let mut block = env.new_block().unwrap();
        env.reset(Reset::new().seed(1), Some(&mut block)).unwrap();
        let speed = |block: &mimo::Block| block.f32("proprioception/velocity").unwrap().to_vec();
        let mut seen = vec![speed(&block)];
        for _ in 0..4 {
            env.step(&[], Some(&mut block)).unwrap();
            seen.push(speed(&block));
        }
        seen
    };
    let plain = build(None);
    assert_eq!(plain[0].len(), 1);
    let twice = build(Some(mimo::Limits { gain: 2.0, delay: 0.02, ..mimo::Limits::new().unwrap() }));
    assert_eq!(twice[4][0], 2.0 * plain[2][0]);
    assert_ne!(plain[2], plain[4]);
    let shaky = build(Some(mimo::Limits { signal_noise: 0.1, ..mimo::Limits::new().unwrap() }));
    assert_ne!(shaky[4], plain[4]);
    assert!((shaky[4][0] / plain[4][0] - 1.0).abs() < 0.6);
    let error =
        Scene::builtin("reach").unwrap().limit_sense(0, "touch", &mimo::Limits::new().unwrap()).unwrap_err();
    assert_eq!(error.status(), Status::INVALID_ARGUMENT);
}

/// Motors get half of each action, two steps late; the report of a load names the memories that the
/// state lacked.
#[test]
fn motors_have_limits() {
    let build = |limits: Option<mimo::Limits>| {
        let mut scene = Scene::builtin("benchmark").unwrap();
        let agent = scene.default_agent().unwrap();
        scene.add_agent(&agent).unwrap();
        if let Some(limits) = limits {
            scene.limit_motor(0, "left_arm", &limits).unwrap();
        }
        let mut config = EnvConfig::new().unwrap();
        config.renderer("ray").unwrap();
        Env::new(&scene, &config).unwrap()
    };
    let mut plain = build(None);
    let mut late = build(Some(mimo::Limits { gain: 0.5, delay: 0.02, ..mimo::Limits::new().unwrap() }));
    let action = vec![0.5; late.layout().unwrap().action_count()];
    let motors = ["act:left_elbow", "act:right_elbow"].map(|name| late.find(Kind::ACTUATOR, name).unwrap());
    for expected in [[0.0, 0.5], [0.0, 0.5], [0.25, 0.5]] {
        late.step(&action, None).unwrap();
        assert_eq!(late.get(Quantity::ACTUATOR_CONTROL, &motors).unwrap(), expected);
    }
    let report = plain.load(&late.save().unwrap()).unwrap();
    assert_eq!((report.fresh, report.ignored), (vec![], vec!["agent/motor delay".to_string()]));
    let report = late.load(&plain.save().unwrap()).unwrap();
    assert_eq!((report.fresh, report.ignored), (vec!["agent/motor delay".to_string()], vec![]));
}

/// These tests do not link MuJoCo, so they test errors only; tests/capi attaches senses to a model.
#[test]
fn senses_refuse_invalid_models() {
    let mut scene = Scene::empty().unwrap();
    let mut agent = mimo::AgentConfig::new().unwrap();
    agent
        .body("scene")
        .unwrap()
        .root("world")
        .unwrap()
        .vestibular_at("head")
        .unwrap()
        .vision(Vision::empty());
    scene.add_agent(&agent).unwrap();
    let attach = |version| {
        let config = mimo::SensesConfig::new(version).unwrap();
        unsafe { mimo::Senses::attach(&scene, std::ptr::null(), &config) }
    };
    assert_eq!(attach(222).err().unwrap().status(), Status::INVALID_ARGUMENT);
    assert_eq!(attach(999).err().unwrap().status(), Status::UNSUPPORTED);
}

/// Two terms, a goal that each episode draws, a success that does not end the episode, and an end after
/// five steps.
struct Goal {
    position: mimo::Field,
}

impl Task for Goal {
    fn terms(&self) -> Vec<String> {
        vec!["near".into(), "lazy".into()]
    }

    fn fields(&self) -> Vec<TaskField> {
        let goal = TaskField { low: -1.0, high: 1.0, unit: "rad".into(), ..TaskField::new("goal", &[]) };
        vec![goal, TaskField::new("reached", &[2])]
    }

    fn reset(&self, world: &mut World, moment: &mut Moment) -> Result<()> {
        let mut share = [0.0];
        world.random(&mut share)?;
        assert_eq!((moment.step, &*moment.fields), (0, &[0.0; 3][..]));
        moment.fields[0] = share[0] as f32;
        Ok(())
    }

    fn evaluate(&self, _: &mut World, moment: &mut Moment, verdict: &mut Verdict) -> Result<()> {
        assert_eq!(verdict.terms, [0.0, 0.0]);
        let angle = moment.f32(&self.position).map(|angles| angles[0]);
        verdict.terms[0] = moment.step as f64;
        verdict.terms[1] = moment.action.map_or(0.0, |action| -f64::from(action[0]));
        moment.fields[2] = angle.unwrap_or(9.0);
        verdict.outcome = if moment.step == 2 { Outcome::SUCCESS } else { Outcome::NONE };
        verdict.goes_on = true;
        verdict.truncated = moment.step == 5;
        if moment.step == 6 {
            verdict.terms[1] = f64::NAN;
        }
        Ok(())
    }
}

/// A scene that senses a single joint, and the field that contains it.
fn one_joint() -> (Scene, mimo::Field) {
    let mut scene = scene(Broken(0));
    scene.read_joint(0, "robot:left_elbow").unwrap();
    let env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let fields = env.layout().unwrap().fields().unwrap();
    (scene, fields.into_iter().find(|field| field.name == "proprioception/position").unwrap())
}

#[test]
fn own_task_has_terms_fields_and_ends() {
    let (mut scene, position) = one_joint();
    scene.set_task(Goal { position }).unwrap();
    let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let mut block = env.new_block().unwrap();
    let goal = block.fields().iter().find(|field| field.name == "goal").unwrap().clone();
    assert_eq!(
        (goal.unit.as_str(), goal.shape.as_slice(), goal.low, goal.high),
        ("rad", &[1][..], -1.0, 1.0)
    );
    env.reset(Reset::new().seed(4), Some(&mut block)).unwrap();
    let drawn = block.f32("goal").unwrap()[0];
    assert!(drawn > 0.0);
    let mut action = vec![0.0; env.layout().unwrap().action_count()];
    action[0] = -7.0; // the least is -1
    let named = env.layout().unwrap().terms().unwrap();
    assert_eq!(named.iter().map(|term| term.name.as_str()).collect::<Vec<_>>(), ["near", "lazy"]);
    let mut results = env.new_results().unwrap();
    for number in 1..=5 {
        env.step_into(&action, Some(&mut block), &mut results).unwrap();
        assert_eq!(results.reward, [f64::from(number) + 1.0]);
        assert_eq!((results.terminated[0], results.truncated[0]), (false, number == 5));
        assert_eq!(results.outcome, [if number == 2 { Outcome::SUCCESS } else { Outcome::NONE }]);
        assert_eq!(results.terms, [f64::from(number), 1.0]);
        assert_eq!(block.f32("goal").unwrap(), [drawn]);
        let angle = block.f32("proprioception/position").unwrap()[0];
        assert_eq!(block.f32("reached").unwrap(), [0.0, angle]);
    }
    let error = env.step(&[], None).unwrap_err();
    assert!(error.message().contains("agent 0 the term \"lazy\" as nan"), "{}", error);

    let mut config = BatchConfig::new(4).unwrap();
    config.threads(2);
    let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &config).unwrap();
    batch.reset(BatchReset::new().seeds(&[4, 5, 6, 7]), None).unwrap();
    let mut results = batch.new_results().unwrap();
    for number in 1..=5 {
        batch.step(&[], None, &mut results).unwrap();
        assert_eq!(results.reward, [f64::from(number); 4]);
        assert_eq!(results.terms, [f64::from(number), 0.0].repeat(4));
        let outcome = if number == 2 { Outcome::SUCCESS } else { Outcome::NONE };
        assert_eq!((results.outcome.as_slice(), results.truncated[3]), (&[outcome; 4][..], number == 5));
    }
}

/// The first agent gets 1 point, the second 2.
struct Points;

impl Task for Points {
    fn evaluate(&self, _: &mut World, moment: &mut Moment, verdict: &mut Verdict) -> Result<()> {
        verdict.reward = moment.agent as f64 + 1.0;
        verdict.outcome = [Outcome::FAILURE, Outcome::NONE][moment.agent];
        Ok(())
    }
}

#[test]
fn each_infant_has_its_own_results() {
    let mut scene = Scene::builtin("free").unwrap();
    for (name, y) in [("anna", 0.5), ("ben", -0.5)] {
        let mut agent = mimo::AgentConfig::new().unwrap();
        agent.name(name).unwrap().vision(Vision::empty()).touch(Touch::empty());
        agent
            .place(Place::ROOT)
            .position([0.0, y, 0.5])
            .orientation([1.0, 0.0, 0.0, 0.0])
            .acts([Act::EYES, Act::LEFT_ARM][(y < 0.0) as usize]);
        scene.add_agent(&agent).unwrap();
    }
    scene.set_task(Points).unwrap();
    let mut env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let layout = env.layout().unwrap();
    assert_eq!((layout.agent_count(), layout.term_count(), layout.action_count()), (2, 2, 10)); // 6 of eyes, 4 of an arm
    let actions = layout.actions().unwrap();
    let (anna, ben) = (env.agent(0).unwrap(), env.agent(1).unwrap());
    assert_eq!(
        (anna.name.as_str(), anna.actions, ben.name.as_str(), ben.actions),
        ("anna", 0..6, "ben", 6..10)
    );
    assert!(actions.iter().enumerate().all(|(i, action)| action.agent == (i >= 6) as usize));
    assert!((anna.mass - 10.905).abs() < 5e-4, "{}", anna.mass); // the original's
    let terms = layout.terms().unwrap();
    assert_eq!((terms[0].agent, terms[1].agent, terms[1].name.as_str()), (0, 1, "reward"));
    let mut results = env.new_results().unwrap();
    env.step_into(&[], None, &mut results).unwrap();
    assert_eq!((results.reward.as_slice(), results.terms.as_slice()), (&[1.0, 2.0][..], &[1.0, 2.0][..]));
    assert_eq!(results.outcome, [Outcome::FAILURE, Outcome::NONE]);
    assert_eq!(results.terminated, [true, false]);
    assert!(env.step(&[], None).unwrap_err().message().contains("agent_count is 1"));
    assert_eq!(env.agent(2).unwrap_err().status(), Status::INVALID_ARGUMENT);
}

#[test]
fn invalid_task_descriptions_are_refused() {
    struct Twice;
    impl Task for Twice {
        fn terms(&self) -> Vec<String> {
            vec!["near".into(), "near".into()]
        }
        fn evaluate(&self, _: &mut World, _: &mut Moment, _: &mut Verdict) -> Result<()> {
            Ok(())
        }
    }
    let error = scene(Broken(0)).set_task(Twice).unwrap_err();
    assert_eq!(error.message(), "task: there are two terms \"near\"");
}

/// Fails or panics, depending on its number.
struct Broken(u32);

impl Task for Broken {
    fn evaluate(&self, _: &mut World, _: &mut Moment, _: &mut Verdict) -> Result<()> {
        match self.0 {
            0 => Err(Error::new(Status::UNSUPPORTED, "not today")),
            _ => panic!("dropped at the border"),
        }
    }
}

#[test]
fn a_tasks_error_or_panic_fails_the_step() {
    let says = ["returned -9 (MIMO_E_UNSUPPORTED): not today", "panicked: dropped at the border"];
    for (number, why) in (0..).zip(says) {
        let mut env = Env::new(&scene(Broken(number)), &EnvConfig::new().unwrap()).unwrap();
        let error = env.step(&[], None).unwrap_err();
        assert_eq!(error.status(), Status::TASK);
        assert!(error.message().ends_with(why), "{}", error);

        let (scene, config) = (scene(Broken(number)), BatchConfig::new(2).unwrap());
        let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &config).unwrap();
        let mut results = batch.new_results().unwrap();
        let error = batch.step(&[], None, &mut results).unwrap_err();
        assert!(error.status() == Status::TASK && error.message().ends_with(why), "{}", error);
        assert!(batch.world_error(1).unwrap().unwrap().message().ends_with(why));
    }
    let mut scene = scene(Broken(1));
    scene.clear_task().unwrap();
    Env::new(&scene, &EnvConfig::new().unwrap()).unwrap().step(&[], None).unwrap();
}

/// After a panic between send and receive the library must not write into freed arrays.
#[test]
fn a_panic_after_send_still_receives() {
    let dropped = Arc::new(AtomicUsize::new(0));
    let scene = scene(Counter { dropped });
    let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &BatchConfig::new(2).unwrap()).unwrap();
    batch.reset(BatchReset::new().seeds(&[1, 2]), None).unwrap();
    let mut results = batch.new_results().unwrap();
    let panicked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        batch.step_while(&[], None, &mut results, || panic!("meanwhile")).unwrap()
    }));
    assert!(panicked.is_err());
    assert_eq!(results.reward, [1.0, 1.0]);
    batch.step(&[], None, &mut results).unwrap();
}

#[test]
fn locks_and_gravity_belong_to_one_world() {
    let mut env = Env::make("benchmark").unwrap();
    let elbow = env.find(Kind::JOINT, "robot:left_elbow").unwrap();
    assert_eq!(env.locked(elbow).unwrap(), None);
    env.lock(elbow, -0.5).unwrap();
    env.set_gravity([0.0, 0.0, -1.6]).unwrap();
    let twin = env.try_clone().unwrap();
    assert_eq!(twin.locked(elbow).unwrap(), Some(-0.5));
    assert_eq!(twin.gravity().unwrap(), [0.0, 0.0, -1.6]);
    env.unlock(elbow).unwrap();
    assert_eq!(env.locked(elbow).unwrap(), None);
    assert_eq!(twin.locked(elbow).unwrap(), Some(-0.5));
    assert!(env.lock(elbow, 99.0).unwrap_err().message().contains("angle"));
}

const BALL: &str = r#"<mujoco><option timestep="0.005"/><worldbody><geom type="plane" size="5 5 .1"/>
    <body name="ball" pos="0 0 .3"><freejoint/><geom name="ball" size="0.1" mass="2"/></body></worldbody></mujoco>"#;

// v = F / m t, in each world of a batch with its own mass.
#[test]
fn masses_differ_between_worlds() {
    let scene = Scene::xml(BALL).unwrap();
    let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &BatchConfig::new(3).unwrap()).unwrap();
    let ball = batch.world(0).unwrap().find(Kind::BODY, "ball").unwrap();
    let masses = [0.5, 1.0, 4.0];
    batch.set(Quantity::BODY_MASS, &[ball], &masses).unwrap();
    batch.set(Quantity::WORLD_GRAVITY, &[0], &[0.0; 9]).unwrap();
    batch.set(Quantity::BODY_FORCE, &[ball], &[3.0, 0.0, 0.0, 0.0, 0.0, 0.0].repeat(3)).unwrap();
    let mut results = batch.new_results().unwrap();
    for _ in 0..10 {
        batch.step(&[], None, &mut results).unwrap();
    }
    let mut velocity = [0.0f32; 18];
    batch.get_f32_into(Quantity::BODY_VELOCITY.now(), &[ball], &mut velocity).unwrap();
    for (world, mass) in masses.iter().enumerate() {
        assert!((velocity[6 * world] as f64 - 3.0 / mass * 10.0 * 2.0 * 0.005).abs() < 1e-6);
    }
    assert!(batch.set(Quantity::BODY_MASS, &[ball], &[0.0; 3]).unwrap_err().message().contains("above 0"));
}

#[test]
fn contact_impulses_equal_the_change_of_momentum() {
    let scene = Scene::xml(BALL).unwrap();
    let mut config = EnvConfig::new().unwrap();
    config.frame_skip(20).step_contacts(true);
    let mut env = Env::new(&scene, &config).unwrap();
    let mut touched = false;
    for _ in 0..10 {
        let before = env.get(Quantity::JOINT_VELOCITY, &[0]).unwrap()[2];
        env.step(&[], None).unwrap();
        let change = 2.0 * (env.get(Quantity::JOINT_VELOCITY, &[0]).unwrap()[2] - before);
        let contacts = env.step_contacts().unwrap();
        let impulse: f64 = contacts.iter().map(|contact| contact.impulse[2]).sum();
        assert!((impulse - 2.0 * 9.81 * 0.1 - change).abs() < 1e-9);
        touched = touched || !contacts.is_empty();
    }
    assert!(touched);
    assert!(env.warnings().unwrap().iter().all(|count| *count == 0));
}
