//! Observations: the layout, times of fields, fields on request.
use mimo::{
    Env, EnvConfig, FieldConfig, FieldType, Growth, Kind, Layout, Limits, Mature, Maturity, ObjectConfig,
    Quantity, Reset, Scene, Shape, Status, Touch, Vestibular, Vision,
};

fn world(scene: &Scene) -> Env {
    Env::new(scene, &EnvConfig::new().unwrap()).unwrap()
}

fn index(layout: &Layout, name: &str) -> usize {
    let found = layout.find(name).unwrap();
    assert_eq!(layout.fields().unwrap()[found].name, name);
    found
}

#[test]
fn fields_fill_the_block_in_order() {
    let env = Env::make("benchmark").unwrap();
    let layout = env.layout().unwrap();
    let mut free = 0;
    for field in layout.fields().unwrap() {
        let size = match field.dtype {
            FieldType::U8 => 1,
            FieldType::F64 => 8,
            _ => 4,
        };
        assert_eq!(
            (field.bytes.start % 64, field.bytes.len()),
            (0, size * field.shape.iter().product::<usize>())
        );
        assert!(field.bytes.start >= free, "{:?}", field);
        free = field.bytes.end;
    }
    assert!(free <= layout.block_bytes() && layout.block_bytes() % 64 == 0);
    let error = layout.find("touch/farce").unwrap_err();
    assert_eq!(error.status(), Status::NOT_FOUND);
    assert!(error.message().contains("touch/force"), "{}", error);
    assert!(layout.field(99).is_err());
}

/// A step of reach is two physics steps of 5 ms. Joints belong to its end; the vestibular sense is a
/// sensor of MuJoCo and belongs to the start of the last physics step (docs/guide/time-and-frames.md).
#[test]
fn fields_state_their_time() {
    let times = |limits: &Limits| {
        let mut scene = Scene::builtin("reach").unwrap();
        let mut agent = scene.default_agent().unwrap();
        scene.add_agent(agent.vestibular(Vestibular::ACCELERATION)).unwrap();
        scene.limit_sense(0, "proprioception/position", limits).unwrap();
        scene.limit_sense(0, "vestibular", limits).unwrap();
        let env = world(&scene);
        let layout = env.layout().unwrap();
        ["proprioception/position", "vestibular/acceleration"].map(|name| {
            let field = layout.field(index(&layout, name)).unwrap();
            assert_eq!(field.period, 0.01);
            (field.start, field.end)
        })
    };
    assert_eq!(times(&Limits::new().unwrap()), [(0.0, 0.0), (-0.005, -0.005)]);
    let late = times(&Limits { delay: 0.03, ..Limits::new().unwrap() });
    for ((start, end), expected) in late.into_iter().zip([-0.03, -0.035]) {
        assert!((start - expected).abs() < 1e-12 && (end - expected).abs() < 1e-12, "{} {}", start, end);
    }
}

/// The delay is the time in the nerve of the part that a joint moves and in the brain, rounded to time
/// steps of 5 ms.
#[test]
fn nerve_delays_follow_the_age() {
    let newborn = Maturity::of_age(0.0).unwrap();
    assert_eq!((newborn.acuity, newborn.chroma), (0.70, 0.0));
    assert_eq!(Maturity::of_age(24.0).unwrap().acuity, 11.1);
    assert!(Maturity::of_age(25.0).unwrap_err().message().contains("age is 25"));
    let build = |mature: Mature, maturity: Option<&Maturity>| {
        let mut scene = Scene::builtin("free").unwrap();
        let mut agent = scene.default_agent().unwrap();
        let mut growth = Growth::of_age(0.0).unwrap();
        agent.vision(Vision::empty()).touch(Touch::empty()).growth(*growth.maturity(mature));
        scene.add_agent(&agent).unwrap();
        scene.set_maturity(0, maturity).unwrap();
        world(&scene)
    };
    let delays = |env: &Env, field: &str| {
        let layout = env.layout().unwrap();
        layout.delays(index(&layout, field)).unwrap()
    };
    let mut env = build(Mature::ALL, None);
    assert_eq!(delays(&env, "vestibular/acceleration"), [newborn.vestibular_delay; 3]);
    let late = delays(&env, "proprioception/limit");
    for (label, seconds) in labels(&env.layout().unwrap(), "proprioception/limit").iter().zip(&late) {
        let body = env.body_of(Kind::JOINT, env.find(Kind::JOINT, label).unwrap()).unwrap();
        let length = env.get(Quantity::BODY_NERVE_LENGTH, &[body]).unwrap()[0];
        let exact = length / newborn.conduction_speed + newborn.sensory_delay;
        assert!((seconds - exact).abs() < 0.0025 + 1e-9, "{}: {} and {}", label, seconds, exact);
    }
    let mut older = Growth::of_age(18.0).unwrap();
    older.maturity(Mature::ALL);
    env.reset(Reset::new().ages(&[Some(older)]), None).unwrap();
    assert!(delays(&env, "proprioception/limit").iter().sum::<f64>() < late.iter().sum());
    assert_eq!(delays(&build(Mature::EYES, None), "vestibular/acceleration"), [0.0; 3]);
    let slow = Maturity { vestibular_delay: 0.1, ..Maturity::new().unwrap() };
    assert_eq!(delays(&build(Mature::ALL, Some(&slow)), "vestibular/acceleration"), [0.1; 3]);
    let error = Scene::builtin("free").unwrap().set_maturity(0, Some(&newborn)).unwrap_err();
    assert_eq!(error.status(), Status::INVALID_ARGUMENT);
}

fn labels(layout: &Layout, field: &str) -> Vec<String> {
    layout.labels(index(layout, field)).unwrap()
}

#[test]
fn elements_and_actions_have_names() {
    let mut env = Env::make("benchmark").unwrap();
    let mut block = env.new_block().unwrap();
    let joints = labels(&env.layout().unwrap(), "proprioception/position");
    // Each joint gets another angle: the value set by its name is the element with its label.
    for (i, label) in joints.iter().enumerate() {
        let joint = env.find(Kind::JOINT, label).unwrap();
        env.set(Quantity::JOINT_POSITION, &[joint], &[0.001 * i as f64]).unwrap();
    }
    env.observe(&mut block).unwrap();
    let expected: Vec<f32> = (0..joints.len()).map(|i| (0.001 * i as f64) as f32).collect();
    assert_eq!(block.f32("proprioception/position").unwrap(), expected);

    let layout = env.layout().unwrap();
    assert!(labels(&layout, "touch/force").iter().all(String::is_empty));

    let actions = layout.actions().unwrap();
    assert_eq!(actions.len(), layout.action_count());
    let elbow = actions.iter().find(|action| action.name == "act:left_elbow").unwrap();
    // Its range in models/parts/body_defaults.xml.
    assert_eq!((elbow.unit.as_str(), elbow.agent), ("", 0));
    assert_eq!((elbow.low, elbow.high), (-1.0, f64::from(0.83f32)));
}

/// A ball at (0, 0, 2) and a box at (1, 0, 0), turned by a quarter about z: seen from the box the ball
/// is at (0, 1, 2). The ball starts at rest: after n steps of h under gravity g it is h^2 g n (n + 1) /
/// 2 lower, and falls at g h n.
#[test]
fn fields_are_added_on_request() {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(ObjectConfig::new("ball").unwrap().position([0.0, 0.0, 2.0])).unwrap();
    let mut block = ObjectConfig::new("box").unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    block.shape(Shape::BOX).size([0.1; 3]).mass(0.5).fixed(true);
    scene.add_object(block.position([1.0, 0.0, 0.0]).orientation([half, 0.0, 0.0, half])).unwrap();

    let place = |name| FieldConfig::new(name, Quantity::BODY_POSITION.now(), &["ball"]).unwrap();
    scene.add_field(&place("ball/world")).unwrap();
    scene.add_field(place("ball/box").relative_to("box").unwrap()).unwrap();
    let velocity = FieldConfig::new("velocity", Quantity::BODY_VELOCITY.now(), &["ball", "box"]).unwrap();
    scene.add_field(&velocity).unwrap();
    scene.add_field(&FieldConfig::new("mass", Quantity::BODY_MASS, &["box", "ball"]).unwrap()).unwrap();
    scene.add_field(&FieldConfig::new("gravity", Quantity::WORLD_GRAVITY, &[]).unwrap()).unwrap();
    assert_eq!(scene.add_field(&place("ball/box")).unwrap_err().status(), Status::INVALID_ARGUMENT);
    let unknown = FieldConfig::new("unknown", Quantity::from_raw(9999), &["ball"]).unwrap();
    assert_eq!(scene.add_field(&unknown).unwrap_err().status(), Status::UNSUPPORTED);

    let mut env = world(&scene);
    let (mut block, mut results) = (env.new_block().unwrap(), env.new_results().unwrap());
    env.reset(Reset::new(), Some(&mut block)).unwrap();
    let near = |name, block: &mimo::Block, expected: &[f64]| {
        let seen = block.f32(name).unwrap();
        let close = |(seen, expected): (&f32, &f64)| (f64::from(*seen) - expected).abs() < 1e-6;
        assert_eq!(seen.len(), expected.len());
        assert!(seen.iter().zip(expected).all(close), "{} is {:?}, expected {:?}", name, seen, expected);
    };
    near("ball/world", &block, &[0.0, 0.0, 2.0]);
    near("ball/box", &block, &[0.0, 1.0, 2.0]);
    near("mass", &block, &[0.5, 0.1]);
    near("gravity", &block, &[0.0, 0.0, -9.81]);
    for _ in 0..5 {
        env.step_into(&[], Some(&mut block), &mut results).unwrap();
    }
    let n = (env.time().unwrap() / 0.005).round();
    let fallen = 0.005 * 0.005 * 9.81 * n * (n + 1.0) / 2.0;
    near("ball/box", &block, &[0.0, 1.0, 2.0 - fallen]);
    let mut expected = [0.0; 12];
    expected[2] = -0.005 * 9.81 * n;
    near("velocity", &block, &expected);

    let shape = |name: &str| {
        let field = block.fields().iter().find(|field| field.name == name).unwrap();
        (field.shape.clone(), field.start, field.end)
    };
    assert_eq!(shape("velocity"), (vec![2, 6], 0.0, 0.0));
    assert_eq!(shape("mass").0, [2]);
    scene.add_field(&FieldConfig::new("cup", Quantity::BODY_MASS, &["cup"]).unwrap()).unwrap();
    let error = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap_err();
    assert!(error.status() == Status::NOT_FOUND && error.message().contains("ball"), "{}", error);
}

/// The reward of reach is minus the distance between goal and achieved goal: the ball, and the fingers.
#[test]
fn agents_have_goals_as_quantities() {
    let mut env = Env::make("reach").unwrap();
    env.reset(Reset::new().seed(3), None).unwrap();
    let ids = ["target", "right_fingers"].map(|name| env.find(Kind::BODY, name).unwrap());
    let places = env.get(Quantity::BODY_POSITION, &ids).unwrap();
    assert_eq!(env.get(Quantity::AGENT_GOAL, &[0]).unwrap(), places[..3]);
    assert_eq!(env.get(Quantity::AGENT_ACHIEVED, &[0]).unwrap(), places[3..]);
    let site = env.count(Kind::SITE).unwrap() as i32 - 1;
    assert_eq!(env.width(Quantity::SITE_VELOCITY, &[site]), Ok(6));
}
