//! The results of steps, except observations.
use crate::block::{memory, Block};
use crate::constants::{Outcome, Status};
use crate::error::{Error, Result};
use crate::layout::Layout;
use crate::structs::sized;
use crate::sys;

/// The result of a step for a single agent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// Reward of the task.
    pub reward: f64,
    /// The episode has ended by success or failure.
    pub terminated: bool,
    /// The episode is cut off: by its step limit, or by its task.
    pub truncated: bool,
    /// Success, failure or neither.
    pub outcome: Outcome,
}

impl Step {
    /// For the library to write to.
    pub(crate) fn new() -> Step {
        Step { reward: 0.0, terminated: false, truncated: false, outcome: Outcome::NONE }
    }

    pub(crate) fn raw(&mut self) -> sys::mimo_env_results {
        sys::mimo_env_results {
            reward: &mut self.reward,
            terminated: flags(std::slice::from_mut(&mut self.terminated)),
            truncated: flags(std::slice::from_mut(&mut self.truncated)),
            outcome: outcomes(std::slice::from_mut(&mut self.outcome)),
            agent_count: 1,
            ..sized()
        }
    }
}

/// The results of a step for all agents of a world, with the terms of their rewards.
/// [`World::new_results`](crate::World::new_results) makes it, and each step overwrites it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Results {
    /// One for each agent.
    pub reward: Vec<f64>,
    /// Whether the agent's episode has ended by success or failure.
    pub terminated: Vec<bool>,
    /// Whether the agent's episode is cut off: by its step limit, or by its task.
    pub truncated: Vec<bool>,
    /// Success, failure or neither.
    pub outcome: Vec<Outcome>,
    /// The terms that rewards are the sums of, as [`Layout::terms`] names them.
    pub terms: Vec<f64>,
}

impl Results {
    pub(crate) fn of(layout: &Layout) -> Results {
        let agents = layout.agent_count();
        Results {
            reward: vec![0.0; agents],
            terminated: vec![false; agents],
            truncated: vec![false; agents],
            outcome: vec![Outcome::NONE; agents],
            terms: vec![0.0; layout.term_count()],
        }
    }

    /// For the library, which writes to these vectors. They must not move until then.
    pub(crate) fn raw(&mut self) -> Result<sys::mimo_env_results> {
        let agents = self.reward.len();
        same_length(agents, &[self.terminated.len(), self.truncated.len(), self.outcome.len()])?;
        Ok(sys::mimo_env_results {
            reward: self.reward.as_mut_ptr(),
            terminated: flags(&mut self.terminated),
            truncated: flags(&mut self.truncated),
            outcome: outcomes(&mut self.outcome),
            agent_count: agents,
            terms: self.terms.as_mut_ptr(),
            term_count: self.terms.len(),
            ..sized()
        })
    }
}

/// The results of a step of a batch, except the observations.
/// [`Batch::new_results`](crate::Batch::new_results) makes it, and each step overwrites it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct BatchResults {
    /// Rewards, worlds x agents.
    pub reward: Vec<f64>,
    /// Whether an episode has ended by success or failure, worlds x agents.
    pub terminated: Vec<bool>,
    /// Whether an episode is cut off: by its step limit, or by its task, worlds x agents.
    pub truncated: Vec<bool>,
    /// Success, failure or neither, worlds x agents.
    pub outcome: Vec<Outcome>,
    /// The terms that rewards are the sums of, worlds x [`Layout::terms`].
    pub terms: Vec<f64>,
    /// The status of each world's simulation, also if a failed world was restarted.
    pub status: Vec<Status>,
    /// Whether this step started a new episode in a world: its observation is then the first of the episode.
    pub was_reset: Vec<bool>,
    /// Whether the final block of a world was written.
    pub final_written: Vec<bool>,
    /// With [`Autoreset::SAME_STEP`](crate::Autoreset::SAME_STEP): the last observations of the episodes that
    /// ended. None: not written.
    pub final_blocks: Option<Block>,
}

impl BatchResults {
    pub(crate) fn of(layout: &Layout, worlds: usize) -> BatchResults {
        let agents = worlds * layout.agent_count();
        BatchResults {
            reward: vec![0.0; agents],
            terminated: vec![false; agents],
            truncated: vec![false; agents],
            outcome: vec![Outcome::NONE; agents],
            terms: vec![0.0; worlds * layout.term_count()],
            status: vec![Status::OK; worlds],
            was_reset: vec![false; worlds],
            final_written: vec![false; worlds],
            final_blocks: None,
        }
    }

    /// For the library, which writes to these vectors. They must not move until then.
    pub(crate) fn raw(&mut self) -> Result<sys::mimo_batch_results> {
        let (agents, worlds) = (self.reward.len(), self.status.len());
        same_length(agents, &[self.terminated.len(), self.truncated.len(), self.outcome.len()])?;
        same_length(worlds, &[self.was_reset.len(), self.final_written.len()])?;
        let (final_blocks, final_bytes) = memory(self.final_blocks.as_mut());
        Ok(sys::mimo_batch_results {
            reward: self.reward.as_mut_ptr(),
            terminated: flags(&mut self.terminated),
            truncated: flags(&mut self.truncated),
            outcome: outcomes(&mut self.outcome),
            agent_count: agents,
            terms: self.terms.as_mut_ptr(),
            term_count: self.terms.len(),
            status: self.status.as_mut_ptr().cast(),
            was_reset: flags(&mut self.was_reset),
            final_written: flags(&mut self.final_written),
            worlds,
            final_blocks,
            final_bytes,
            ..sized()
        })
    }
}

/// C has one length for each group of arrays.
fn same_length(expected: usize, lengths: &[usize]) -> Result<()> {
    if lengths.iter().all(|&length| length == expected) {
        return Ok(());
    }
    let message = format!("arrays of the results have lengths {:?}, expected {} each", lengths, expected);
    Err(Error::new(Status::INVALID_ARGUMENT, message))
}

fn outcomes(outcomes: &mut [Outcome]) -> *mut i32 {
    outcomes.as_mut_ptr().cast()
}

/// The library writes 0 and 1, which are valid bools.
fn flags(flags: &mut [bool]) -> *mut u8 {
    flags.as_mut_ptr().cast()
}
