//! Faces, gaze, cameras and pictures.
use mimo::{
    CameraConfig, Env, EnvConfig, Kind, Look, ObjectConfig, PictureConfig, PictureFormat, Quantity, Receptor,
    Render, Reset, Scene, Status, Touch, Vision,
};

/// The scene "free" with an infant without vision and touch.
fn room() -> Scene {
    let mut scene = Scene::builtin("free").unwrap();
    let mut agent = scene.default_agent().unwrap();
    agent.vision(Vision::empty()).touch(Touch::empty()).face("sadness").unwrap();
    scene.add_agent(&agent).unwrap();
    scene
}

fn world(scene: &Scene) -> Env {
    Env::new(scene, &EnvConfig::new().unwrap()).unwrap()
}

#[test]
fn faces_show_in_pictures() {
    assert_eq!(mimo::faces().len(), 7); // no emotion, and the six basic ones
    let mut env = world(&room());
    assert_eq!(env.face(0).unwrap(), "sadness");
    let mut close = PictureConfig::new(64, 64).unwrap();
    let head = env.find(Kind::BODY, "head").unwrap();
    let place = env.get(Quantity::BODY_POSITION, &[head]).unwrap();
    close.free([place[0], place[1], place[2] + 0.07], 0.3, 180.0, 0.0);
    let sad = env.render(&close, Vision::RGB).unwrap();
    env.set_face(0, "fear").unwrap();
    assert_eq!(env.face(0).unwrap(), "fear");
    assert_ne!(sad, env.render(&close, Vision::RGB).unwrap());
    let error = env.set_face(0, "boredom").unwrap_err();
    assert_eq!(error.status(), Status::NOT_FOUND);
    assert!(error.message().contains("boredom") && error.message().contains("surprise"), "{}", error);
}

/// The eyes' centres are 49 mm apart: 2 atan(0.0245 m / d) is the vergence at a distance d straight ahead.
#[test]
fn lines_of_sight_meet_where_it_looks() {
    let mut env = world(&room());
    let before = env.gaze(0).unwrap();
    let eyes: Vec<f64> = (0..3).map(|i| (before.left.position[i] + before.right.position[i]) / 2.0).collect();
    let point = [eyes[0] + 0.4, eyes[1], eyes[2]];
    let planned = env.look_angles(0, point, Look::HEAD).unwrap();
    assert_eq!((planned.joints.len(), planned.angles.len()), (8, 8));
    let missed = env.look_at(0, point, Look::HEAD).unwrap();
    assert!(missed.iter().all(|angle| angle.abs() < 1e-6), "{:?}", missed);
    let now = env.get(Quantity::JOINT_POSITION, &planned.joints).unwrap();
    assert!(now.iter().zip(&planned.angles).all(|(now, angle)| (now - angle).abs() < 1e-12));
    let gaze = env.gaze(0).unwrap();
    let met = gaze.point.unwrap();
    assert!((0..3).all(|i| (met[i] - point[i]).abs() < 1e-6), "{:?} {:?}", met, point);
    assert!((gaze.vergence - 2.0 * (0.0245f64 / 0.4).atan()).abs() < 0.02, "{}", gaze.vergence);
}

#[test]
fn cameras_give_fields_and_pictures() {
    let mut scene = room();
    let mut wall = CameraConfig::new("wall", [1.5, 0.0, 0.8], [0.0, 0.0, 0.4]).unwrap();
    wall.width(32).height(24).outputs(Vision::RGB | Vision::SEGMENTATION);
    scene.add_camera(&wall).unwrap();
    assert!(scene.add_camera(&wall).unwrap_err().message().contains("wall"));
    let mut palm = CameraConfig::new("palm", [0.0, 0.0, 0.1], [0.0, 0.0, 1.0]).unwrap();
    palm.width(8).height(8).body("left_hand").unwrap();
    scene.add_camera(&palm).unwrap();
    let mut nowhere = CameraConfig::of_scene("periscope").unwrap();
    nowhere.width(8).height(8);
    let mut config = EnvConfig::new().unwrap();
    config.render(Render::SHADOWS).samples(4).render_threads(2);

    let mut env = Env::new(&scene, &config).unwrap();
    let mut block = env.new_block().unwrap();
    env.reset(Reset::new().seed(1), Some(&mut block)).unwrap();
    assert_eq!(block.u8("vision/palm").unwrap().len(), 8 * 8 * 3);
    let floor = env.find(Kind::GEOM, "floor").unwrap();
    assert!(block.i32("vision/wall_segmentation").unwrap().contains(&floor));

    let mut picture = PictureConfig::new(32, 24).unwrap();
    picture.camera("wall").unwrap();
    let plain = env.render(&picture, Vision::RGB).unwrap();
    assert_eq!(plain.rgb, block.u8("vision/wall").unwrap());
    assert!(plain.depth.is_empty() && plain.segmentation.is_empty());
    let flipped =
        env.render(picture.format(PictureFormat::RGBA | PictureFormat::BOTTOM_UP), Vision::RGB).unwrap();
    assert_eq!(flipped.rgb[..3], plain.rgb[23 * 32 * 3..][..3]);
    assert_eq!((flipped.rgb.len(), flipped.rgb[3]), (32 * 24 * 4, 255));

    scene.add_camera(&nowhere).unwrap();
    assert_eq!(Env::new(&scene, &config).err().unwrap().status(), Status::NOT_FOUND);
}

/// A ball of 4 cm radius, 2 m in front of the camera: its nearest point is 1.96 m away.
#[test]
fn pictures_show_depth_and_segmentation() {
    let mut scene = Scene::empty().unwrap();
    scene.add_object(ObjectConfig::new("ball").unwrap().position([0.0, 0.0, 2.0])).unwrap();
    let mut env = world(&scene);
    let mut config = PictureConfig::new(33, 33).unwrap();
    config.free([0.0, 0.0, 2.0], 2.0, 90.0, 0.0).fovy(20.0);
    let mut picture = config.new_picture(Vision::DEPTH | Vision::SEGMENTATION);
    env.render_into(&config, &mut picture).unwrap();
    let (middle, ball) = (16 * 33 + 16, env.find(Kind::GEOM, "ball").unwrap());
    assert!(picture.rgb.is_empty());
    assert!((picture.depth[middle] - 1.96).abs() < 1e-3, "{}", picture.depth[middle]);
    assert_eq!((picture.segmentation[middle], picture.segmentation[0]), (ball, -1));
    picture.depth.pop();
    assert_eq!(env.render_into(&config, &mut picture).unwrap_err().status(), Status::BUFFER_TOO_SMALL);
}

/// The number of receptors is that of docs/guide/touch.md.
#[test]
fn receptors_lie_on_the_skin() {
    let env = Env::make("benchmark").unwrap();
    let layout = env.layout().unwrap();
    let touch = layout.find("touch/force").unwrap();
    let field = layout.field(touch).unwrap();
    let receptors = layout.receptors(touch).unwrap();
    assert_eq!((field.receptors, receptors.len(), field.shape), (5685, 5685, vec![5685, 3]));
    let on_the_body = |id| env.body_of(Kind::GEOM, id).unwrap();
    assert!(receptors.iter().all(|receptor| on_the_body(receptor.geom) == receptor.body));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for receptor in &receptors {
        let (normal, tangent) = receptor.frame.split_at(3);
        assert!((dot(normal, normal) - 1.0).abs() < 1e-12 && dot(normal, &tangent[..3]).abs() < 1e-12);
    }
    assert_eq!(layout.receptor_values(touch, Receptor::POSITION).unwrap()[3..6], receptors[1].position);
    assert_eq!(
        layout.receptor_values(touch, Receptor::from_raw(99)).unwrap_err().status(),
        Status::UNSUPPORTED
    );
    assert_eq!(layout.field(layout.find("vision/eye_left").unwrap()).unwrap().receptors, 0);
}
