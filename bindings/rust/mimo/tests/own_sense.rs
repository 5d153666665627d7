//! Senses of one's own, in the program and in a shared library.
use mimo::{Env, EnvConfig, Error, Kind, Quantity, Reset, Result, Scene, Status, Vision};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How many there are.
static ELBOWS: AtomicUsize = AtomicUsize::new(0);

/// Sums an elbow's angle over physics steps; its field has the number of steps and the sum.
struct Elbow {
    joint: i32,
    balance: usize,
}

impl mimo::Sense for Elbow {
    fn parameters() -> Vec<mimo::SenseParameter> {
        let (name, description) = ("gain".into(), "factor of the angle".into());
        vec![mimo::SenseParameter { name, description, standard: 1.0, low: 0.0, high: 4.0 }]
    }

    fn open(opening: &mut mimo::SenseOpening) -> Result<Elbow> {
        opening.add(&mimo::SenseField::new("", &[2]))?;
        opening.memory = 3;
        let world = opening.moment.world;
        ELBOWS.fetch_add(1, Ordering::SeqCst);
        Ok(Elbow {
            joint: world.find(Kind::JOINT, "robot:left_elbow")?,
            balance: world.layout()?.find("vestibular/acceleration")?,
        })
    }

    fn reset(&self, moment: &mimo::SenseMoment, memory: &mut [f64]) -> Result<()> {
        assert_eq!((moment.tick(), &*memory), (0, &[0.0; 3][..]));
        memory[2] = 0.5;
        Ok(())
    }

    fn advance(&self, moment: &mimo::SenseMoment, memory: &mut [f64]) -> Result<()> {
        let angle = moment.world.get(Quantity::JOINT_POSITION, &[self.joint])?[0];
        memory[0] += 1.0;
        memory[1] += moment.parameter(0) * angle;
        if memory[0] == 7.0 {
            return Err(Error::new(Status::NOT_FOUND, "no seventh"));
        }
        if memory[0] == 9.0 {
            let _ = moment.parameter(1); // there is one only
        }
        assert_eq!((moment.tick() as f64, memory[2]), (memory[0], 0.5));
        Ok(())
    }

    fn write(
        &self,
        moment: &mimo::SenseMoment,
        memory: &[f64],
        fields: &mut mimo::SenseFields,
    ) -> Result<()> {
        assert_eq!(moment.feel(self.balance)?.len(), 3);
        for (to, from) in fields.get::<f32>(0).iter_mut().zip(memory) {
            *to = *from as f32;
        }
        Ok(())
    }
}

impl Drop for Elbow {
    fn drop(&mut self) {
        ELBOWS.fetch_sub(1, Ordering::SeqCst);
    }
}

fn blind_scene() -> Result<Scene> {
    let mut scene = Scene::builtin("free")?;
    let mut agent = scene.default_agent()?;
    agent.vision(Vision::empty());
    scene.add_agent(&agent)?;
    Ok(scene)
}

#[test]
fn a_sense_of_ones_own_sees_each_physics_step() -> Result<()> {
    let mut scene = blind_scene()?;
    scene.add_sense::<Elbow>(0, "elbow")?;
    assert_eq!(scene.sense_parameters()?[0].name, "elbow/gain");
    scene.set_parameter("elbow/gain", 2.0)?;
    let mut env = Env::new(&scene, &EnvConfig::new()?)?;
    let mut block = env.new_block()?;
    env.reset(Reset::new().seed(1), Some(&mut block))?;
    let joint = env.find(Kind::JOINT, "robot:left_elbow")?;
    for step in 1..=3 {
        env.step(&[], Some(&mut block))?;
        assert_eq!(block.f32("elbow")?[0], 2.0 * step as f32);
    }
    let angle = env.get(Quantity::JOINT_POSITION, &[joint])?[0] as f32;
    assert!((block.f32("elbow")?[1] / 12.0 - angle).abs() < 0.1);
    let error = env.step(&[], Some(&mut block)).unwrap_err();
    assert_eq!(error.status(), Status::TASK);
    assert!(error.message().contains("no seventh"), "{}", error);
    assert_eq!(block.f32("elbow")?[0], 0.0);
    let error = env.step(&[], Some(&mut block)).unwrap_err();
    assert!(error.message().contains("panicked: index out of bounds"), "{}", error);
    env.step(&[], Some(&mut block))?;
    assert_eq!(block.f32("elbow")?[0], 12.0);
    assert_eq!(ELBOWS.load(Ordering::SeqCst), 1);
    let twin = env.try_clone()?;
    assert_eq!(ELBOWS.load(Ordering::SeqCst), 2);
    drop((env, twin));
    assert_eq!(ELBOWS.load(Ordering::SeqCst), 0);
    let error = scene.load_sense(0, "/none.so").unwrap_err();
    assert_eq!(error.status(), Status::FILE);
    Ok(())
}

/// The example that `export_sense!` makes a sense of. `cargo test` builds it; with `--test own_sense`, add `--examples`.
fn warm_nose() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let name = format!("{}warm_nose{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    test.parent().unwrap().with_file_name("examples").join(name)
}

#[test]
fn a_shared_library_has_a_sense() -> Result<()> {
    let library = warm_nose();
    let mut scene = blind_scene()?;
    scene.load_sense(0, library.to_str().unwrap())?;
    assert_eq!(scene.sense_parameters()?[0].name, "warm_nose/gain");
    scene.set_parameter("warm_nose/gain", 2.0)?;
    let mut env = Env::new(&scene, &EnvConfig::new()?)?;
    let mut block = env.new_block()?;
    env.reset(Reset::new().seed(1), Some(&mut block))?;
    assert_eq!(block.f32("warm_nose/steps")?[0], 0.0);
    for step in 1..=3 {
        env.step(&[], Some(&mut block))?;
        let head = env.get(Quantity::BODY_POSITION, &[env.find(Kind::BODY, "head")?])?[2];
        assert!((f64::from(block.f32("warm_nose/height")?[0]) - 2.0 * head).abs() < 1e-6);
        assert_eq!(block.f32("warm_nose/steps")?[0], 2.0 * step as f32);
    }
    let error = scene.load_sense(0, library.to_str().unwrap()).unwrap_err();
    assert!(error.message().contains("has a sense \"warm_nose\" already"), "{}", error);
    Ok(())
}
