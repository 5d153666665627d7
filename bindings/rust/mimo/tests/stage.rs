//! Pictures of plain arrays: distances and light that geometry gives.
use mimo::{
    Form, Lamp, Stage, StageAir, StageLights, StageParts, StagePoses, StageShapes, StageView, Status,
};

const UPRIGHT: [f64; 9] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
const SIDE: u32 = 65;

/// A ball of half a metre above a floor 1 m below its middle.
fn ball_and_floor() -> (Vec<i32>, Vec<f64>, Vec<f32>) {
    (
        vec![Form::SPHERE.raw(), Form::PLANE.raw()],
        vec![0.5, 0.0, 0.0, 0.0, 0.0, 0.0],
        vec![1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
    )
}

#[test]
fn a_ball_on_a_floor_is_where_it_is() {
    let (forms, sizes, colors) = ball_and_floor();
    let geoms =
        StageShapes { object_type: 5, forms: &forms, sizes: &sizes, colors: &colors, ..Default::default() };
    // Without a headlight, Lambert's law: .1 + .8 cos 60 degrees.
    let mut air = StageAir::new().unwrap();
    air.headlight(false);
    let lights = StageLights {
        types: &[Lamp::SUN.raw()],
        casts_shadow: &[0],
        ambient: &[0.1, 0.1, 0.1],
        diffuse: &[0.8, 0.8, 0.8],
        specular: &[0.0, 0.0, 0.0],
        ..Default::default()
    };
    let parts =
        StageParts { geoms: Some(&geoms), lights: Some(&lights), air: Some(air), ..Default::default() };
    let mut stage = Stage::new(&parts, 1).unwrap();
    let turns: Vec<f64> = UPRIGHT.iter().chain(&UPRIGHT).copied().collect();
    let poses = StagePoses {
        geom_positions: &[0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
        geom_rotations: &turns,
        light_positions: &[0.0, 0.0, 9.0],
        light_directions: &[0.75f64.sqrt(), 0.0, -0.5],
        ..Default::default()
    };
    let view = StageView::new(SIDE, SIDE, [0.0, 0.0, 5.0], UPRIGHT).unwrap();
    let picture = stage.draw(&poses, &view).unwrap();
    let middle = (SIDE * SIDE / 2) as usize;
    assert!((picture.depth[middle] - 4.5).abs() < 1e-4, "{}", picture.depth[middle]);
    assert!((picture.depth[0] - 6.0).abs() < 1e-4, "{}", picture.depth[0]);
    assert_eq!(picture.segmentation[2 * middle..2 * middle + 2], [0, 5]);
    assert_eq!(picture.segmentation[..2], [1, 5]);
    assert!((f64::from(picture.rgb[0]) - 255.0 * 0.5).abs() <= 1.0, "{}", picture.rgb[0]);

    // Another colour, and what does not fit.
    let red = [1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0];
    let changed = StageShapes { colors: &red, ..geoms };
    stage.update(&StageParts { geoms: Some(&changed), ..Default::default() }).unwrap();
    let picture = stage.draw(&poses, &view).unwrap();
    assert!(picture.rgb[0] > 100 && picture.rgb[1] == 0);
    let short = StageShapes { colors: &red[..7], ..geoms };
    let error = stage.update(&StageParts { geoms: Some(&short), ..Default::default() }).unwrap_err();
    assert_eq!(error.status(), Status::INVALID_ARGUMENT);
    assert!(error.message().contains("colors has 7 elements, expected 2 times 4"), "{}", error);
    let nowhere = StagePoses { geom_positions: &[0.0, f64::NAN, 0.0, 0.0, 0.0, -1.0], ..poses };
    let error = stage.draw(&nowhere, &view).unwrap_err();
    assert!(
        error.message().contains("geom_positions[0, 1] is NaN") || error.message().contains("is nan"),
        "{}",
        error
    );
}

#[test]
fn many_pictures_are_those_of_one_each() {
    let (forms, sizes, colors) = ball_and_floor();
    let geoms = StageShapes { forms: &forms, sizes: &sizes, colors: &colors, ..Default::default() };
    let parts = StageParts { geoms: Some(&geoms), ..Default::default() };
    let mut stage = Stage::new(&parts, 2).unwrap();
    let places: Vec<[f64; 6]> = (0..3).map(|i| [0.2 * f64::from(i), 0.0, 0.0, 0.0, 0.0, -1.0]).collect();
    let turns: Vec<f64> = UPRIGHT.iter().chain(&UPRIGHT).copied().collect();
    let poses: Vec<StagePoses> = places
        .iter()
        .map(|place| StagePoses { geom_positions: place, geom_rotations: &turns, ..Default::default() })
        .collect();
    let view = StageView::new(SIDE, SIDE, [0.0, 0.0, 5.0], UPRIGHT).unwrap();
    let views: Vec<StageView> = (0..3)
        .map(|pose| {
            let mut one = view;
            one.pose = pose;
            one
        })
        .collect();
    let mut pictures = vec![mimo::StagePicture::new(SIDE, SIDE); 3];
    stage.draw_into(&poses, &views, &mut pictures).unwrap();
    for (place, picture) in poses.iter().zip(&pictures) {
        assert_eq!(*picture, stage.draw(place, &view).unwrap());
    }
    assert_ne!(pictures[0], pictures[1]);
}
