//! What a scene is made of.
use crate::error::{c_string, Error, Kind, Result};
use crate::log::{self, Log, LogRecord};
use crate::structs::{defaults, pointer};
use crate::sys;
use std::ffi::CString;

/// What a scene is made of, what its document may ask for, and who hears of its making.
#[derive(Clone, Debug)]
pub struct SceneConfig {
    raw: sys::mimo_scene_config,
    name: Option<CString>,
    file: Option<CString>,
    xml: Option<CString>,
    model_dir: Option<CString>,
    pub(crate) log: Option<Log>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for SceneConfig {}
unsafe impl Sync for SceneConfig {}

/// How much an MJCF document may ask for, 0 for the default, and whether its files must lie in its own folder. What asks
/// for more is refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DocumentLimits {
    /// Bytes of each file that is read.
    pub max_file_bytes: u64,
    /// Pixels of a texture, height field or shadow map.
    pub max_pixels: u64,
    /// Vertices of a mesh or skin, and its faces.
    pub max_vertices: u64,
    /// Elements of the document, and those that composites become.
    pub max_elements: u64,
    /// Keyframes of the document.
    pub max_keyframes: u64,
    /// Iterations of each solver in a physics step.
    pub max_iterations: u64,
    /// What the buffers of one world and its model may need, as estimated.
    pub max_world_bytes: u64,
    /// Milliseconds that MuJoCo's compiler may work at the document, as estimated; nobody else in the process can make
    /// a world meanwhile.
    pub max_compile_ms: u64,
    /// Whether includes and assets must lie in the folder of the document that names them, or below.
    pub confined: bool,
}

/// What a scene starts from: for C "" is nothing, and would be an empty world.
fn start(name: &str, text: &str, expected: &str) -> Result<CString> {
    if text.is_empty() {
        return Err(Error::new(Kind::InvalidArgument, format!("{name} is \"\", expected {expected}")));
    }
    c_string(text)
}

impl SceneConfig {
    /// An empty world.
    pub fn empty() -> Result<SceneConfig> {
        let raw = defaults(sys::mimo_scene_config_init)?;
        Ok(SceneConfig { raw, name: None, file: None, xml: None, model_dir: None, log: None })
    }

    /// A built-in scene: "reach", "benchmark", ...; see [`builtin_scenes`](crate::builtin_scenes).
    pub fn builtin(name: &str) -> Result<SceneConfig> {
        Ok(SceneConfig {
            name: Some(start("name", name, "that of a built-in scene")?),
            ..SceneConfig::empty()?
        })
    }

    /// An MJCF file. Its includes may name built-in files as "mimo/mitten.xml".
    pub fn file(path: &str) -> Result<SceneConfig> {
        Ok(SceneConfig { file: Some(start("path", path, "that of an MJCF file")?), ..SceneConfig::empty()? })
    }

    /// MJCF text; relative paths in it start from the working directory.
    pub fn xml(text: &str) -> Result<SceneConfig> {
        Ok(SceneConfig { xml: Some(start("text", text, "MJCF text")?), ..SceneConfig::empty()? })
    }

    /// For a document from somebody who is not trusted, or one that needs more than is usual.
    pub fn limits(&mut self, limits: DocumentLimits) -> &mut Self {
        self.raw.max_file_bytes = limits.max_file_bytes;
        self.raw.max_pixels = limits.max_pixels;
        self.raw.max_vertices = limits.max_vertices;
        self.raw.max_elements = limits.max_elements;
        self.raw.max_keyframes = limits.max_keyframes;
        self.raw.max_iterations = limits.max_iterations;
        self.raw.max_world_bytes = limits.max_world_bytes;
        self.raw.max_compile_ms = limits.max_compile_ms;
        self.raw.confined = limits.confined.into();
        self
    }

    /// Folder to take built-in models from instead of those inside the library.
    pub fn model_dir(&mut self, path: &str) -> Result<&mut Self> {
        self.model_dir = Some(c_string(path)?);
        Ok(self)
    }

    /// Receives messages about the scene and what is added to it, on the calling thread. A panic in it is caught and
    /// dropped.
    pub fn log(&mut self, log: impl Fn(&LogRecord) + Send + Sync + 'static) -> &mut Self {
        self.log = Some(Log::new(log));
        self
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_scene_config) -> R) -> R {
        let (name, file, xml) = (pointer(&self.name), pointer(&self.file), pointer(&self.xml));
        let (model_dir, (log, log_user)) = (pointer(&self.model_dir), log::raw(&self.log));
        use_it(&sys::mimo_scene_config { name, file, xml, model_dir, log, log_user, ..self.raw })
    }
}
