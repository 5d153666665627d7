//! Your own tasks. They run inside reset and step, in a batch on all of its threads.
use crate::constants::{FieldType, Outcome, Status};
use crate::error::{c_string, Result};
use crate::field::Field;
use crate::structs::defaults;
use crate::sys;
use crate::world::World;
use std::any::Any;
use std::ffi::CString;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Arc;

/// The arguments of a task: the world, the agent, and what happened.
#[derive(Debug)]
#[non_exhaustive]
pub struct Moment<'a> {
    /// Number of the world in its batch; 0 for a single world.
    pub world: usize,
    /// Number of the infant.
    pub agent: usize,
    /// Steps since the reset, including this one; 0 in a reset.
    pub step: u64,
    /// The numbers of [`Task::memory`], of this world and infant. They are 0 at the start of an episode, and part of
    /// the world's state.
    pub memory: &'a mut [f64],
    /// Values of [`Task::fields`], one field after the other. They are 0 at the start of an episode, keep
    /// their values between steps, and are part of the world's state.
    pub fields: &'a mut [f32],
    /// The infant's own actions of this step, within their bounds; None in a step without actions, and in a
    /// reset.
    pub action: Option<&'a [f32]>,
    /// The observation of this step, of all infants; None in a step without a block, and in a reset. Its
    /// fields of tasks still have the values of the previous step.
    pub block: Option<&'a [u8]>,
}

impl Moment<'_> {
    /// A field of single precision numbers (see [`Layout::fields`](crate::Layout::fields)) in the observation of this step.
    pub fn f32(&self, field: &Field) -> Option<&[f32]> {
        let bytes = self.block?.get(field.bytes.clone())?;
        let aligned = bytes.as_ptr().align_offset(std::mem::align_of::<f32>()) == 0;
        if field.dtype != FieldType::F32 || !aligned {
            return None;
        }
        Some(unsafe { std::slice::from_raw_parts(bytes.as_ptr() as *const f32, bytes.len() / 4) })
    }
}

/// A task's judgement of a step. At first the reward is 0, and the episode continues.
#[derive(Debug)]
#[non_exhaustive]
pub struct Verdict<'a> {
    /// The reward of a task without terms. With terms it stays 0, because the reward is their sum.
    pub reward: f64,
    /// One value for each of [`Task::terms`].
    pub terms: &'a mut [f64],
    /// Success, failure or neither. Success and failure end the episode.
    pub outcome: Outcome,
    /// Whether the episode continues after success or failure.
    pub goes_on: bool,
    /// Whether the episode is cut off here.
    pub truncated: bool,
}

/// A field of the observation that a task fills, in single precision: a goal, or what has been achieved of
/// it. Each infant has its own.
#[derive(Clone, Debug, PartialEq)]
pub struct TaskField {
    /// "goal"; unique among the fields of the infant.
    pub name: String,
    /// Dimensions, C order; none: one number.
    pub shape: Vec<usize>,
    /// Unit, "m"; "" for none.
    pub unit: String,
    /// Frame of reference, "world"; "" for none.
    pub frame: String,
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
}

impl TaskField {
    /// A field without unit, frame and bounds.
    pub fn new(name: &str, shape: &[usize]) -> TaskField {
        let (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
        TaskField {
            name: name.into(),
            shape: shape.into(),
            unit: String::new(),
            frame: String::new(),
            low,
            high,
        }
    }
}

/// Your own task, for [`Scene::set_task`](crate::Scene::set_task). The worlds of a batch call it at the same
/// time, on different threads. If it returns an error or panics, the call that ran it fails and quotes the
/// error or the panic.
pub trait Task: Send + Sync {
    /// The number of values that each world and agent keeps for the task.
    fn memory(&self) -> usize {
        0
    }

    /// Names of the terms that add up to the reward; none: the reward is one number.
    fn terms(&self) -> Vec<String> {
        Vec::new()
    }

    /// Further fields of the observation.
    fn fields(&self) -> Vec<TaskField> {
        Vec::new()
    }

    /// Prepares an episode, in a world at its start. Resets, steps and loading a state fail here.
    fn reset(&self, world: &mut World, moment: &mut Moment) -> Result<()> {
        let _ = (world, moment);
        Ok(())
    }

    /// Judges a step. Positions of bodies belong to the start of the last physics step. Values that it
    /// writes, for example to place the next goal, count from the next step on. It is called for the agents
    /// in their order.
    fn evaluate(&self, world: &mut World, moment: &mut Moment, verdict: &mut Verdict) -> Result<()>;
}

/// The library keeps a pointer to it.
pub(crate) struct Kept {
    task: Box<dyn Task>,
    // As they were when the library received the task.
    memory: usize,
    terms: usize,
    fields: usize,
}

impl fmt::Debug for Kept {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("Task").field("memory", &self.memory).finish_non_exhaustive()
    }
}

/// The owner of a handle made with a task owns a share of the task.
pub(crate) type Shared = Arc<Kept>;

/// Passes a task to the library through `tell`, and keeps it.
pub(crate) fn share(
    task: impl Task + 'static,
    tell: impl FnOnce(&sys::mimo_task) -> Result<()>,
) -> Result<Shared> {
    let (memory, terms, fields) = (task.memory(), task.terms(), task.fields());
    let terms = terms.iter().map(|name| c_string(name)).collect::<Result<Vec<CString>>>()?;
    let texts = fields.iter().map(texts).collect::<Result<Vec<_>>>()?;
    let described = fields.iter().zip(&texts).map(raw_field).collect::<Result<Vec<_>>>()?;
    let names: Vec<*const c_char> = terms.iter().map(|name| name.as_ptr()).collect();
    let count = fields.iter().map(|field| field.shape.iter().product::<usize>()).sum();
    let kept = Arc::new(Kept { task: Box::new(task), memory, terms: terms.len(), fields: count });
    let mut raw = defaults(sys::mimo_task_init)?;
    raw.user = Arc::as_ptr(&kept) as *mut c_void;
    raw.memory_bytes = memory.saturating_mul(std::mem::size_of::<f64>());
    raw.reset = Some(reset);
    raw.evaluate = Some(evaluate);
    (raw.terms, raw.term_count) = (names.as_ptr(), names.len());
    (raw.fields, raw.field_count) = (described.as_ptr(), described.len());
    tell(&raw)?;
    Ok(kept)
}

/// Name, unit and frame.
fn texts(field: &TaskField) -> Result<[CString; 3]> {
    Ok([c_string(&field.name)?, c_string(&field.unit)?, c_string(&field.frame)?])
}

fn raw_field((field, texts): (&TaskField, &[CString; 3])) -> Result<sys::mimo_task_field> {
    let mut raw = defaults(sys::mimo_task_field_init)?;
    (raw.name, raw.unit, raw.frame) = (texts[0].as_ptr(), texts[1].as_ptr(), texts[2].as_ptr());
    (raw.shape, raw.ndim) = (field.shape.as_ptr(), field.shape.len() as u32);
    (raw.low, raw.high) = (field.low, field.high);
    Ok(raw)
}

/// # Safety
/// `data` points to `count` elements, or is NULL.
unsafe fn slice<'a, T>(data: *const T, count: usize) -> Option<&'a [T]> {
    (!data.is_null()).then(|| std::slice::from_raw_parts(data, count))
}

/// # Safety
/// The same, and nobody else uses the elements.
unsafe fn slice_mut<'a, T>(data: *mut T, count: usize) -> &'a mut [T] {
    if data.is_null() {
        return &mut [];
    }
    std::slice::from_raw_parts_mut(data, count)
}

/// # Safety
/// `user` is a task of `share`, and `told` comes from the library.
unsafe fn parts<'a>(user: *mut c_void, told: *const sys::mimo_task_moment) -> (&'a Kept, Moment<'a>) {
    let (kept, told) = (&*(user as *const Kept), &*told);
    let moment = Moment {
        world: told.world,
        agent: told.agent,
        step: told.step,
        memory: slice_mut(told.memory as *mut f64, kept.memory),
        fields: slice_mut(told.fields, kept.fields),
        action: slice(told.action, told.action_count),
        block: slice(told.block as *const u8, told.block_bytes),
    };
    (kept, moment)
}

unsafe extern "C" fn reset(
    user: *mut c_void,
    env: *mut sys::mimo_env,
    told: *const sys::mimo_task_moment,
) -> sys::mimo_status {
    let (kept, mut moment) = parts(user, told);
    status(|| kept.task.reset(World::of(env), &mut moment))
}

unsafe extern "C" fn evaluate(
    user: *mut c_void,
    env: *mut sys::mimo_env,
    told: *const sys::mimo_task_moment,
    verdict: *mut sys::mimo_task_verdict,
) -> sys::mimo_status {
    let (kept, mut moment) = parts(user, told);
    let raw = &mut *verdict;
    let terms = slice_mut(raw.terms, kept.terms);
    let mut ours = Verdict { reward: 0.0, terms, outcome: Outcome::NONE, goes_on: false, truncated: false };
    let status = status(|| kept.task.evaluate(World::of(env), &mut moment, &mut ours));
    raw.reward = ours.reward;
    raw.goes_on = ours.goes_on.into();
    raw.truncated = ours.truncated.into();
    raw.outcome = ours.outcome.raw();
    status
}

/// A panic must not unwind into C.
pub(crate) fn status(work: impl FnOnce() -> Result<()>) -> sys::mimo_status {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(())) => sys::MIMO_OK,
        Ok(Err(error)) => fail(error.status(), error.message()),
        Err(panic) => fail(Status::TASK, &format!("panicked: {}", reason(panic.as_ref()))),
    }
}

/// Hands the message to the library, for the error of the call that runs the task.
fn fail(status: Status, message: &str) -> sys::mimo_status {
    let message = c_string(&message.replace('\0', "?")).unwrap_or_default();
    unsafe { sys::mimo_fail(status.raw(), message.as_ptr()) }
}

/// The text of a panic: `panic!` leaves one of two types.
fn reason(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no reason given")
}
