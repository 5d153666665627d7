//! Configs. They keep the C struct with the library's own defaults, so that what a newer library adds stays as it is.
use crate::error::{c_string, check, Result};
use crate::log::{Level, Log};
use crate::sys;
use std::ffi::CString;
use std::mem::{size_of, MaybeUninit};
use std::os::raw::c_char;
use std::ptr::null;

type Init<T> = unsafe extern "C" fn(*mut T, usize) -> sys::mimo_status;

/// A C struct as its _init function fills it.
pub(crate) fn defaults<T>(init: Init<T>) -> Result<T> {
    let mut raw = MaybeUninit::<T>::zeroed();
    check(unsafe { init(raw.as_mut_ptr(), size_of::<T>()) })?;
    // All public structs are numbers and pointers, for which zeros are values too.
    Ok(unsafe { raw.assume_init() })
}

pub(crate) fn pointer(text: &Option<CString>) -> *const c_char {
    text.as_ref().map_or(null(), |text| text.as_ptr())
}

/// A string of a config; None for NULL.
fn given(text: *const c_char) -> Result<Option<CString>> {
    if text.is_null() {
        return Ok(None);
    }
    c_string(&crate::error::text(text)).map(Some)
}

/// One infant: where it is, what it senses, what of it acts. Made by [`Scene::default_agent`](crate::Scene) or
/// [`AgentConfig::new`].
#[derive(Clone, Debug)]
pub struct AgentConfig {
    raw: sys::mimo_agent_config,
    name: CString,
    body: CString,
    face: Option<CString>,
    root: Option<CString>,
    vestibular_at: Option<CString>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for AgentConfig {}
unsafe impl Sync for AgentConfig {}

impl AgentConfig {
    /// The mitten body at the scene's place, all senses on.
    pub fn new() -> Result<AgentConfig> {
        AgentConfig::of(defaults(sys::mimo_agent_config_init)?)
    }

    pub(crate) fn of(raw: sys::mimo_agent_config) -> Result<AgentConfig> {
        let name = c_string(&crate::error::text(raw.name))?;
        let body = c_string(&crate::error::text(raw.body))?;
        let (face, root, vestibular_at) = (given(raw.face)?, given(raw.root)?, given(raw.vestibular_at)?);
        Ok(AgentConfig { raw, name, body, face, root, vestibular_at })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_agent_config) -> R) -> R {
        let (name, body, face) = (self.name.as_ptr(), self.body.as_ptr(), pointer(&self.face));
        let (root, vestibular_at) = (pointer(&self.root), pointer(&self.vestibular_at));
        use_it(&sys::mimo_agent_config { name, body, face, root, vestibular_at, ..self.raw })
    }

    /// "" for a sole agent; else the prefix of its fields and model names, "anna/...".
    pub fn name(&mut self, name: &str) -> Result<&mut Self> {
        self.name = c_string(name)?;
        Ok(self)
    }

    /// "mitten"; or "scene": the body is already part of the scene's MJCF.
    pub fn body(&mut self, body: &str) -> Result<&mut Self> {
        self.body = c_string(body)?;
        Ok(self)
    }

    /// With the body "scene": the body of the model that the agent consists of, with all below it; "world": everything.
    /// Otherwise it is an infant.
    pub fn root(&mut self, body: &str) -> Result<&mut Self> {
        self.root = Some(c_string(body)?);
        Ok(self)
    }

    /// The site or body whose motion the vestibular sense feels; otherwise the infant's head.
    pub fn vestibular_at(&mut self, name: &str) -> Result<&mut Self> {
        self.vestibular_at = Some(c_string(name)?);
        Ok(self)
    }

    /// The face that it shows at first, see [`faces`](crate::faces).
    pub fn face(&mut self, name: &str) -> Result<&mut Self> {
        self.face = Some(c_string(name)?);
        Ok(self)
    }

    /// Where the root body is: metres, and w x y z; world frame. Otherwise at the scene's own place for an infant.
    pub fn place(&mut self, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.place_by(sys::MIMO_PLACE_ROOT as i32, position, orientation)
    }

    /// The same for another point of it, a `MIMO_PLACE_` constant: its soles, or its lowest point.
    pub fn place_by(&mut self, place: i32, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.raw.place = place;
        self.raw.position = position;
        self.raw.orientation = orientation;
        self
    }

    /// `MIMO_PROPRIOCEPTION_` bits; 0: none.
    pub fn proprioception(&mut self, bits: u32) -> &mut Self {
        self.raw.proprioception = bits;
        self
    }

    /// `MIMO_VESTIBULAR_` bits: accelerometer and gyroscope in the head; 0: none.
    pub fn vestibular(&mut self, bits: u32) -> &mut Self {
        self.raw.vestibular = bits;
        self
    }

    /// `MIMO_VISION_` bits of both eyes, and the size of their pictures, 1 to 4096 pixels; bits 0: no vision.
    pub fn vision(&mut self, bits: u32, width: u32, height: u32) -> &mut Self {
        self.raw.vision = bits;
        self.raw.vision_width = width;
        self.raw.vision_height = height;
        self
    }

    /// `MIMO_TOUCH_` bits, 0: none; and what the usual distances between sensors are divided by.
    pub fn touch(&mut self, bits: u32, scale: f64) -> &mut Self {
        self.raw.touch = bits;
        self.raw.touch_scale = scale;
        self
    }

    /// `MIMO_ACT_` bits: parts that have motors; 0: the scene's own choice.
    pub fn acts(&mut self, bits: u32) -> &mut Self {
        self.raw.acts = bits;
        self
    }

    /// A `MIMO_ACTUATION_` constant.
    pub fn actuation(&mut self, kind: u32) -> &mut Self {
        self.raw.actuation = kind;
        self
    }

    /// Whether all actions go from -1 to 1, mapped linearly to their range.
    pub fn normalize_actions(&mut self, on: bool) -> &mut Self {
        self.raw.normalize_actions = on.into();
        self
    }

    /// Everything else. Strings in it do not count: use [`name`](Self::name), [`body`](Self::body), ...
    pub fn raw_mut(&mut self) -> &mut sys::mimo_agent_config {
        &mut self.raw
    }
}

/// A rigid object of one primitive shape: a red sphere of 4 cm radius and 0.1 kg that moves freely, unless changed.
#[derive(Clone, Debug)]
pub struct Object {
    raw: sys::mimo_object_config,
    name: CString,
}

// The pointer inside is set for the length of a call only.
unsafe impl Send for Object {}
unsafe impl Sync for Object {}

impl Object {
    /// An object with the name of its body and geom, unique in the scene.
    pub fn new(name: &str) -> Result<Object> {
        Ok(Object { raw: defaults(sys::mimo_object_config_init)?, name: c_string(name)? })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_object_config) -> R) -> R {
        use_it(&sys::mimo_object_config { name: self.name.as_ptr(), ..self.raw })
    }

    /// A `MIMO_SHAPE_` constant and sizes in metres as it says.
    pub fn shape(&mut self, shape: u32, size: [f64; 3]) -> &mut Self {
        self.raw.shape = shape as i32;
        self.raw.size = size;
        self
    }

    /// Metres, world frame.
    pub fn position(&mut self, position: [f64; 3]) -> &mut Self {
        self.raw.position = position;
        self
    }

    /// w x y z.
    pub fn orientation(&mut self, orientation: [f64; 4]) -> &mut Self {
        self.raw.orientation = orientation;
        self
    }

    /// Kilograms; 0: a density of 1000 kg/m^3.
    pub fn mass(&mut self, mass: f64) -> &mut Self {
        self.raw.mass = mass;
        self
    }

    /// Colour, 0 to 1.
    pub fn rgba(&mut self, rgba: [f64; 4]) -> &mut Self {
        self.raw.rgba = rgba;
        self
    }

    /// Whether it is part of the world instead of moving freely.
    pub fn fixed(&mut self, fixed: bool) -> &mut Self {
        self.raw.fixed = fixed.into();
        self
    }
}

/// An MJCF document with one body, as an object: a toy with parts, a piece of furniture, a robot.
#[derive(Clone, Debug)]
pub struct Model {
    raw: sys::mimo_model_config,
    name: CString,
    file: Option<CString>,
    xml: Option<CString>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for Model {}
unsafe impl Sync for Model {}

impl Model {
    /// A file; all names in it get `name` and '/' before them.
    pub fn file(name: &str, path: &str) -> Result<Model> {
        Ok(Model { file: Some(c_string(path)?), ..Model::named(name)? })
    }

    /// A text; relative paths in it start from the working directory.
    pub fn xml(name: &str, text: &str) -> Result<Model> {
        Ok(Model { xml: Some(c_string(text)?), ..Model::named(name)? })
    }

    fn named(name: &str) -> Result<Model> {
        Ok(Model {
            raw: defaults(sys::mimo_model_config_init)?,
            name: c_string(name)?,
            file: None,
            xml: None,
        })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_model_config) -> R) -> R {
        let (name, file, xml) = (self.name.as_ptr(), pointer(&self.file), pointer(&self.xml));
        use_it(&sys::mimo_model_config { name, file, xml, ..self.raw })
    }

    /// Where its body is: metres, and w x y z; world frame.
    pub fn place(&mut self, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.raw.position = position;
        self.raw.orientation = orientation;
        self
    }

    /// Whether it gets no free joint.
    pub fn fixed(&mut self, fixed: bool) -> &mut Self {
        self.raw.fixed = fixed.into();
        self
    }
}

/// How a world is simulated.
#[derive(Clone, Debug)]
pub struct EnvConfig {
    raw: sys::mimo_env_config,
    task: Option<CString>,
    renderer: Option<CString>,
    pub(crate) log: Option<Log>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for EnvConfig {}
unsafe impl Sync for EnvConfig {}

impl EnvConfig {
    /// The scene's own task and frame skip, any renderer, silent.
    pub fn new() -> Result<EnvConfig> {
        let raw = defaults(sys::mimo_env_config_init)?;
        Ok(EnvConfig { raw, task: None, renderer: None, log: None })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_env_config) -> R) -> R {
        let mut raw = self.raw;
        if self.renderer.is_some() {
            raw.renderer = pointer(&self.renderer);
        }
        if self.task.is_some() {
            raw.task = pointer(&self.task);
        }
        let (log, log_user) = crate::log::raw(&self.log);
        raw.log = log;
        raw.log_user = log_user;
        use_it(&raw)
    }

    /// A task by name, "none", "reach", ..., in place of the scene's; see [`tasks`](crate::tasks).
    pub fn task(&mut self, name: &str) -> Result<&mut Self> {
        self.task = Some(c_string(name)?);
        Ok(self)
    }

    /// "ray", "osmesa", "auto", or "none": then eyes must be off.
    pub fn renderer(&mut self, name: &str) -> Result<&mut Self> {
        self.renderer = Some(c_string(name)?);
        Ok(self)
    }

    /// Physics steps of 5 ms per environment step, 1 to 1000; 0: the scene's own.
    pub fn frame_skip(&mut self, steps: u32) -> &mut Self {
        self.raw.frame_skip = steps;
        self
    }

    /// Steps after which an episode is truncated; 0: the task's own.
    pub fn max_steps(&mut self, steps: u32) -> &mut Self {
        self.raw.max_steps = steps;
        self
    }

    /// Whether [`World::timing`](crate::World::timing) counts, which costs a few clock reads a step.
    pub fn timing(&mut self, on: bool) -> &mut Self {
        self.raw.timing = on.into();
        self
    }

    /// `MIMO_RENDER_` bits: what pictures show.
    pub fn render(&mut self, bits: u32) -> &mut Self {
        self.raw.render = bits;
        self
    }

    /// Samples a pixel for smooth edges: 1, 4, 16 or 64; 0: one ray, or what the model tells OSMesa.
    pub fn samples(&mut self, samples: u32) -> &mut Self {
        self.raw.samples = samples;
        self
    }

    /// What touched what during a step is recorded, for [`World::step_contacts`](crate::World::step_contacts).
    pub fn step_contacts(&mut self, recorded: bool) -> &mut Self {
        self.raw.step_contacts = recorded as u32;
        self
    }

    /// Threads that draw one picture, 1 to 64; 1 is best in batches.
    pub fn render_threads(&mut self, threads: u32) -> &mut Self {
        self.raw.render_threads = threads;
        self
    }

    /// A `MIMO_JACOBIAN_` constant.
    pub fn jacobian(&mut self, kind: u32) -> &mut Self {
        self.raw.jacobian = kind as i32;
        self
    }

    /// Receives the library's messages during create, reset and step, on the calling thread. A panic in it is
    /// caught and dropped. It is shared by clones of the world.
    pub fn log(&mut self, log: impl Fn(Level, &str) + Send + Sync + 'static) -> &mut Self {
        self.log = Some(Log::new(log));
        self
    }
}
