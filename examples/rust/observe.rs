//! Lists the observation's fields, adds a field with a ball's position relative to the head, and finds
//! the touch receptor that feels most. `cargo run --example observe`
use mimo::{
    Env, EnvConfig, FieldConfig, Kind, Layout, ObjectConfig, Place, Quantity, Reset, Scene, Vision,
};

/// A ball falls on an infant that lies on its back.
fn make_world() -> mimo::Result<Env> {
    let mut scene = Scene::builtin("free")?;
    let mut agent = scene.default_agent()?;
    let half = std::f64::consts::FRAC_1_SQRT_2;
    agent.vision(Vision::empty());
    agent
        .place(Place::LOWEST)
        .position([0.0, 0.0, 0.0])
        .orientation([half, 0.0, -half, 0.0]);
    scene.add_agent(&agent)?;
    scene.add_object(
        ObjectConfig::new("ball")?
            .position([0.15, 0.0, 0.4])
            .mass(0.5),
    )?;
    let mut place = FieldConfig::new("ball/position", Quantity::BODY_POSITION.now(), &["ball"])?;
    scene.add_field(place.relative_to("head")?)?;
    Env::new(&scene, &EnvConfig::new()?)
}

fn print(layout: &Layout) -> mimo::Result<()> {
    for field in layout.fields()? {
        let shape = format!("{:?}", field.shape);
        println!(
            "{:<26} {:>12} {:<6} {:6.3} s after a step",
            field.name, shape, field.unit, field.end
        );
    }
    Ok(())
}

/// The receptor that feels most, and its force, N.
fn strongest(forces: &[f32]) -> (usize, f32) {
    let strength = |force: &[f32]| force.iter().map(|f| f * f).sum::<f32>().sqrt();
    let all = forces.chunks(3).map(strength).enumerate();
    all.fold(
        (0, 0.0),
        |most, one| if one.1 > most.1 { one } else { most },
    )
}

fn main() -> mimo::Result<()> {
    let mut env = make_world()?;
    print(&env.layout()?)?;
    let touch = env.layout()?.find("touch/force")?;
    let receptors = env.layout()?.receptors(touch)?;
    let mut block = env.new_block()?;
    env.reset(Reset::new().seed(1), Some(&mut block))?;
    for _ in 0..10 {
        let (receptor, force) = strongest(block.f32("touch/force")?);
        println!(
            "{:.2} s: the ball is at {:.2?} m from the head; the {} feels most, {:.1} N",
            env.time()?,
            block.f32("ball/position")?,
            env.name(Kind::BODY, receptors[receptor].body)?,
            force
        );
        for _ in 0..4 {
            env.step(&[], Some(&mut block))?;
        }
    }
    Ok(())
}
