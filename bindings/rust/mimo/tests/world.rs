//! Single worlds, scenes, messages.
use mimo::sys::*;
use mimo::{
    Act, AgentConfig, Batch, BatchConfig, Env, EnvConfig, Growth, Kind, LogLevel, LogRecord, ObjectConfig,
    Place, Quantity, Reset, Scene, SceneConfig, Sex, Status, Touch, Vestibular, Vision, WarningCode,
};
use std::sync::{Arc, Mutex};

/// An empty world with one ball at a height of 2 m, whose fall can be calculated.
fn ball() -> Env {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(ObjectConfig::new("ball").unwrap().position([0.0, 0.0, 2.0])).unwrap();
    Env::new(&scene, &EnvConfig::new().unwrap()).unwrap()
}

/// In C "" means nothing, and nothing makes an empty world; a task needs an infant, a room does not.
#[test]
fn empty_names_and_missing_infants_are_refused() {
    for made in [Scene::builtin(""), Scene::file(""), Scene::xml("")] {
        let error = made.unwrap_err();
        assert_eq!(error.status(), Status::INVALID_ARGUMENT);
        assert!(error.message().contains("is \"\", expected"), "{}", error);
    }
    let error = Env::new(&Scene::builtin("reach").unwrap(), &EnvConfig::new().unwrap()).unwrap_err();
    assert_eq!(error.status(), Status::INVALID_ARGUMENT);
    assert!(error.message().contains("mimo_scene_add_agents adds its infants"), "{}", error);
}

/// The original's infant weighs 10.905 kg; MIMo's bodies hang on mimo_location.
#[test]
fn body_weighs_as_in_the_paper() {
    assert!(mimo::builtin_scenes().contains(&"benchmark".to_string()));
    let env = Env::make("benchmark").unwrap();
    let root = env.find(Kind::BODY, "mimo_location").unwrap();
    let infant: Vec<i32> =
        (1..env.count(Kind::BODY).unwrap() as i32).filter(|&id| hangs_on(&env, id, root)).collect();
    let mass: f64 = env.get(Quantity::BODY_MASS, &infant).unwrap().iter().sum();
    assert!((mass - 10.905).abs() < 5e-4, "{}", mass);
}

fn hangs_on(env: &Env, mut body: i32, root: i32) -> bool {
    while body > 0 && body != root {
        let child = body;
        assert_eq!(unsafe { mimo_env_body_of(env.handle(), MIMO_BODY, child, &mut body) }, 0);
    }
    body == root
}

/// Semi-implicit Euler with h = 5 ms: after n steps a ball has fallen by g h^2 n (n + 1) / 2.
#[test]
fn ball_falls_as_calculated() {
    let mut env = ball();
    let id = env.find(Kind::BODY, "ball").unwrap();
    env.reset(Reset::new().seed(1), None).unwrap();
    let mut results = env.new_results().unwrap(); // nobody to be rewarded
    for _ in 0..10 {
        env.step_into(&[], None, &mut results).unwrap();
    }
    let n = (env.time().unwrap() / 0.005).round();
    assert!(n >= 10.0);
    unsafe { mimo_env_update(env.handle()) };
    let height = env.get(Quantity::BODY_POSITION, &[id]).unwrap()[2];
    let expected = 2.0 - 9.81 * 0.005 * 0.005 * n * (n + 1.0) / 2.0;
    assert!((height - expected).abs() < 1e-12, "{} {}", height, expected);
}

#[test]
fn fields_are_views_of_the_block() {
    let mut env = Env::make("benchmark").unwrap();
    let mut block = env.new_block().unwrap();
    env.reset(Reset::new().seed(7), Some(&mut block)).unwrap();
    let picture = block.u8("vision/eye_left").unwrap();
    assert_eq!(picture.len(), 256 * 256 * 3); // the default size
    assert!(block.as_bytes().as_ptr_range().contains(&picture.as_ptr()));
    assert_eq!(block.as_bytes().as_ptr() as usize % 64, 0);
    assert_eq!(block.f32("vestibular/acceleration").unwrap().len(), 3);

    let joint = env.find(Kind::JOINT, "robot:left_elbow").unwrap();
    let angle = env.get(Quantity::JOINT_POSITION, &[joint]).unwrap()[0] as f32;
    assert!(block.f32("proprioception/position").unwrap().contains(&angle));
}

#[test]
fn an_infant_stands_where_its_soles_are_put() {
    let feet = |height| {
        let mut scene = Scene::builtin("free").unwrap();
        let mut agent = scene.default_agent().unwrap();
        agent.vision(Vision::empty()).vestibular(Vestibular::ACCELERATION);
        agent.place(Place::SOLES).position([0.5, 0.0, height]).orientation([1.0, 0.0, 0.0, 0.0]);
        scene.add_agent(&agent).unwrap();
        let env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
        let ids = [env.find(Kind::BODY, "left_foot").unwrap(), env.find(Kind::BODY, "right_foot").unwrap()];
        env.get(Quantity::BODY_POSITION, &ids).unwrap()
    };
    let (low, high) = (feet(0.2), feet(0.7));
    assert!(((low[0] + low[3]) / 2.0 - 0.5).abs() < 1e-12 && ((low[1] + low[4]) / 2.0).abs() < 1e-12);
    assert!((high[2] - low[2] - 0.5).abs() < 1e-9 && (high[5] - low[5] - 0.5).abs() < 1e-9);
}

#[test]
fn errors_carry_status_and_message() {
    let error = Env::make("benchmarc").err().unwrap();
    assert_eq!(error.status(), Status::NOT_FOUND);
    assert!(error.message().contains("\"benchmarc\"") && error.message().contains("benchmark"), "{}", error);

    let mut env = Env::make("reach").unwrap();
    let mut action = vec![0.0; env.layout().unwrap().action_count()];
    action[1] = f32::NAN;
    let error = env.step(&action, None).unwrap_err();
    assert_eq!((error.status(), error.message()), (Status::INVALID_ARGUMENT, "action[1] is not a number"));

    let block = env.new_block().unwrap();
    assert_eq!(block.f32("touch/farce").unwrap_err().status(), Status::NOT_FOUND);
    let name = block.fields()[0].name.clone();
    assert!(block.u8(&name).unwrap_err().message().contains("F32"));
    assert_eq!(Scene::builtin("a\0b").err().unwrap().status(), Status::INVALID_ARGUMENT);
}

#[test]
fn block_of_another_world_is_refused() {
    let mut small = Env::make("reach").unwrap();
    let mut block = small.new_block().unwrap();
    small.reset(Reset::new().seed(1), Some(&mut block)).unwrap();
    let before = block.as_bytes().to_vec();
    let error = Env::make("benchmark").unwrap().reset(Reset::new().seed(1), Some(&mut block)).unwrap_err();
    assert_eq!(error.status(), Status::BUFFER_TOO_SMALL);
    assert_eq!(before, block.as_bytes());
}

#[test]
fn saved_states_continue_bit_for_bit() {
    let mut env = Env::make("reach").unwrap();
    let (mut first, mut second) = (env.new_block().unwrap(), env.new_block().unwrap());
    let action = vec![0.5; env.layout().unwrap().action_count()];
    env.reset(Reset::new().seed(3), None).unwrap();
    env.step(&action, None).unwrap();
    let state = env.save().unwrap();
    let mut clone = env.try_clone().unwrap();
    env.step(&action, Some(&mut first)).unwrap();
    clone.step(&action, Some(&mut second)).unwrap();
    assert_eq!(first.as_bytes(), second.as_bytes());
    env.load(&state).unwrap();
    env.step(&action, Some(&mut second)).unwrap();
    assert_eq!(first.as_bytes(), second.as_bytes());
}

// A median girl of 6 months weighs 7.297 kg, the mean infant of 18 months 10.585: WHO Child Growth Standards, 2006. Ours of
// 18 months weighs 10.905 kg.
#[test]
fn infants_have_any_age() {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = AgentConfig::new().unwrap();
    agent.vision(Vision::empty()).growth(Growth::of_age(24.5).unwrap());
    assert!(scene.add_agent(&agent).unwrap_err().to_string().contains("age is 24.5"));
    let mut girl = Growth::of_age(6.0).unwrap();
    girl.sex(Sex::FEMALE);
    agent.growth(girl);
    scene.add_agent(&agent).unwrap();
    let env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    assert!((env.agent(0).unwrap().mass - 7.297 / 10.585 * 10.905).abs() < 0.04);
}

#[test]
fn agent_config_reaches_the_world() {
    let mut scene = Scene::builtin("benchmark").unwrap();
    let mut agent = AgentConfig::new().unwrap();
    agent.name("anna").unwrap().vision(Vision::DEPTH).vision_width(32).vision_height(16).acts(Act::RIGHT_ARM);
    assert_eq!(scene.add_agent(&agent), Ok(0));
    scene.set_parameter("reach/success_reward", 5.0).unwrap();
    assert_eq!(scene.parameter("reach/success_reward"), Ok(5.0));
    assert!(scene.to_xml().unwrap().starts_with('<'));
    let folder = std::env::temp_dir().join(format!("mimo_rust_scene_{}", std::process::id()));
    scene.save(folder.to_str().unwrap()).unwrap();
    assert!(folder.join("scene.xml").exists());
    std::fs::remove_dir_all(&folder).unwrap();
    let env = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    assert_eq!(env.layout().unwrap().action_count(), 4); // shoulder (three) and elbow
    assert_eq!(env.new_block().unwrap().f32("anna/vision/eye_left_depth").unwrap().len(), 32 * 16);
}

/// Messages: level, code, text, world, time.
type Heard = Arc<Mutex<Vec<(LogLevel, Option<WarningCode>, String, Option<usize>, f64)>>>;

/// A panic in the callback must not unwind through the library.
fn listener(heard: &Heard) -> impl Fn(&LogRecord) + Send + Sync + 'static {
    let heard = heard.clone();
    move |record| {
        if let Ok(mut heard) = heard.lock() {
            heard.push((record.level, record.code, record.text.to_string(), record.world, record.time));
        }
        panic!("dropped at the border");
    }
}

#[test]
fn messages_have_code_world_and_time() {
    let heard = Heard::default();
    let mut config = EnvConfig::new().unwrap();
    config.log(listener(&heard));
    let scene = Scene::xml(CROWDED).unwrap();
    let mut env = Env::new(&scene, &config).unwrap();
    let mut results = env.new_results().unwrap();
    env.step_into(&[], None, &mut results).unwrap();
    let heard = heard.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let (level, code, text, world, time) = heard.first().unwrap();
    assert_eq!(
        (*level, *code, *world),
        (LogLevel::WARNING, Some(WarningCode::CONTACTS_DROPPED), Some(0)),
        "{}",
        text
    );
    assert!((0.0..=env.time().unwrap()).contains(time) && !text.is_empty());
    assert!(env.warnings().unwrap()[WarningCode::CONTACTS_DROPPED.raw() as usize] > 0);
}

#[test]
fn messages_of_a_batch_name_their_worlds() {
    let heard = Heard::default();
    let mut config = EnvConfig::new().unwrap();
    config.log(listener(&heard));
    let scene = Scene::xml(CROWDED).unwrap();
    let mut batch = Batch::new(&scene, &config, &BatchConfig::new(2).unwrap()).unwrap();
    let mut results = batch.new_results().unwrap();
    batch.step(&[], None, &mut results).unwrap();
    let heard = heard.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    for world in 0..2 {
        assert!(heard.iter().any(|record| record.3 == Some(world)), "{:?}", heard);
    }
}

/// An infant that lies half a metre below the floor.
#[test]
fn scenes_warn_of_infants_below_the_floor() {
    let heard = Heard::default();
    let mut config = SceneConfig::builtin("free").unwrap();
    let mut scene = Scene::new(config.log(listener(&heard))).unwrap();
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty());
    agent.place(Place::LOWEST).position([0.0, 0.0, -0.5]).orientation([1.0, 0.0, 0.0, 0.0]);
    scene.add_agent(&agent).unwrap();
    Env::new(&scene, &EnvConfig::new().unwrap()).unwrap();
    let heard = heard.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let (level, code, text, world, time) = heard.first().unwrap();
    assert_eq!((*level, *code, *world, *time), (LogLevel::WARNING, None, None, 0.0), "{}", text);
}

/// Three elements in the world, two are allowed.
#[test]
fn documents_are_limited() {
    let mut config = SceneConfig::xml(CROWDED).unwrap();
    let make = |config: &SceneConfig| Env::new(&Scene::new(config).unwrap(), &EnvConfig::new().unwrap());
    assert!(make(&config).is_ok());
    config.max_elements(2);
    assert_eq!(make(&config).unwrap_err().status(), Status::MODEL);
}

#[test]
fn versions_and_supported_names_are_told() {
    assert_eq!((mimo::abi_version(), mimo::api_version()), (MIMO_ABI_VERSION, MIMO_API_VERSION));
    for known in ["mimo_env_step", "MIMO_BODY_MASS", "mimo_field", "mimo_field.period"] {
        assert!(mimo::supports(known), "{}", known);
    }
    for unknown in ["mimo_env_stop", "MIMO_BODY_MAS", "mimo_field.time", "", "mimo_\0field"] {
        assert!(!mimo::supports(unknown), "{}", unknown);
    }
    let error = Env::make("reach").unwrap().get(Quantity::from_raw(9999), &[0]).unwrap_err();
    assert_eq!(error.status(), Status::UNSUPPORTED);
}

/// Two boxes on each other with room for a single contact: MuJoCo warns.
const CROWDED: &str = r#"<mujoco><size nconmax="1"/><worldbody>
  <geom type="plane" size="1 1 1"/>
  <body pos="0 0 0.05"><freejoint/><geom type="box" size="0.1 0.1 0.1"/></body>
</worldbody></mujoco>"#;

#[test]
fn handles_move_between_threads() {
    fn needs<T: Send + Sync>() {}
    needs::<Scene>();
    needs::<Env>();
    needs::<mimo::Batch>();
    needs::<mimo::Block>();
    let env = Env::make("reach").unwrap();
    let count = env.layout().unwrap().action_count();
    let env = std::thread::spawn(move || {
        let mut env = env;
        env.step(&vec![0.0; count], None).unwrap();
        env
    })
    .join()
    .unwrap();
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| assert!(env.time().unwrap() > 0.0));
        }
    });
}

/// `{:?}` of objects with megabytes prints a summary.
#[test]
fn large_objects_print_a_summary() {
    let env = Env::make("benchmark").unwrap();
    let block = env.new_block().unwrap();
    let said = format!("{:?} {:?}", block, block.world(0));
    assert!(said.contains("\"proprioception/position\"") && said.len() < block.as_bytes().len() / 10);
    assert!(format!("{:?}", *env).starts_with("World { handle: 0x"));
    let mut config = EnvConfig::new().unwrap();
    config.log(|_| ());
    assert!(format!("{:?} {:?}", env, config).contains("log: Some(Log)"));
}
