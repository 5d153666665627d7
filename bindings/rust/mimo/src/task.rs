//! Tasks of one's own, which run inside reset and step, in a batch on all of its threads.
use crate::error::{c_string, Kind, Result};
use crate::sys;
use crate::world::World;
use std::any::Any;
use std::fmt;
use std::os::raw::c_void;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Arc;

/// What a task says of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Judgement {
    /// The step's reward.
    pub reward: f64,
    /// `Some(true)`: the episode has ended well; `Some(false)`: badly; `None`: it goes on.
    pub success: Option<bool>,
}

/// Of whom a task is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Whom {
    /// Number of the world in its batch; 0 for a single one.
    pub world: usize,
    /// Number of the infant.
    pub agent: usize,
}

/// A task of one's own, for [`Scene::set_task`](crate::Scene::set_task). The worlds of a batch call it at the same time, on
/// different threads. A panic is caught, and the call that ran the task then fails, as it does for an error, and quotes it.
pub trait Task: Send + Sync {
    /// How many numbers each world and agent keeps for the task. They are 0 at the start of an episode, and part of the
    /// world's state.
    fn memory(&self) -> usize {
        0
    }

    /// Prepares an episode, in a world that is at its start. Resets, steps and loading a state are refused here.
    fn reset(&self, world: &mut World, whom: Whom, memory: &mut [f64]) -> Result<()> {
        let _ = (world, whom, memory);
        Ok(())
    }

    /// Judges a step. Positions of bodies are those of the start of the last physics step.
    fn evaluate(&self, world: &World, whom: Whom, memory: &mut [f64]) -> Result<Judgement>;
}

/// What the library keeps a pointer to.
pub(crate) struct Kept {
    task: Box<dyn Task>,
    // As it was when the library was told.
    memory: usize,
}

impl fmt::Debug for Kept {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("Task").field("memory", &self.memory).finish_non_exhaustive()
    }
}

/// Whoever owns a handle made with a task owns a share of it.
pub(crate) type Shared = Arc<Kept>;

pub(crate) fn shared(task: impl Task + 'static) -> Shared {
    let memory = task.memory();
    Arc::new(Kept { task: Box::new(task), memory })
}

pub(crate) fn raw(task: &Shared) -> Result<sys::mimo_task> {
    let mut raw = crate::config::defaults(sys::mimo_task_init)?;
    raw.user = Arc::as_ptr(task) as *mut c_void;
    raw.memory_bytes = task.memory.saturating_mul(std::mem::size_of::<f64>());
    raw.reset = Some(reset);
    raw.evaluate = Some(evaluate);
    Ok(raw)
}

/// # Safety
/// `user` is a task of `raw`, and `memory` what that asked for.
unsafe fn parts<'a>(user: *mut c_void, memory: *mut c_void) -> (&'a dyn Task, &'a mut [f64]) {
    let kept = &*(user as *const Kept);
    let memory = match kept.memory {
        0 => &mut [],
        count => std::slice::from_raw_parts_mut(memory as *mut f64, count),
    };
    (kept.task.as_ref(), memory)
}

unsafe extern "C" fn reset(
    user: *mut c_void,
    env: *mut sys::mimo_env,
    world: usize,
    agent: usize,
    memory: *mut c_void,
) -> sys::mimo_status {
    let (task, memory) = parts(user, memory);
    status(|| task.reset(World::of(env), Whom { world, agent }, memory))
}

unsafe extern "C" fn evaluate(
    user: *mut c_void,
    env: *const sys::mimo_env,
    world: usize,
    agent: usize,
    memory: *mut c_void,
    reward: *mut f64,
    outcome: *mut i32,
) -> sys::mimo_status {
    let (task, memory) = parts(user, memory);
    status(|| {
        let judged = task.evaluate(World::of(env as *mut sys::mimo_env), Whom { world, agent }, memory)?;
        *reward = judged.reward;
        *outcome = match judged.success {
            None => sys::MIMO_OUTCOME_NONE as i32,
            Some(true) => sys::MIMO_OUTCOME_SUCCESS as i32,
            Some(false) => sys::MIMO_OUTCOME_FAILURE,
        };
        Ok(())
    })
}

/// A panic must not cross the C frames above.
fn status(work: impl FnOnce() -> Result<()>) -> sys::mimo_status {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(())) => sys::MIMO_OK as i32,
        Ok(Err(error)) => fail(error.kind(), error.message()),
        Err(panic) => fail(Kind::Internal, &format!("panicked: {}", reason(panic.as_ref()))),
    }
}

/// The call that runs the task then says why.
fn fail(kind: Kind, message: &str) -> sys::mimo_status {
    let message = c_string(&message.replace('\0', "?")).unwrap_or_default();
    unsafe { sys::mimo_fail(kind.status(), message.as_ptr()) }
}

/// What a panic said: `panic!` leaves a text of one of two types.
fn reason(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no reason given")
}
