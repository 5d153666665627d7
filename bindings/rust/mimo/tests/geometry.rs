//! Geometry for engines.
use mimo::{Axes, Detail, Env, Kind, Quantity, Reset, TextureType};

fn length(v: [f32; 3]) -> f32 {
    v.iter().map(|x| x * x).sum::<f32>().sqrt()
}

#[test]
fn geoms_have_meshes_and_appearances() {
    let mut env = Env::make("benchmark").unwrap();
    let head = env.find(Kind::GEOM, "head").unwrap();
    let radius = env.get(Quantity::GEOM_SIZE, &[head]).unwrap()[0] as f32;
    let mesh = env.mesh(head, Axes::UNITY, Detail::default()).unwrap();
    let most = mesh.positions.iter().map(|&p| length(p)).fold(0.0, f32::max);
    assert!((most - radius).abs() < 1e-6, "{} {}", most, radius);
    assert!(mesh.positions.iter().all(|&p| length(p) > 0.98 * radius)); // cut between corners
    assert!(mesh.normals.iter().all(|&n| (length(n) - 1.0).abs() < 1e-5));
    assert_eq!(mesh.texcoords.len(), mesh.positions.len());
    assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
    let error = env.mesh(head, Axes::UNITY, Detail { segments: 6, ..Detail::default() }).unwrap_err();
    assert!(error.message().contains("segments is 6"), "{}", error);

    let before = env.appearance(head).unwrap();
    env.set_face(0, "surprise").unwrap();
    assert!(before.visible && before.texture != env.appearance(head).unwrap().texture);
    let texture = env.texture(before.texture.unwrap()).unwrap();
    assert_eq!((texture.kind, texture.height), (TextureType::CUBE, 6 * texture.width));
    assert_eq!(texture.pixels[3], 255);
    assert!(env.texture(env.texture_count().unwrap() as i32).is_err());
}

/// Unity's x is to the right, its y up, its z forward.
#[test]
fn poses_convert_to_an_engines_frame() {
    let mut env = Env::make("benchmark").unwrap();
    env.reset(Reset::new().seed(1), None).unwrap();
    let ours = env.poses(Kind::BODY, Axes::MIMO).unwrap();
    let unity = env.poses(Kind::BODY, Axes::UNITY).unwrap();
    assert_eq!(ours.len(), env.count(Kind::BODY).unwrap());
    for (a, b) in ours.iter().zip(&unity) {
        assert_eq!([-a.position[1], a.position[2], a.position[0]], b.position);
        assert_eq!(a.rotation[0], b.rotation[3]);
    }
    assert!(env.poses(Kind::JOINT, Axes::MIMO).is_err());
    let (mut points, mut directions) = ([[1.0, 2.0, 3.0]], [[1.0, 2.0, 3.0]]);
    mimo::convert_points(Axes::UNREAL, &mut points).unwrap();
    mimo::convert_directions(Axes::UNREAL, &mut directions).unwrap();
    assert_eq!((points, directions), ([[100.0, -200.0, 300.0]], [[1.0, -2.0, 3.0]]));
    let mut converted = ours.clone();
    mimo::convert_poses(Axes::UNITY, &mut converted).unwrap();
    assert_eq!(converted, unity);
    assert_eq!(env.layout().unwrap().info().step_seconds, 0.01);
    let head = env.light(None, Axes::GODOT).unwrap();
    assert!(head.directional && head.attenuation == [1.0, 0.0, 0.0]);
    let lamp = env.light(Some(0), Axes::MIMO).unwrap();
    let place = env.get(Quantity::LIGHT_POSITION.now(), &[0]).unwrap();
    assert!((0..3).all(|i| (f64::from(lamp.position[i]) - place[i]).abs() < 1e-6));
}
