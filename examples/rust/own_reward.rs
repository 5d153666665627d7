//! Your own reward: minus the distance between the right hand and the mouth. Their ids are looked up
//! once, and their positions read after every step. `cargo run --example own_reward`
use mimo::{Act, Actuation, Kind, Quantity};

/// The body and room of the scene "reach" without its task. Actions are target angles of the right arm,
/// from -1 to 1.
fn make_world() -> mimo::Result<mimo::Env> {
    let mut scene = mimo::Scene::builtin("reach")?;
    let mut agent = scene.default_agent()?;
    agent
        .acts(Act::RIGHT_ARM)
        .actuation(Actuation::POSITION)
        .normalize_actions(true);
    scene.add_agent(&agent)?;
    let mut config = mimo::EnvConfig::new()?;
    config.task("none")?;
    mimo::Env::new(&scene, &config)
}

/// Minus the distance between hand and mouth, m.
fn reward(env: &mimo::World, bodies: &[i32; 2]) -> mimo::Result<f64> {
    const MOUTH: [f64; 3] = [0.075, 0.0, 0.045]; // from the head's origin; the head looks ahead here
    let mut place = [0.0; 6];
    env.get_into(Quantity::BODY_POSITION, bodies, &mut place)?;
    let square: f64 = (0..3)
        .map(|i| (place[i] - place[3 + i] - MOUTH[i]).powi(2))
        .sum();
    Ok(-square.sqrt())
}

/// Mean reward of one second of moving to one posture.
fn try_posture(env: &mut mimo::Env, bodies: &[i32; 2], posture: &[f32]) -> mimo::Result<f64> {
    env.reset(mimo::Reset::new().seed(1), None)?;
    let mut sum = 0.0;
    for _ in 0..100 {
        env.step(posture, None)?;
        sum += reward(env, bodies)?;
    }
    Ok(sum / 100.0)
}

fn main() -> mimo::Result<()> {
    let mut env = make_world()?;
    let bodies = [
        env.find(Kind::BODY, "right_fingers")?,
        env.find(Kind::BODY, "head")?,
    ];
    let mut best = vec![0.0; env.layout()?.action_count()];
    let first = try_posture(&mut env, &bodies, &best)?;
    let mut highest = first;
    // The simplest learning: change one motor at a time, and keep improvements.
    for trial in 0..24 {
        let mut posture = best.clone();
        posture[trial / 2 % 4] += if trial % 2 == 0 { 0.4 } else { -0.4 };
        let mean = try_posture(&mut env, &bodies, &posture)?;
        if mean > highest {
            highest = mean;
            best = posture;
        }
    }
    println!(
        "mean distance of hand and mouth: {:.3} m at first, {:.3} m after 24 trials",
        -first, -highest
    );
    assert!(highest > first);
    Ok(())
}
