//! Scenes: rooms, objects and infants.
use crate::configs::{AgentConfig, CameraConfig, FieldConfig, ModelConfig, ObjectConfig, SceneConfig};
use crate::error::{c_string, check, text, Result};
use crate::log::Log;
use crate::records::{Behaviour, Limits, Maturity};
use crate::sense::{self, Sense, SenseParameter, SenseTable};
use crate::structs::{defaults, described, pointer};
use crate::sys;
use crate::task::{self, Shared, Task};
use std::ptr::{null, null_mut, NonNull};

/// Describes a simulation. Worlds made from it do not need it any more.
#[derive(Debug)]
pub struct Scene {
    handle: NonNull<sys::mimo_scene>,
    // Worlds made from it share it.
    pub(crate) task: Option<Shared>,
    // Outlives the handle, which points to it.
    _log: Option<Log>,
}

// `&self` methods call functions whose handle is const, `&mut self` methods call the others: the header's
// rule.
unsafe impl Send for Scene {}
unsafe impl Sync for Scene {}

impl Scene {
    /// A scene of a config.
    pub fn new(config: &SceneConfig) -> Result<Scene> {
        let mut handle = null_mut();
        config.with_raw(|raw| check(unsafe { sys::mimo_scene_create(raw, &mut handle) }))?;
        let handle = NonNull::new(handle).expect("a handle");
        Ok(Scene { handle, task: None, _log: config.log.clone() })
    }

    /// An empty world.
    pub fn empty() -> Result<Scene> {
        Scene::new(&SceneConfig::empty()?)
    }

    /// A built-in scene: "reach", "benchmark", ...; see [`builtin_scenes`](crate::builtin_scenes).
    pub fn builtin(name: &str) -> Result<Scene> {
        Scene::new(&SceneConfig::builtin(name)?)
    }

    /// An MJCF file. Its includes may name built-in files as "mimo/mitten.xml".
    pub fn file(path: &str) -> Result<Scene> {
        Scene::new(&SceneConfig::file(path)?)
    }

    /// MJCF text; relative paths in it start from the working directory.
    pub fn xml(text: &str) -> Result<Scene> {
        Scene::new(&SceneConfig::xml(text)?)
    }

    pub(crate) fn handle(&self) -> *mut sys::mimo_scene {
        self.handle.as_ptr()
    }

    /// The scene's defaults for its infant.
    pub fn default_agent(&self) -> Result<AgentConfig> {
        let mut raw = defaults(sys::mimo_agent_config_init)?;
        let size = std::mem::size_of_val(&raw);
        check(unsafe { sys::mimo_scene_default_agent(self.handle(), &mut raw, size) })?;
        AgentConfig::of(raw)
    }

    /// Adds an infant and returns its number, 0 for the first.
    pub fn add_agent(&mut self, agent: &AgentConfig) -> Result<usize> {
        let mut number = 0;
        agent.with_raw(|raw| check(unsafe { sys::mimo_scene_add_agent(self.handle(), raw, &mut number) }))?;
        Ok(number)
    }

    /// Adds all infants that the scene names, each at its own place; a scene that names none gets one infant.
    /// `agent` has their common config; None: the scene's defaults. Returns the number of infants.
    pub fn add_agents(&mut self, agent: Option<&AgentConfig>) -> Result<usize> {
        let mut count = 0;
        let mut add = |raw| check(unsafe { sys::mimo_scene_add_agents(self.handle(), raw, &mut count) });
        match agent {
            Some(agent) => agent.with_raw(|raw| add(raw))?,
            None => add(null())?,
        }
        Ok(count)
    }

    /// Gives a room to a scene that has none, see [`rooms`](crate::rooms).
    pub fn set_room(&mut self, name: &str) -> Result<()> {
        let name = c_string(name)?;
        check(unsafe { sys::mimo_scene_set_room(self.handle(), name.as_ptr()) })
    }

    /// Adds an MJCF document with one body as an object.
    pub fn add_model(&mut self, model: &ModelConfig) -> Result<()> {
        model.with_raw(|raw| check(unsafe { sys::mimo_scene_add_model(self.handle(), raw) }))
    }

    /// Fastens a body softly to another body, or to the world, in a pose (position, quaternion w x y z) in
    /// the other's frame. Without a pose the bodies keep their relative pose at the start.
    pub fn weld(&mut self, body: &str, other: Option<&str>, pose: Option<&[f64; 7]>) -> Result<()> {
        let (body, other) = (c_string(body)?, other.map(c_string).transpose()?);
        let pose = pose.map_or(null(), |pose| pose.as_ptr());
        check(unsafe { sys::mimo_scene_weld(self.handle(), body.as_ptr(), pointer(&other), pose) })
    }

    /// Holds a hinge or slide softly, and starts it there, rad or m.
    pub fn lock(&mut self, joint: &str, value: f64) -> Result<()> {
        let joint = c_string(joint)?;
        check(unsafe { sys::mimo_scene_lock(self.handle(), joint.as_ptr(), value) })
    }

    /// Sets where a hinge or slide starts, rad or m.
    pub fn set_pose(&mut self, joint: &str, value: f64) -> Result<()> {
        let joint = c_string(joint)?;
        check(unsafe { sys::mimo_scene_set_pose(self.handle(), joint.as_ptr(), value) })
    }

    /// Adds an object.
    pub fn add_object(&mut self, object: &ObjectConfig) -> Result<()> {
        object.with_raw(|raw| check(unsafe { sys::mimo_scene_add_object(self.handle(), raw) }))
    }

    /// Makes an agent's proprioception read this hinge or slide. The first call removes all other joints.
    pub fn read_joint(&mut self, agent: usize, joint: &str) -> Result<()> {
        let joint = c_string(joint)?;
        check(unsafe { sys::mimo_scene_read_joint(self.handle(), agent, joint.as_ptr()) })
    }

    /// Limits a sense of an agent ("touch") or a field ("vision/eye_left"), for worlds made from now on.
    pub fn limit_sense(&mut self, agent: usize, path: &str, limits: &Limits) -> Result<()> {
        let (path, limits) = (c_string(path)?, limits.raw()?);
        check(unsafe { sys::mimo_scene_limit_sense(self.handle(), agent, path.as_ptr(), &limits) })
    }

    /// Limits a motor of an agent ("act:left_elbow"), the motors of a part of its body ("left_arm") or, with
    /// "", all motors, for worlds made from now on.
    pub fn limit_motor(&mut self, agent: usize, path: &str, limits: &Limits) -> Result<()> {
        let (path, limits) = (c_string(path)?, limits.raw()?);
        check(unsafe { sys::mimo_scene_limit_motor(self.handle(), agent, path.as_ptr(), &limits) })
    }

    /// Sets the maturity of an agent's eyes and nerves, for worlds made from now on; None: the maturity that
    /// follows from its growth. Limits replace these delays.
    pub fn set_maturity(&mut self, agent: usize, maturity: Option<&Maturity>) -> Result<()> {
        let raw = maturity.map(Maturity::raw).transpose()?;
        let maturity = raw.as_ref().map_or(null(), |raw| raw as *const _);
        check(unsafe { sys::mimo_scene_set_maturity(self.handle(), agent, maturity) })
    }

    /// Adds a camera to the observation. Its fields come after the fields of all infants.
    pub fn add_camera(&mut self, camera: &CameraConfig) -> Result<()> {
        camera.with_raw(|raw| check(unsafe { sys::mimo_scene_add_camera(self.handle(), raw) }))
    }

    /// Adds a field to the observation. It comes after the fields of all infants and cameras.
    pub fn add_field(&mut self, field: &FieldConfig) -> Result<()> {
        field.with_raw(|raw| check(unsafe { sys::mimo_scene_add_field(self.handle(), raw) }))
    }

    /// Gives your own task to all worlds made from now on, in place of the scene's task.
    pub fn set_task(&mut self, task: impl Task + 'static) -> Result<()> {
        let handle = self.handle();
        let tell = |raw: &sys::mimo_task| check(unsafe { sys::mimo_scene_set_task(handle, raw) });
        self.task = Some(task::share(task, tell)?);
        Ok(())
    }

    /// Removes your own task again.
    pub fn clear_task(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_scene_set_task(self.handle(), null()) })?;
        self.task = None;
        Ok(())
    }

    /// Gives an agent a sense of your own, for worlds made from now on. Its fields begin with `name`, and come after
    /// those of all infants and cameras.
    pub fn add_sense<S: Sense>(&mut self, agent: usize, name: &str) -> Result<()> {
        let table = SenseTable::<S>::new(name)?;
        check(unsafe { sys::mimo_scene_add_sense(self.handle(), agent, table.raw()) })
    }

    /// The same for a sense in a shared library, whose code runs: load only what you trust.
    pub fn load_sense(&mut self, agent: usize, path: &str) -> Result<()> {
        let path = c_string(path)?;
        check(unsafe { sys::mimo_scene_load_sense(self.handle(), agent, path.as_ptr()) })
    }

    /// The parameters of all senses of your own.
    pub fn sense_parameters(&self) -> Result<Vec<SenseParameter>> {
        sense::parameters(self.handle())
    }

    /// Sets the distance between the touch sensors of a body, "left_hand", metres; 0: no skin there.
    pub fn set_touch(&mut self, agent: usize, body: &str, spacing: f64) -> Result<()> {
        let body = c_string(body)?;
        check(unsafe { sys::mimo_scene_set_touch(self.handle(), agent, body.as_ptr(), spacing) })
    }

    /// Sets the delay, in seconds, by which an agent feels a part of its body, "left_hand", by touch and by
    /// its joints; None: the whole body. It replaces the delay that follows from its age.
    pub fn set_sensory_delay(&mut self, agent: usize, body: Option<&str>, seconds: f64) -> Result<()> {
        let body = body.map(c_string).transpose()?;
        let name = body.as_ref().map_or(null(), |name| name.as_ptr());
        check(unsafe { sys::mimo_scene_set_sensory_delay(self.handle(), agent, name, seconds) })
    }

    /// Sets the temperature of the room, -40 to 80 degrees Celsius: of its air and of everything without a
    /// temperature of its own. Infants have the temperature of skin in such a room.
    pub fn set_room_temperature(&mut self, celsius: f64) -> Result<()> {
        check(unsafe { sys::mimo_scene_set_room_temperature(self.handle(), celsius) })
    }

    /// Sets the temperature of a body of the model, "cup", and of its children, degrees Celsius. It stays
    /// constant.
    pub fn set_temperature(&mut self, body: &str, celsius: f64) -> Result<()> {
        let body = c_string(body)?;
        check(unsafe { sys::mimo_scene_set_temperature(self.handle(), body.as_ptr(), celsius) })
    }

    /// Sets the material of a body of the model and of its children: one of [`materials`](crate::materials).
    pub fn set_material(&mut self, body: &str, material: &str) -> Result<()> {
        let (body, material) = (c_string(body)?, c_string(material)?);
        check(unsafe { sys::mimo_scene_set_material(self.handle(), body.as_ptr(), material.as_ptr()) })
    }

    /// Sets a parameter of a task, "reach/success_reward", for worlds made from now on.
    pub fn set_parameter(&mut self, name: &str, value: f64) -> Result<()> {
        let name = c_string(name)?;
        check(unsafe { sys::mimo_scene_set_parameter(self.handle(), name.as_ptr(), value) })
    }

    /// The value of a parameter in this scene.
    pub fn parameter(&self, name: &str) -> Result<f64> {
        let name = c_string(name)?;
        let mut value = 0.0;
        check(unsafe { sys::mimo_scene_get_parameter(self.handle(), name.as_ptr(), &mut value) })?;
        Ok(value)
    }

    /// What the infant is to do, of a scene whose task is "behaviour".
    pub fn behaviour(&mut self) -> Result<Behaviour> {
        let raw = described(|raw| unsafe { sys::mimo_scene_behaviour(self.handle(), raw) })?;
        Ok(Behaviour::of(&raw))
    }

    /// Sets how many bodies can play at once (default 4), and how many seconds of sound each can hold
    /// (default 4).
    pub fn set_sources(&mut self, count: usize, seconds: f64) -> Result<()> {
        check(unsafe { sys::mimo_scene_set_sources(self.handle(), count, seconds) })
    }

    /// Sets the place from which a body plays, and the axis and directivity of its sound, in its frame.
    /// Directivity 0: equal in all directions, 0.5: a cardioid, 1: a figure of eight.
    pub fn direct_source(
        &mut self,
        body: &str,
        place: [f64; 3],
        axis: [f64; 3],
        directivity: f64,
    ) -> Result<()> {
        let body = c_string(body)?;
        check(unsafe {
            sys::mimo_scene_direct_source(
                self.handle(),
                body.as_ptr(),
                place.as_ptr(),
                axis.as_ptr(),
                directivity,
            )
        })
    }

    /// The scene as one MJCF document, as MuJoCo will compile it.
    pub fn to_xml(&self) -> Result<String> {
        let mut length = 0;
        check(unsafe { sys::mimo_scene_xml(self.handle(), null_mut(), 0, &mut length) })?;
        let mut bytes = vec![0u8; length + 1];
        check(unsafe {
            sys::mimo_scene_xml(self.handle(), bytes.as_mut_ptr() as *mut _, bytes.len(), null_mut())
        })?;
        Ok(text(bytes.as_ptr() as *const _))
    }

    /// Writes the scene as `scene.xml`, with its textures and meshes in `assets`, for any program with
    /// MuJoCo. Creates the folder if needed. Existing files with other content are not overwritten.
    pub fn save(&self, folder: &str) -> Result<()> {
        let folder = c_string(folder)?;
        check(unsafe { sys::mimo_scene_save(self.handle(), folder.as_ptr()) })
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        unsafe { sys::mimo_scene_destroy(self.handle()) }
    }
}
