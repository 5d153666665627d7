//! The scenario of tests/capi/same.c, which gives the same hashes in every language.
fn hash_of(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(1099511628211)
    }) // FNV-1a
}

/// The task "own" of tests/capi/same.c.
struct Height;

impl mimo::Task for Height {
    fn memory(&self) -> usize {
        1
    }

    fn terms(&self) -> Vec<String> {
        vec!["height".into(), "effort".into()]
    }

    fn fields(&self) -> Vec<mimo::TaskField> {
        let field = |name| mimo::TaskField {
            unit: "m".into(),
            frame: "world".into(),
            ..mimo::TaskField::new(name, &[])
        };
        vec![field("desired_goal"), field("achieved_goal")]
    }

    fn reset(&self, world: &mut mimo::World, moment: &mut mimo::Moment) -> mimo::Result<()> {
        world.random(moment.memory)?;
        moment.memory[0] = 0.2 + 0.2 * moment.memory[0];
        moment.fields[0] = moment.memory[0] as f32;
        Ok(())
    }

    fn evaluate(
        &self,
        world: &mut mimo::World,
        moment: &mut mimo::Moment,
        verdict: &mut mimo::Verdict,
    ) -> mimo::Result<()> {
        let hand = world.find(mimo::Kind::BODY, "left_hand")?;
        let hand = world.get(mimo::Quantity::BODY_POSITION, &[hand])?[2];
        let square = |&action: &f32| f64::from(action) * f64::from(action);
        let effort: f64 = moment.action.unwrap_or(&[]).iter().map(square).sum();
        verdict.terms[0] = hand - moment.memory[0];
        verdict.terms[1] = -0.01 * effort;
        moment.fields[1] = hand as f32;
        if hand > moment.memory[0] {
            verdict.outcome = mimo::Outcome::SUCCESS;
        }
        verdict.goes_on = true;
        Ok(())
    }
}

fn make(scene: &str) -> mimo::Result<mimo::Env> {
    if scene != "own" {
        return mimo::Env::make(scene);
    }
    let mut scene = mimo::Scene::builtin("benchmark")?;
    let mut infant = scene.default_agent()?;
    infant.vision(mimo::Vision::empty());
    scene.add_agent(&infant)?;
    scene.set_task(Height)?;
    mimo::Env::new(&scene, &mimo::EnvConfig::new()?)
}

fn run(scene: &str) -> mimo::Result<()> {
    let mut env = make(scene)?;
    let mut block = env.new_block()?;
    let mut actions = vec![0.0; env.layout()?.action_count()];
    env.reset(mimo::Reset::new().seed(7), Some(&mut block))?;
    let mut hash = hash_of(14695981039346656037, block.as_bytes());
    let mut sum = 0.0;
    for step in 0..100 {
        for (i, action) in actions.iter_mut().enumerate() {
            *action = (((7 * step + 3 * i) % 21) as f32 - 10.0) / 10.0;
        }
        sum += env.step(&actions, Some(&mut block))?.reward;
        hash = hash_of(hash, block.as_bytes());
    }
    println!("{} {:016x} {:.6}", scene, hash, sum);
    Ok(())
}

/// The picture of tests/capi/same.c.
fn draw_stage() -> mimo::Result<()> {
    const TURNS: [f64; 18] = [
        1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0,
    ];
    let geoms = mimo::StageShapes {
        object_type: 5,
        forms: &[mimo::Form::PLANE.raw(), mimo::Form::SPHERE.raw()],
        sizes: &[0.0, 0.0, 0.0, 0.5, 0.0, 0.0],
        colors: &[1.0, 1.0, 1.0, 1.0, 0.9, 0.2, 0.1, 1.0],
        materials: &[0, -1],
        ..Default::default()
    };
    let textures = mimo::StageTextures {
        types: &[mimo::TextureType::FLAT.raw()],
        widths: &[2],
        heights: &[2],
        pixels: &[200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130],
        srgb: &[1],
        ..Default::default()
    };
    let materials = mimo::StageMaterials {
        colors: &[1.0, 1.0, 1.0, 1.0],
        textures: &[0],
        ..Default::default()
    };
    let lights = mimo::StageLights {
        types: &[mimo::Lamp::SUN.raw()],
        ..Default::default()
    };
    let parts = mimo::StageParts {
        geoms: Some(&geoms),
        textures: Some(&textures),
        materials: Some(&materials),
        lights: Some(&lights),
        ..Default::default()
    };
    let poses = mimo::StagePoses {
        geom_positions: &[0.0, 0.0, 0.0, 0.0, 0.0, 0.5],
        geom_rotations: &TURNS,
        light_positions: &[0.0, 0.0, 5.0],
        light_directions: &[0.0, 0.6, -0.8],
        ..Default::default()
    };
    let mut turn = [0.0; 9];
    turn.copy_from_slice(&TURNS[..9]);
    let view = mimo::StageView::new(64, 48, [0.0, 0.0, 4.0], turn)?;
    let picture = mimo::Stage::new(&parts, 1)?.draw(&poses, &view)?;
    let mut bytes = picture.rgb.clone();
    bytes.extend(picture.depth.iter().flat_map(|depth| depth.to_ne_bytes()));
    bytes.extend(
        picture
            .segmentation
            .iter()
            .flat_map(|object| object.to_ne_bytes()),
    );
    let sum: f64 = picture.rgb.iter().map(|&level| f64::from(level)).sum();
    println!(
        "stage {:016x} {:.6}",
        hash_of(14695981039346656037, &bytes),
        sum
    );
    Ok(())
}

fn main() -> mimo::Result<()> {
    ["reach", "standup", "selfbody", "benchmark", "own"]
        .into_iter()
        .try_for_each(run)?;
    draw_stage()
}
