//! Recordings, and their replay bit for bit.
use mimo::{
    Env, EnvConfig, Growth, Hearing, Recorder, RecorderConfig, Recording, Replay, Reset, Scene, Status,
    Touch, Vision,
};

fn path(name: &str) -> String {
    let file = format!("mimo_rust_{}_{}.h5", std::process::id(), name);
    std::env::temp_dir().join(file).to_str().unwrap().to_string()
}

fn world() -> Env {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty()).hearing(Hearing::EARS);
    scene.add_agent(&agent).unwrap();
    Env::new(&scene, &EnvConfig::new().unwrap()).unwrap()
}

/// None if HDF5 is not installed.
fn record(env: &mut Env, path: &str) -> Option<Recorder> {
    let mut config = RecorderConfig::new().unwrap();
    config.keep("hearing/ear_left").unwrap().state_seconds(0.1).configuration("{}").unwrap().seed(7);
    match Recorder::open(env, path, &config) {
        Err(error) if error.status() == Status::UNSUPPORTED => None,
        opened => Some(opened.unwrap()),
    }
}

#[test]
fn a_run_is_replayed() {
    let path = path("run");
    let (mut env, mut twin) = (world(), world());
    let mut block = env.new_block().unwrap();
    let Some(mut recorder) = record(&mut env, &path) else { return };
    let second = Recorder::open(&mut env, &path, &RecorderConfig::new().unwrap());
    assert_eq!(second.err().unwrap().status(), Status::BUSY); // it is being recorded already
    let action = vec![0.3; env.layout().unwrap().action_count()];
    env.play("head", &[0.1; 160], 16000.0).unwrap();
    for _ in 0..5 {
        env.step(&action, Some(&mut block)).unwrap();
    }
    let young = [Some(Growth::of_age(3.0).unwrap())];
    env.reset(Reset::new().ages(&young), None).unwrap();
    for _ in 0..5 {
        env.step(&action, Some(&mut block)).unwrap();
    }
    recorder.flush().unwrap();
    recorder.close().unwrap();
    let mut recording = Recording::open(&path, None).unwrap();
    let info = recording.info().unwrap();
    assert_eq!(
        (info.steps, info.bodies, info.configuration.as_str(), info.seed.as_str()),
        (10, 2, "{}", "7")
    );
    assert!(info.same_build);
    assert_eq!(recording.seek(&mut twin, 0, Replay::FIELDS).unwrap(), 0);
    assert_eq!(recording.step(&mut twin, None).unwrap().reward, 0.0);
    let report = recording.play(&mut twin).unwrap();
    assert!(report.identical && report.steps == 10 && report.differs_most_in.is_empty(), "{:?}", report);
    let mut alone = recording.env(&EnvConfig::new().unwrap(), None).unwrap();
    recording.seek(&mut alone, 0, Replay::FIELDS).unwrap();
    assert!(recording.play(&mut alone).unwrap().identical);
    assert_eq!(recording.size("fields/hearing/ear_left").unwrap(), (10, 640));
    let heard: Vec<f32> = recording.read("fields/hearing/ear_left", 0, 10).unwrap();
    assert!(heard[..800].iter().any(|pressure| pressure.abs() > 0.05)); // 0.1 Pa at 1 m
    assert_eq!(heard[1440..], *block.f32("hearing/ear_left").unwrap());
    assert_eq!(recording.read::<f64>("time", 9, 2).unwrap_err().status(), Status::INVALID_ARGUMENT);
    std::fs::remove_file(path).unwrap();
}

#[test]
fn existing_recordings_are_kept_by_default() {
    let path = path("stays");
    let mut env = world();
    let Some(recorder) = record(&mut env, &path) else { return };
    env.step(&[], None).unwrap();
    recorder.close().unwrap();
    let mut config = RecorderConfig::new().unwrap();
    let error = Recorder::open(&mut env, &path, &config).unwrap_err();
    assert_eq!(error.status(), Status::FILE);
    assert!(error.message().contains("only if `replace` is set"), "{}", error);
    assert_eq!(Recording::open(&path, None).unwrap().info().unwrap().steps, 1);
    config.replace(true);
    Recorder::open(&mut env, &path, &config).unwrap().close().unwrap();
    assert_eq!(Recording::open(&path, None).unwrap().info().unwrap().steps, 0);
    std::fs::remove_file(path).unwrap();
}

#[test]
fn other_files_are_no_recordings() {
    let path = path("none");
    let error = Recording::open(&path, None).unwrap_err();
    assert!(matches!(error.status(), Status::NOT_FOUND | Status::UNSUPPORTED), "{}", error);
    let mut env = world();
    let Some(first) = record(&mut env, &path) else { return };
    assert!(Recorder::open(&mut env, &path, &RecorderConfig::new().unwrap())
        .unwrap_err()
        .message()
        .contains("already"));
    drop(env); // closes the file
    first.close().unwrap();
    std::fs::write(&path, "no HDF5").unwrap();
    assert!(Recording::open(&path, None).unwrap_err().message().contains("is not a recording"));
    std::fs::remove_file(path).unwrap();
}
