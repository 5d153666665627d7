//! Constructors with arguments.
use crate::configs::*;
use crate::constants::{Quantity, Status};
use crate::error::{c_string, check, Error, Result};
use crate::records::Maturity;
use crate::structs::sized;
use crate::sys;
use std::mem::size_of;

impl SceneConfig {
    /// An empty world.
    pub fn empty() -> Result<SceneConfig> {
        SceneConfig::init()
    }

    /// A built-in scene: "reach", "benchmark", ...; see [`builtin_scenes`](crate::builtin_scenes).
    pub fn builtin(name: &str) -> Result<SceneConfig> {
        refuse_empty("name", name, "the name of a built-in scene")?;
        Ok(SceneConfig { name: Some(c_string(name)?), ..SceneConfig::init()? })
    }

    /// An MJCF file. Its includes may name built-in files as "mimo/mitten.xml".
    pub fn file(path: &str) -> Result<SceneConfig> {
        refuse_empty("path", path, "the path of an MJCF file")?;
        Ok(SceneConfig { file: Some(c_string(path)?), ..SceneConfig::init()? })
    }

    /// MJCF text; relative paths in it start from the working directory.
    pub fn xml(text: &str) -> Result<SceneConfig> {
        refuse_empty("text", text, "MJCF text")?;
        Ok(SceneConfig { xml: Some(c_string(text)?), ..SceneConfig::init()? })
    }
}

/// In C "" means nothing, and nothing makes an empty world.
fn refuse_empty(name: &str, text: &str, expected: &str) -> Result<()> {
    if text.is_empty() {
        return Err(Error::new(Status::INVALID_ARGUMENT, format!("{name} is \"\", expected {expected}")));
    }
    Ok(())
}

impl ObjectConfig {
    /// An object. Its body and its geom get the name, which is unique in the scene.
    pub fn new(name: &str) -> Result<ObjectConfig> {
        Ok(ObjectConfig { name: Some(c_string(name)?), ..ObjectConfig::init()? })
    }
}

impl ModelConfig {
    /// From a file. All names in it are prefixed with `name` and '/'.
    pub fn file(name: &str, path: &str) -> Result<ModelConfig> {
        Ok(ModelConfig { file: Some(c_string(path)?), ..ModelConfig::named(name)? })
    }

    /// From MJCF text. Relative paths in it start from the working directory.
    pub fn xml(name: &str, text: &str) -> Result<ModelConfig> {
        Ok(ModelConfig { xml: Some(c_string(text)?), ..ModelConfig::named(name)? })
    }

    fn named(name: &str) -> Result<ModelConfig> {
        Ok(ModelConfig { name: Some(c_string(name)?), ..ModelConfig::init()? })
    }
}

impl CameraConfig {
    /// A camera that exists: one of the scene's MJCF, or of an infant, "anna/eye_left".
    pub fn of_scene(name: &str) -> Result<CameraConfig> {
        Ok(CameraConfig { name: Some(c_string(name)?), ..CameraConfig::init()? })
    }

    /// A new camera that stands still in the world: its position, and the point in the middle of its picture, m.
    /// With a [`body`](CameraConfig::body) both are in the frame of that body, which carries the camera.
    pub fn new(name: &str, position: [f64; 3], look_at: [f64; 3]) -> Result<CameraConfig> {
        let mut camera = CameraConfig::of_scene(name)?;
        camera.raw.placed = 1;
        camera.raw.position = position;
        camera.raw.look_at = look_at;
        Ok(camera)
    }
}

impl FieldConfig {
    /// A field with a name of its own, "toys/position": a quantity of elements by their names in the model. An agent
    /// that is the only one has the name ""; a quantity of the world has no elements.
    pub fn new(name: &str, quantity: Quantity, elements: &[&str]) -> Result<FieldConfig> {
        let mut field = FieldConfig::init()?;
        field.raw.quantity = quantity.raw();
        field.name = Some(c_string(name)?);
        field.elements = elements.iter().map(|element| c_string(element)).collect::<Result<_>>()?;
        Ok(field)
    }
}

impl Growth {
    /// The median infant of an age, 0 to 24 months; the mean of girls and boys.
    pub fn of_age(months: f64) -> Result<Growth> {
        let mut growth = Growth::init()?;
        growth.raw.age = months;
        Ok(growth)
    }

    /// Another age, 0 to 24 months, for strength, range of motion and tone.
    pub fn physiological_age(&mut self, months: f64) -> &mut Self {
        self.raw.matures_apart = 1;
        self.raw.physiological_age = months;
        self
    }
}

impl BatchConfig {
    /// A number of worlds, with one thread for each core and without automatic reset.
    pub fn new(worlds: u32) -> Result<BatchConfig> {
        let mut config = BatchConfig::init()?;
        config.raw.worlds = worlds;
        Ok(config)
    }
}

impl PictureConfig {
    /// Width and height in pixels, 1 to 4096.
    pub fn new(width: u32, height: u32) -> Result<PictureConfig> {
        let mut config = PictureConfig::init()?;
        config.raw.width = width;
        config.raw.height = height;
        Ok(config)
    }
}

impl SensesConfig {
    /// For a host whose `mj_version()` returns this number.
    pub fn new(mujoco_version: i32) -> Result<SensesConfig> {
        let mut config = SensesConfig::init()?;
        config.raw.mujoco_version = mujoco_version;
        Ok(config)
    }
}

impl Maturity {
    /// The eyes and nerves of an infant of an age, 0 to 24 months.
    pub fn of_age(months: f64) -> Result<Maturity> {
        let mut raw = sized();
        check(unsafe { sys::mimo_maturity_at(months, &mut raw, size_of::<sys::mimo_maturity>()) })?;
        Ok(Maturity::of(&raw))
    }
}
