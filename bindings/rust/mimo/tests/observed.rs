//! What is observed: the layout, times of fields, fields on request.
use mimo::sys::*;
use mimo::{Env, EnvConfig, FieldConfig, Kind, Layout, Limits, Object, Reset, Scene, Type};

fn world(scene: &Scene) -> Env {
    Env::new(scene, &EnvConfig::new().unwrap()).unwrap()
}

fn index(layout: &Layout, name: &str) -> usize {
    let found = layout.find(name).unwrap();
    assert_eq!(layout.fields().unwrap()[found].name, name);
    found
}

#[test]
fn fields_follow_each_other_in_the_block() {
    let env = Env::make("benchmark").unwrap();
    let layout = env.layout().unwrap();
    let mut free = 0;
    for field in layout.fields().unwrap() {
        let size = match field.dtype {
            Type::U8 => 1,
            Type::F64 => 8,
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
    assert_eq!(error.kind(), Kind::NotFound);
    assert!(error.message().contains("touch/force"), "{}", error);
    assert!(layout.field(99).is_err());
}

/// Steps of reach are two physics steps of 5 ms; joints are those of its end, the organ of balance is MuJoCo's sensor, of
/// the start of the last physics step (docs/guide/time-and-frames.md).
#[test]
fn fields_say_when_they_are_true() {
    let times = |limits: &Limits| {
        let mut scene = Scene::builtin("reach").unwrap();
        let mut agent = scene.default_agent().unwrap();
        scene.add_agent(agent.vestibular(MIMO_VESTIBULAR_ACCELERATION)).unwrap();
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
    assert_eq!(times(&Limits::default()), [(0.0, 0.0), (-0.005, -0.005)]);
    let late = times(&Limits { delay: 0.03, ..Limits::default() });
    for ((start, end), expected) in late.into_iter().zip([-0.03, -0.035]) {
        assert!((start - expected).abs() < 1e-12 && (end - expected).abs() < 1e-12, "{} {}", start, end);
    }
}

#[test]
fn elements_and_actions_have_names() {
    let mut env = Env::make("benchmark").unwrap();
    let mut block = env.new_block().unwrap();
    env.reset(Reset::new().seed(1), Some(&mut block)).unwrap();
    let layout = env.layout().unwrap();
    let labels = layout.labels(index(&layout, "proprioception/position")).unwrap();
    let angles = block.f32("proprioception/position").unwrap();
    assert_eq!(labels.len(), angles.len());
    for (label, angle) in labels.iter().zip(angles) {
        let joint = env.find(MIMO_JOINT, label).unwrap();
        assert_eq!(env.get(MIMO_JOINT_POSITION, &[joint]).unwrap()[0] as f32, *angle, "{}", label);
    }
    assert!(layout.labels(index(&layout, "touch/force")).unwrap().iter().all(String::is_empty));

    let actions = layout.actions().unwrap();
    assert_eq!(actions.len(), layout.action_count());
    let elbow = actions.iter().find(|action| action.name == "act:left_elbow").unwrap();
    // Its range in models/parts/body_defaults.xml.
    assert_eq!((elbow.unit.as_str(), elbow.agent), ("", 0));
    assert_eq!((elbow.low, elbow.high), (-1.0, f64::from(0.83f32)));
}

/// A ball at (0, 0, 2) and a box at (1, 0, 0), turned by a quarter about z: seen from the box the ball is at (0, 1, 2). Both
/// stand still but for gravity g: after n steps of h the ball is h^2 g n (n + 1) / 2 lower, and falls at g h n.
#[test]
fn more_is_observed_on_request() {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(Object::new("ball").unwrap().position([0.0, 0.0, 2.0])).unwrap();
    let mut block = Object::new("box").unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    block.shape(MIMO_SHAPE_BOX, [0.1; 3]).mass(0.5).fixed(true);
    scene.add_object(block.position([1.0, 0.0, 0.0]).orientation([half, 0.0, 0.0, half])).unwrap();

    let place = |name| FieldConfig::new(name, MIMO_BODY_POSITION | MIMO_NOW, &["ball"]).unwrap();
    scene.add_field(&place("ball/world")).unwrap();
    scene.add_field(place("ball/box").relative_to("box").unwrap()).unwrap();
    let velocity = FieldConfig::new("velocity", MIMO_BODY_VELOCITY | MIMO_NOW, &["ball", "box"]).unwrap();
    scene.add_field(&velocity).unwrap();
    scene.add_field(&FieldConfig::new("mass", MIMO_BODY_MASS, &["box", "ball"]).unwrap()).unwrap();
    scene.add_field(&FieldConfig::new("gravity", MIMO_WORLD_GRAVITY, &[]).unwrap()).unwrap();
    assert_eq!(scene.add_field(&place("ball/box")).unwrap_err().kind(), Kind::InvalidArgument);
    let unknown = FieldConfig::new("unknown", 9999, &["ball"]).unwrap();
    assert_eq!(scene.add_field(&unknown).unwrap_err().kind(), Kind::Unsupported);

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
    scene.add_field(&FieldConfig::new("cup", MIMO_BODY_MASS, &["cup"]).unwrap()).unwrap();
    let error = Env::new(&scene, &EnvConfig::new().unwrap()).unwrap_err();
    assert!(error.kind() == Kind::NotFound && error.message().contains("ball"), "{}", error);
}

/// Reach is rewarded by minus the distance of what it wants and what is so far: the ball, and the fingers.
#[test]
fn goals_are_quantities_of_agents() {
    let mut env = Env::make("reach").unwrap();
    env.reset(Reset::new().seed(3), None).unwrap();
    let ids = ["target", "right_fingers"].map(|name| env.find(MIMO_BODY, name).unwrap());
    let places = env.get(MIMO_BODY_POSITION, &ids).unwrap();
    assert_eq!(env.get(MIMO_AGENT_GOAL, &[0]).unwrap(), places[..3]);
    assert_eq!(env.get(MIMO_AGENT_ACHIEVED, &[0]).unwrap(), places[3..]);
    let site = env.count(MIMO_SITE).unwrap() as i32 - 1;
    assert_eq!(env.width(MIMO_SITE_VELOCITY, &[site]), Ok(6));
}
