//! Your own senses. They run in each physics step and observation, in a batch on all of its threads.
use crate::constants::{FieldType, Status};
use crate::error::{c_string, check, text, Result};
use crate::structs::{defaults, described, sized};
use crate::sys;
use crate::task::status;
use crate::world::World;
use std::ffi::{CStr, CString};
use std::fmt;
use std::marker::PhantomData;
use std::mem::size_of;
use std::os::raw::{c_char, c_void};
use std::ptr::null;

/// A field that a sense fills. Each infant has its own.
#[derive(Clone, Debug, PartialEq)]
pub struct SenseField {
    /// "rate" for "ct/rate"; "": the field has the sense's name.
    pub name: String,
    /// Type of its numbers.
    pub dtype: FieldType,
    /// Dimensions, C order; none: one number.
    pub shape: Vec<usize>,
    /// Unit, "Hz"; "" for none.
    pub unit: String,
    /// Frame of reference, "world"; "" for none.
    pub frame: String,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// A name for each number; none: they have no names.
    pub labels: Vec<String>,
    /// A field of touch whose receptors the first axis counts, "touch/force"; "" for none.
    pub skin: String,
    /// Which of these receptors; none: all.
    pub receptors: Vec<i32>,
    /// How fast the nerves of a skin field conduct, m/s; 0: as fast as large fibres.
    pub nerve_speed: f64,
}

impl SenseField {
    /// A field of `f32` without unit, frame and bounds.
    pub fn new(name: &str, shape: &[usize]) -> SenseField {
        SenseField {
            name: name.into(),
            dtype: FieldType::F32,
            shape: shape.into(),
            unit: String::new(),
            frame: String::new(),
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            labels: Vec::new(),
            skin: String::new(),
            receptors: Vec::new(),
            nerve_speed: 0.0,
        }
    }
}

/// A parameter of a sense.
#[derive(Clone, Debug, PartialEq)]
pub struct SenseParameter {
    /// Within the table "rate"; of a scene "ct/rate", as [`Scene::set_parameter`](crate::Scene::set_parameter) takes it.
    pub name: String,
    /// One line, with the unit.
    pub description: String,
    /// Default value.
    pub standard: f64,
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
}

impl SenseParameter {
    pub(crate) fn of(raw: &sys::mimo_parameter) -> SenseParameter {
        let (name, description) = (text(raw.name), text(raw.description));
        SenseParameter { name, description, standard: raw.standard, low: raw.low, high: raw.high }
    }
}

/// The world, for reading, and the moment at which a sense is called.
pub struct SenseMoment<'a> {
    /// The world. Calls that change it fail.
    pub world: &'a World,
    told: &'a sys::mimo_sense_moment,
    parameters: &'a [f64],
}

impl fmt::Debug for SenseMoment<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("SenseMoment").field("tick", &self.tick()).field("agent", &self.agent()).finish()
    }
}

impl SenseMoment<'_> {
    /// Number of the world in its batch; 0 for a single world.
    pub fn world_number(&self) -> usize {
        self.told.world
    }
    /// Number of the infant.
    pub fn agent(&self) -> usize {
        self.told.agent
    }
    /// What the infant's fields, and its parts in the model, begin with: "anna/".
    pub fn prefix(&self) -> String {
        text(self.told.prefix)
    }
    /// Physics steps since the start of the episode.
    pub fn tick(&self) -> u64 {
        self.told.tick
    }
    /// Seconds of a physics step.
    pub fn timestep(&self) -> f64 {
        self.told.timestep
    }
    /// Physics steps of an environment step.
    pub fn step_ticks(&self) -> usize {
        self.told.step_ticks
    }
    /// The value of a parameter, by its place in [`Sense::parameters`].
    pub fn parameter(&self, index: usize) -> f64 {
        self.parameters[index]
    }
    /// A normal number that follows from the world's seed, the tick and this number.
    pub fn noise(&self, number: u64) -> f64 {
        unsafe { sys::mimo_sense_noise(self.told.seed, self.told.tick, number) }
    }
    /// A field as its own sense has it now; it has as many numbers as the layout says.
    pub fn feel(&self, index: usize) -> Result<&[f32]> {
        let field = self.world.layout()?.field(index)?;
        if field.dtype != FieldType::F32 {
            let message = format!("{} has numbers of another type than f32", field.name);
            return Err(crate::Error::new(Status::INVALID_ARGUMENT, message));
        }
        let mut values = null();
        check(unsafe { sys::mimo_sense_feel(self.world.handle(), index, &mut values) })?;
        Ok(unsafe { std::slice::from_raw_parts(values as *const f32, field.bytes.len() / 4) })
    }
}

/// What [`Sense::open`] is given.
#[derive(Debug)]
pub struct SenseOpening<'a> {
    /// The world and the agent.
    pub moment: SenseMoment<'a>,
    /// How many numbers the sense remembers for this world and infant.
    pub memory: usize,
    /// Whether advance looks at MuJoCo's sensors, which then are computed in each physics step.
    pub sensors: bool,
    bytes: Vec<usize>,
}

impl SenseOpening<'_> {
    /// Declares a field.
    pub fn add(&mut self, field: &SenseField) -> Result<()> {
        let texts = [&field.name, &field.unit, &field.frame, &field.skin].map(|one| c_string(one));
        let [name, unit, frame, skin] = texts;
        let (name, unit, frame, skin) = (name?, unit?, frame?, skin?);
        let labels = field.labels.iter().map(|one| c_string(one)).collect::<Result<Vec<CString>>>()?;
        let labels: Vec<*const c_char> = labels.iter().map(|one| one.as_ptr()).collect();
        let some = |text: &CStr| if text.to_bytes().is_empty() { null() } else { text.as_ptr() };
        let mut raw = defaults(sys::mimo_sense_field_init)?;
        raw.dtype = field.dtype.raw();
        (raw.name, raw.unit, raw.frame, raw.skin) = (some(&name), unit.as_ptr(), frame.as_ptr(), some(&skin));
        (raw.shape, raw.ndim) = (field.shape.as_ptr(), field.shape.len());
        (raw.low, raw.high, raw.nerve_speed) = (field.low, field.high, field.nerve_speed);
        if !labels.is_empty() {
            (raw.labels, raw.label_count) = (labels.as_ptr(), labels.len());
        }
        if !field.receptors.is_empty() {
            (raw.receptors, raw.receptor_count) = (field.receptors.as_ptr(), field.receptors.len());
        }
        check(unsafe { sys::mimo_sense_add_field(self.moment.world.handle(), &raw) })?;
        let each = match field.dtype {
            FieldType::U8 => 1,
            FieldType::F64 => 8,
            _ => 4,
        };
        self.bytes.push(each * field.shape.iter().product::<usize>());
        Ok(())
    }
}

/// Types of numbers that fields have.
pub trait SenseNumber: Copy + private::Sealed {}
macro_rules! numbers {
    ($($number:ty)*) => { $(impl private::Sealed for $number {} impl SenseNumber for $number {})* };
}
numbers!(u8 i32 f32 f64);
mod private {
    pub trait Sealed {}
}

/// The fields that [`Sense::write`] fills; all numbers are 0 at first.
#[derive(Debug)]
pub struct SenseFields<'a> {
    places: &'a [*mut c_void],
    bytes: &'a [usize],
}

impl SenseFields<'_> {
    /// The numbers of a field, by the order of declaration, as the type that it was declared with.
    pub fn get<T: SenseNumber>(&mut self, index: usize) -> &mut [T] {
        unsafe {
            std::slice::from_raw_parts_mut(self.places[index] as *mut T, self.bytes[index] / size_of::<T>())
        }
    }
}

/// Your own sense, of one infant in one world, for [`Scene::add_sense`](crate::Scene::add_sense). The value
/// itself never changes; only its memory does, which is part of the world's state. If it returns an error or
/// panics, the call that ran it fails and quotes the error or the panic.
pub trait Sense: Send + Sync + Sized + 'static {
    /// Raise it when the memory changes its meaning.
    const VERSION: u32 = 0;

    /// Its parameters, with names such as "rate".
    fn parameters() -> Vec<SenseParameter> {
        Vec::new()
    }

    /// Looks up what it needs, and declares its fields.
    fn open(opening: &mut SenseOpening) -> Result<Self>;

    /// An episode starts; the memory is 0.
    fn reset(&self, moment: &SenseMoment, memory: &mut [f64]) -> Result<()> {
        let _ = (moment, memory);
        Ok(())
    }

    /// After each physics step.
    fn advance(&self, moment: &SenseMoment, memory: &mut [f64]) -> Result<()> {
        let _ = (moment, memory);
        Ok(())
    }

    /// Fills the fields. It runs as often as somebody looks.
    fn write(&self, moment: &SenseMoment, memory: &[f64], fields: &mut SenseFields) -> Result<()>;
}

/// The table of a sense, for the library.
#[derive(Debug)]
pub struct SenseTable<S: Sense> {
    raw: sys::mimo_sense,
    _texts: Vec<CString>,
    _parameters: Vec<sys::mimo_parameter>,
    sense: PhantomData<fn() -> S>,
}

impl<S: Sense> SenseTable<S> {
    /// Of a name, "ct".
    pub fn new(name: &str) -> Result<SenseTable<S>> {
        let mut texts = vec![c_string(name)?];
        let mut parameters = Vec::new();
        for parameter in S::parameters() {
            texts.push(c_string(&parameter.name)?);
            texts.push(c_string(&parameter.description)?);
            let mut raw: sys::mimo_parameter = sized();
            (raw.name, raw.description) = (texts[texts.len() - 2].as_ptr(), texts[texts.len() - 1].as_ptr());
            (raw.standard, raw.low, raw.high) = (parameter.standard, parameter.low, parameter.high);
            parameters.push(raw);
        }
        let mut raw = defaults(sys::mimo_sense_init)?;
        raw.interface_version = sys::MIMO_SENSE_INTERFACE;
        raw.name = texts[0].as_ptr();
        raw.version = S::VERSION;
        (raw.parameters, raw.parameter_count) = (parameters.as_ptr(), parameters.len());
        raw.open = Some(open::<S>);
        raw.close = Some(close::<S>);
        raw.reset = Some(reset::<S>);
        raw.advance = Some(advance::<S>);
        raw.write = Some(write::<S>);
        Ok(SenseTable { raw, _texts: texts, _parameters: parameters, sense: PhantomData })
    }

    pub(crate) fn raw(&self) -> &sys::mimo_sense {
        &self.raw
    }

    /// What a shared library exports: [`export_sense!`](crate::export_sense) calls it.
    ///
    /// # Safety
    /// `sense` comes from the library.
    #[doc(hidden)]
    pub unsafe fn export(name: &str, sense: *mut sys::mimo_sense) -> sys::mimo_status {
        status(|| {
            if ((*sense).struct_size as usize) < size_of::<sys::mimo_sense>() {
                return Err(crate::Error::new(Status::UNSUPPORTED, "this sense needs a newer libmimo"));
            }
            let table = Box::leak(Box::new(SenseTable::<S>::new(name)?));
            *sense = table.raw;
            Ok(())
        })
    }
}

/// Makes a shared library of a crate of type "cdylib": `mimo::export_sense!("ct", Afferents);`.
#[macro_export]
macro_rules! export_sense {
    ($name:expr, $sense:ty) => {
        /// The entry of the sense.
        ///
        /// # Safety
        /// The library calls it.
        #[no_mangle]
        pub unsafe extern "C" fn mimo_sense_entry(
            sense: *mut $crate::sys::mimo_sense,
        ) -> $crate::sys::mimo_status {
            $crate::SenseTable::<$sense>::export($name, sense)
        }
    };
}

/// What open has made.
struct Opened<S> {
    sense: S,
    parameters: usize,
    memory: usize,
    bytes: Vec<usize>,
}

/// # Safety
/// `env` and `told` come from the library.
unsafe fn moment<'a>(
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
    parameter_count: usize,
) -> SenseMoment<'a> {
    let (world, told) = (World::of(env as *mut sys::mimo_env), &*told);
    let parameters = match parameter_count {
        0 => &[],
        count => std::slice::from_raw_parts(told.parameters, count),
    };
    SenseMoment { world, told, parameters }
}

/// # Safety
/// The same, after open.
unsafe fn memory<'a, S>(opened: &Opened<S>, told: &sys::mimo_sense_moment) -> &'a mut [f64] {
    if opened.memory == 0 {
        return &mut [];
    }
    std::slice::from_raw_parts_mut(told.memory as *mut f64, opened.memory)
}

unsafe extern "C" fn open<S: Sense>(
    _: *mut c_void,
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
    needs: *mut sys::mimo_sense_needs,
) -> sys::mimo_status {
    status(|| {
        let parameters = S::parameters().len();
        let moment = moment(env, told, parameters);
        let mut opening = SenseOpening { moment, memory: 0, sensors: false, bytes: Vec::new() };
        let sense = S::open(&mut opening)?;
        (*needs).memory_bytes = opening.memory.saturating_mul(size_of::<f64>());
        (*needs).sensors = opening.sensors.into();
        let opened = Opened { sense, parameters, memory: opening.memory, bytes: opening.bytes };
        (*needs).own = Box::into_raw(Box::new(opened)) as *mut c_void;
        Ok(())
    })
}

unsafe extern "C" fn close<S: Sense>(_: *mut c_void, own: *mut c_void) {
    status(|| {
        drop(Box::from_raw(own as *mut Opened<S>));
        Ok(())
    });
}

/// Lets a sense change its memory.
unsafe fn change<S: Sense>(
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
    how: impl FnOnce(&S, &SenseMoment, &mut [f64]) -> Result<()>,
) -> sys::mimo_status {
    let opened = &*((*told).own as *const Opened<S>);
    let moment = moment(env, told, opened.parameters);
    status(|| how(&opened.sense, &moment, memory(opened, moment.told)))
}

unsafe extern "C" fn reset<S: Sense>(
    _: *mut c_void,
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
) -> sys::mimo_status {
    change(env, told, S::reset)
}

unsafe extern "C" fn advance<S: Sense>(
    _: *mut c_void,
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
) -> sys::mimo_status {
    change(env, told, S::advance)
}

unsafe extern "C" fn write<S: Sense>(
    _: *mut c_void,
    env: *const sys::mimo_env,
    told: *const sys::mimo_sense_moment,
) -> sys::mimo_status {
    let opened = &*((*told).own as *const Opened<S>);
    let moment = moment(env, told, opened.parameters);
    let places = std::slice::from_raw_parts(moment.told.fields, moment.told.field_count);
    let mut fields = SenseFields { places, bytes: &opened.bytes };
    status(|| opened.sense.write(&moment, memory(opened, moment.told), &mut fields))
}

/// The parameters of a scene's own senses.
pub(crate) fn parameters(scene: *const sys::mimo_scene) -> Result<Vec<SenseParameter>> {
    let mut all = Vec::new();
    loop {
        match described(|raw| unsafe { sys::mimo_scene_sense_parameter(scene, all.len(), raw) }) {
            Ok(raw) => all.push(SenseParameter::of(&raw)),
            Err(error) if error.status() == Status::NOT_FOUND => return Ok(all),
            Err(error) => return Err(error),
        }
    }
}
