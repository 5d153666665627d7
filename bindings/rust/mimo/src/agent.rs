//! The infants of a world.
use crate::error::{text, Result};
use crate::structs::described;
use crate::sys;
use crate::world::World;
use std::ops::Range;

/// Describes one agent of a world.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct AgentInfo {
    /// "" if it is the only agent.
    pub name: String,
    /// The range of its actions among the actions of all agents.
    pub actions: Range<usize>,
    /// Mass of its body, kg.
    pub mass: f64,
    /// Vertical extent of its geoms in the initial pose, m.
    pub height: f64,
}

impl World {
    /// Describes the index-th agent.
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
