//! Infants as a scene describes them, and as a world has them.
use crate::error::{c_string, text, Result};
use crate::growth::Growth;
use crate::structs::{defaults, described, given, pointer};
use crate::sys;
use crate::world::World;
use std::ffi::CString;
use std::ops::Range;
use std::ptr::null;

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
    growth: Option<Growth>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for AgentConfig {}
unsafe impl Sync for AgentConfig {}

impl AgentConfig {
    /// The mitten body at the scene's place, which feels its joints, balance and touch, and sees in colour.
    pub fn new() -> Result<AgentConfig> {
        AgentConfig::of(defaults(sys::mimo_agent_config_init)?)
    }

    pub(crate) fn of(raw: sys::mimo_agent_config) -> Result<AgentConfig> {
        let name = c_string(&text(raw.name))?;
        let body = c_string(&text(raw.body))?;
        let (face, root, vestibular_at) = (given(raw.face)?, given(raw.root)?, given(raw.vestibular_at)?);
        Ok(AgentConfig { raw, name, body, face, root, vestibular_at, growth: None })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_agent_config) -> R) -> R {
        let (name, body, face) = (self.name.as_ptr(), self.body.as_ptr(), pointer(&self.face));
        let (root, vestibular_at) = (pointer(&self.root), pointer(&self.vestibular_at));
        let growth = self.growth.as_ref().map_or(null(), |growth| growth.raw() as *const _);
        use_it(&sys::mimo_agent_config { name, body, face, root, vestibular_at, growth, ..self.raw })
    }

    /// "" for a sole agent; else the prefix of its fields and model names, "anna/...".
    pub fn name(&mut self, name: &str) -> Result<&mut Self> {
        self.name = c_string(name)?;
        Ok(self)
    }

    /// "mitten" or "fingers", either with "-mirrored" after it: its left is the image of its right. Or "scene": the body
    /// is already part of the scene's MJCF.
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

    /// How old it is; otherwise 18 months.
    pub fn growth(&mut self, growth: Growth) -> &mut Self {
        self.growth = Some(growth);
        self
    }

    /// The face that it shows at first, see [`faces`](crate::faces).
    pub fn face(&mut self, name: &str) -> Result<&mut Self> {
        self.face = Some(c_string(name)?);
        Ok(self)
    }

    /// Where the root body is: metres, and w x y z; world frame. Otherwise at the scene's own place for an infant.
    pub fn place(&mut self, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.place_by(sys::MIMO_PLACE_ROOT, position, orientation)
    }

    /// The same for another point of it, a `MIMO_PLACE_` constant: its soles, or its lowest point.
    pub fn place_by(&mut self, place: u32, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.raw.place = place as i32;
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

    /// `MIMO_REFLEX_` bits: reflexes of newborns, which add to its commands; at first none.
    pub fn reflexes(&mut self, bits: u32) -> &mut Self {
        self.raw.reflexes = bits;
        self
    }

    /// `MIMO_HEARING_` bits: sound at both ears, and what of it is heard; 0: none.
    pub fn hearing(&mut self, bits: u32) -> &mut Self {
        self.raw.hearing = bits;
        self
    }

    /// An infant's voice: four more actions after those of motors; at first none.
    pub fn voice(&mut self, on: bool) -> &mut Self {
        self.raw.voice = on.into();
        self
    }

    /// Of colour: the middle is shown L / ln(1 + L) times as large and the rim small; 0: as drawn.
    pub fn vision_foveation(&mut self, strength: f64) -> &mut Self {
        self.raw.vision_foveation = strength;
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

    /// A `MIMO_RESPONSE_` constant: which sensors feel how much of a touch.
    pub fn touch_response(&mut self, kind: u32) -> &mut Self {
        self.raw.touch_response = kind as i32;
        self
    }

    /// A `MIMO_FRAME_` constant: the frame of forces on the skin.
    pub fn touch_frame(&mut self, frame: u32) -> &mut Self {
        self.raw.touch_frame = frame as i32;
        self
    }

    /// `MIMO_ACT_` bits: parts that have motors; 0: the scene's own choice.
    pub fn acts(&mut self, bits: u32) -> &mut Self {
        self.raw.acts = bits;
        self
    }

    /// A `MIMO_ACTUATION_` constant.
    pub fn actuation(&mut self, kind: u32) -> &mut Self {
        self.raw.actuation = kind as i32;
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

/// What is to be known of an agent of a world.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct AgentInfo {
    /// "" for a sole one.
    pub name: String,
    /// Where its actions are among those of all agents.
    pub actions: Range<usize>,
    /// Of its whole body, kg.
    pub mass: f64,
    /// Vertical extent of its geoms in the initial pose, m.
    pub height: f64,
}

impl World {
    /// What is to be known of the index-th agent.
    pub fn agent(&self, index: usize) -> Result<AgentInfo> {
        let raw: sys::mimo_agent_info =
            described(|raw| unsafe { sys::mimo_env_agent(self.handle(), index, raw) })?;
        let start = raw.action_offset as usize;
        Ok(AgentInfo {
            name: text(raw.name),
            actions: start..start + raw.action_count as usize,
            mass: raw.mass,
            height: raw.height,
        })
    }
}
