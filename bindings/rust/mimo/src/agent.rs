//! Infants as a world has them.
use crate::error::{text, Result};
use crate::structs::described;
use crate::sys;
use crate::world::World;
use std::ops::Range;

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
