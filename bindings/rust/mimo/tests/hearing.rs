//! Hearing: sounds that bodies play, and an infant's own voice.
use mimo::{Env, EnvConfig, Hearing, Scene, Status, Touch, Vision};

fn listening() -> Env {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty()).hearing(Hearing::EARS | Hearing::BANDS).voice(true);
    scene.add_agent(&agent).unwrap();
    Env::new(&scene, &EnvConfig::new().unwrap()).unwrap()
}

/// A cry has 82 dB at 1 m, and 99 dB at the infant's own ears: docs/guide/hearing.md. 0 dB are 20
/// micropascals.
#[test]
fn infants_hear_their_own_voice() {
    let mut env = listening();
    let actions = env.layout().unwrap().actions().unwrap();
    let voice = actions.len() - 4;
    let names: Vec<&str> = actions[voice..].iter().map(|action| action.name.as_str()).collect();
    assert_eq!(names, ["voice:loudness", "voice:pitch", "voice:opening", "voice:front"]);
    let mut cry = vec![0.0; actions.len()];
    (cry[voice], cry[voice + 2], cry[voice + 3]) = (1.0, 1.0, 1.0);
    let mut block = env.new_block().unwrap();
    let mut heard = Vec::new();
    for step in 0..50 {
        env.step(&cry, Some(&mut block)).unwrap();
        if step >= 25 {
            heard.extend_from_slice(block.f32("hearing/ear_left").unwrap());
        }
    }
    let mean = heard.iter().map(|&p| f64::from(p) * f64::from(p)).sum::<f64>() / heard.len() as f64;
    let level = 10.0 * (mean / 4e-10).log10();
    assert!((level - 99.0).abs() < 1.0, "{}", level);
}

#[test]
fn infants_hear_what_is_played() {
    let mut env = listening();
    let mut block = env.new_block().unwrap();
    let sound: Vec<f32> = (0..800).map(|i| (0.3 * i as f32).sin()).collect();
    env.play("head", &sound, 16000.0).unwrap();
    env.step(&[], Some(&mut block)).unwrap();
    assert!(block.f32("hearing/ear_right").unwrap().iter().any(|&p| p > 0.1));
    assert!(block.f32("hearing/bands").unwrap().iter().any(|&level| level > 40.0));
    let error = env.play("head", &sound, 44100.0).unwrap_err();
    assert_eq!(error.status(), Status::INVALID_ARGUMENT);
    assert!(error.message().contains("rate is 44100"), "{}", error);
}
