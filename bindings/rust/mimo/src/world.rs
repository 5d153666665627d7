//! What can be done with a world, whoever owns it.
use crate::block::Block;
use crate::error::{c_string, check, text, Error, Kind, Result};
use crate::field::Field;
use crate::state::LoadReport;
use crate::sys;
use std::fmt;
use std::os::raw::c_void;
use std::ptr::{null, null_mut};

/// A simulated world. What can be done with it does not depend on who owns it: an [`Env`](crate::Env), or a
/// [`Batch`](crate::Batch).
///
/// A reference to it *is* the library's handle, and it has no size of its own: a world cannot be moved out of its
/// owner, so that a world of a batch never outlives the batch.
#[repr(C)]
pub struct World {
    opaque: [u8; 0],
    // Neither Send nor Sync by itself.
    handle_of_c: std::marker::PhantomData<*mut u8>,
}

// `&self` methods call functions that take the handle as const, `&mut self` methods the others: the header's rule.
unsafe impl Send for World {}
unsafe impl Sync for World {}

/// What a step gave, beside the observation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Step {
    /// Reward of the task.
    pub reward: f64,
    /// The episode has ended by success or failure.
    pub terminated: bool,
    /// The episode has reached its step limit.
    pub truncated: bool,
}

/// What became of an infant's task in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outcome {
    /// Neither success nor failure.
    #[default]
    Open,
    /// The episode ends well, unless it goes on.
    Success,
    /// The episode ends badly, unless it goes on.
    Failure,
}

/// Two geoms that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Ids of geom 1 and geom 2.
    pub geoms: [i32; 2],
    /// Ids of their bodies.
    pub bodies: [i32; 2],
    /// Metres, world frame.
    pub position: [f64; 3],
    /// Rows: normal from geom 1 to geom 2, two tangents; world frame.
    pub frame: [f64; 9],
    /// Metres; negative: overlap.
    pub distance: f64,
    /// Force on body 2 in that frame, N.
    pub force: [f64; 3],
    /// Torque on body 2 in that frame, Nm.
    pub torque: [f64; 3],
}

/// Two geoms that touched during a step; world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepContact {
    /// Ids of geom 1 and geom 2.
    pub geoms: [i32; 2],
    /// Ids of their bodies.
    pub bodies: [i32; 2],
    /// When they first touched, seconds since the step began.
    pub start: f64,
    /// When they last touched, seconds since the step began.
    pub end: f64,
    /// On body 2 over the whole step, N s.
    pub impulse: [f64; 3],
    /// On body 2, the largest of the physics steps', N.
    pub peak_force: [f64; 3],
    /// Of the strongest contact then, metres.
    pub peak_position: [f64; 3],
}

/// A place on the skin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchSensor {
    /// Id of the body that it sits on.
    pub body: i32,
    /// Id of the geom that it sits on.
    pub geom: i32,
    /// In the frame of the body, m.
    pub position: [f64; 3],
    /// Rows: outward normal, two tangents; in the frame of the body.
    pub frame: [f64; 9],
}

/// Pointer and length of a block for the library; no block is NULL and 0.
pub(crate) fn memory(block: Option<&mut Block>) -> (*mut c_void, usize) {
    match block {
        Some(block) => (block.as_bytes_mut().as_mut_ptr() as *mut c_void, block.as_bytes().len()),
        None => (null_mut(), 0),
    }
}

impl fmt::Debug for World {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("World").field("handle", &self.handle()).finish()
    }
}

impl World {
    /// # Safety
    /// The handle lives, is not NULL, and nobody else uses it, for as long as the reference does.
    pub(crate) unsafe fn of<'a>(handle: *mut sys::mimo_env) -> &'a mut World {
        &mut *(handle as *mut World)
    }

    /// The library's handle, for functions of [`sys`] that have no method here.
    pub fn handle(&self) -> *mut sys::mimo_env {
        self as *const World as *mut sys::mimo_env
    }

    /// The fields of its observations, in their order.
    pub fn fields(&self) -> Result<Vec<Field>> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_observation_size(self.handle(), null_mut(), &mut count) })?;
        (0..count).map(|index| self.field(index)).collect()
    }

    fn field(&self, index: usize) -> Result<Field> {
        let mut raw: sys::mimo_field = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of_val(&raw) as u32;
        check(unsafe { sys::mimo_env_observation_field(self.handle(), index, &mut raw) })?;
        Field::of(&raw).ok_or_else(|| Error::new(Kind::Unsupported, format!("unknown dtype {}", raw.dtype)))
    }

    /// Size of an observation block in bytes, a multiple of 64.
    pub fn block_bytes(&self) -> Result<usize> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_env_observation_size(self.handle(), &mut bytes, null_mut()) })?;
        Ok(bytes)
    }

    /// Memory for its observations, zero at first.
    pub fn new_block(&self) -> Result<Block> {
        self.new_blocks(1)
    }

    pub(crate) fn new_blocks(&self, worlds: usize) -> Result<Block> {
        Ok(Block::new(self.block_bytes()?, worlds, self.fields()?.into()))
    }

    /// Number of actions of all agents together.
    pub fn action_size(&self) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_action_size(self.handle(), &mut count) })?;
        Ok(count)
    }

    /// Lower and upper bounds of the actions.
    pub fn action_bounds(&self) -> Result<(Vec<f32>, Vec<f32>)> {
        let count = self.action_size()?;
        let (mut low, mut high) = (vec![0.0; count], vec![0.0; count]);
        check(unsafe {
            sys::mimo_env_action_bounds(self.handle(), low.as_mut_ptr(), high.as_mut_ptr(), count)
        })?;
        Ok((low, high))
    }

    /// Name of an action, its actuator's: "act:left_elbow".
    pub fn action_name(&self, index: usize) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_action_name(self.handle(), index, &mut name) })?;
        Ok(text(name))
    }

    /// Number of agents.
    pub fn agent_count(&self) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_agent_count(self.handle(), &mut count) })?;
        Ok(count)
    }

    /// Starts an episode. Without a seed the world goes on with its own random numbers; without a block nothing is
    /// observed.
    pub fn reset(&mut self, seed: Option<u64>, block: Option<&mut Block>) -> Result<()> {
        let (bytes, count) = memory(block);
        let seed = seed.as_ref().map_or(null(), |seed| seed as *const u64);
        check(unsafe { sys::mimo_env_reset(self.handle(), seed, bytes, count) })
    }

    /// Goes one step on, in a world of one agent. No actions leave the controls as they are; actions are clipped to
    /// their bounds, NaN is refused. Without a block the senses are skipped. Where there are several agents, use
    /// [`step_agents`](Self::step_agents).
    pub fn step(&mut self, action: &[f32], block: Option<&mut Block>) -> Result<Step> {
        let mut step = Step::default();
        self.step_agents(action, block, std::slice::from_mut(&mut step))?;
        Ok(step)
    }

    /// Goes one step on. `action` holds the actions of all agents, `steps` receives what each of them got.
    pub fn step_agents(
        &mut self,
        action: &[f32],
        block: Option<&mut Block>,
        steps: &mut [Step],
    ) -> Result<()> {
        // A step allocates nothing: the arrays of C live on the stack, which is enough for a crowd.
        const CROWD: usize = 64;
        if steps.len() > CROWD {
            return Err(Error::new(
                Kind::InvalidArgument,
                format!("{} agents, expected up to {}", steps.len(), CROWD),
            ));
        }
        let (mut reward, mut terminated, mut truncated) = ([0.0; CROWD], [0; CROWD], [0; CROWD]);
        let (bytes, count) = memory(block);
        check(unsafe {
            sys::mimo_env_step(
                self.handle(),
                if action.is_empty() { null() } else { action.as_ptr() },
                action.len(),
                bytes,
                count,
                reward.as_mut_ptr(),
                terminated.as_mut_ptr(),
                truncated.as_mut_ptr(),
                steps.len(),
            )
        })?;
        for (i, step) in steps.iter_mut().enumerate() {
            *step = Step { reward: reward[i], terminated: terminated[i] != 0, truncated: truncated[i] != 0 };
        }
        Ok(())
    }

    /// The observation of the current state, without changing the trajectory.
    pub fn observe(&mut self, block: &mut Block) -> Result<()> {
        let (bytes, count) = memory(Some(block));
        check(unsafe { sys::mimo_env_observe(self.handle(), bytes, count) })
    }

    /// Simulated seconds since reset.
    pub fn time(&self) -> Result<f64> {
        let mut seconds = 0.0;
        check(unsafe { sys::mimo_env_time(self.handle(), &mut seconds) })?;
        Ok(seconds)
    }

    /// How many of a kind (`MIMO_BODY` ...) there are; their ids are 0 to one less.
    pub fn count(&self, kind: u32) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_count(self.handle(), kind as i32, &mut count) })?;
        Ok(count)
    }

    /// The id of something (`MIMO_BODY` ...) by its name in the model.
    pub fn find(&self, kind: u32, name: &str) -> Result<i32> {
        let name = c_string(name)?;
        let mut id = 0;
        check(unsafe { sys::mimo_env_find(self.handle(), kind as i32, name.as_ptr(), &mut id) })?;
        Ok(id)
    }

    /// The name of something; "" where the model gives none.
    pub fn name(&self, kind: u32, id: i32) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_name(self.handle(), kind as i32, id, &mut name) })?;
        Ok(text(name))
    }

    /// How many values a quantity (`MIMO_BODY_POSITION` ...) has for these ids together.
    pub fn width(&self, quantity: u32, ids: &[i32]) -> Result<usize> {
        let mut count = 0;
        check(unsafe {
            sys::mimo_env_width(self.handle(), quantity as i32, ids.as_ptr(), ids.len(), &mut count)
        })?;
        Ok(count)
    }

    /// Reads a quantity of many at once into `values`, which is as long as [`width`](Self::width) says.
    pub fn get_into(&self, quantity: u32, ids: &[i32], values: &mut [f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of many at once.
    pub fn get(&self, quantity: u32, ids: &[i32]) -> Result<Vec<f64>> {
        let mut values = vec![0.0; self.width(quantity, ids)?];
        self.get_into(quantity, ids, &mut values)?;
        Ok(values)
    }

    /// Writes a quantity of many at once.
    pub fn set(&mut self, quantity: u32, ids: &[i32], values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of all that there are of its kind.
    pub fn get_all(&self, quantity: u32) -> Result<Vec<f64>> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_width(self.handle(), quantity as i32, null(), 0, &mut count) })?;
        let mut values = vec![0.0; count];
        check(unsafe {
            sys::mimo_env_get(self.handle(), quantity as i32, null(), 0, values.as_mut_ptr(), count)
        })?;
        Ok(values)
    }

    /// Writes a quantity of all that there are of its kind.
    pub fn set_all(&mut self, quantity: u32, values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(self.handle(), quantity as i32, null(), 0, values.as_ptr(), values.len())
        })
    }

    /// The same as [`get_into`](Self::get_into) in single precision, for engines.
    pub fn get_f32_into(&self, quantity: u32, ids: &[i32], values: &mut [f32]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get_float(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// The contacts that the last physics step computed, with their forces.
    pub fn contacts(&self) -> Result<Vec<Contact>> {
        let geoms = self.get_all(sys::MIMO_CONTACT_GEOMS)?;
        let bodies = self.get_all(sys::MIMO_CONTACT_BODIES)?;
        let positions = self.get_all(sys::MIMO_CONTACT_POSITION)?;
        let frames = self.get_all(sys::MIMO_CONTACT_FRAME)?;
        let distances = self.get_all(sys::MIMO_CONTACT_DISTANCE)?;
        let forces = self.get_all(sys::MIMO_CONTACT_FORCE)?;
        let torques = self.get_all(sys::MIMO_CONTACT_TORQUE)?;
        let contact = |i: usize| Contact {
            geoms: row(&geoms, i).map(|id| id as i32),
            bodies: row(&bodies, i).map(|id| id as i32),
            position: row(&positions, i),
            frame: row(&frames, i),
            distance: distances[i],
            force: row(&forces, i),
            torque: row(&torques, i),
        };
        Ok((0..distances.len()).map(contact).collect())
    }

    /// What touched what during the last step, in worlds made with [`EnvConfig::step_contacts`](crate::EnvConfig).
    pub fn step_contacts(&self) -> Result<Vec<StepContact>> {
        let geoms = self.get_all(sys::MIMO_STEP_CONTACT_GEOMS)?;
        let bodies = self.get_all(sys::MIMO_STEP_CONTACT_BODIES)?;
        let starts = self.get_all(sys::MIMO_STEP_CONTACT_START)?;
        let ends = self.get_all(sys::MIMO_STEP_CONTACT_END)?;
        let impulses = self.get_all(sys::MIMO_STEP_CONTACT_IMPULSE)?;
        let forces = self.get_all(sys::MIMO_STEP_CONTACT_PEAK_FORCE)?;
        let positions = self.get_all(sys::MIMO_STEP_CONTACT_PEAK_POSITION)?;
        let contact = |i: usize| StepContact {
            geoms: row(&geoms, i).map(|id| id as i32),
            bodies: row(&bodies, i).map(|id| id as i32),
            start: starts[i],
            end: ends[i],
            impulse: row(&impulses, i),
            peak_force: row(&forces, i),
            peak_position: row(&positions, i),
        };
        Ok((0..starts.len()).map(contact).collect())
    }

    /// Recomputes poses from the current joint positions. The trajectory stays as it was.
    pub fn update(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_update(self.handle()) })
    }

    /// The body that a joint, geom, site or camera belongs to, or the parent of a body.
    pub fn body_of(&self, kind: u32, id: i32) -> Result<i32> {
        let mut body = 0;
        check(unsafe { sys::mimo_env_body_of(self.handle(), kind as i32, id, &mut body) })?;
        Ok(body)
    }

    /// Whether an agent's last step was a success or a failure, also where that does not end the episode.
    pub fn outcome(&self, agent: usize) -> Result<Outcome> {
        let (mut success, mut failure) = (0, 0);
        check(unsafe { sys::mimo_env_outcome(self.handle(), agent, &mut success, &mut failure) })?;
        Ok(match (success, failure) {
            (0, 0) => Outcome::Open,
            (0, _) => Outcome::Failure,
            _ => Outcome::Success,
        })
    }

    /// Numbers from 0 to 1 from the world's own random stream, which is part of its state.
    pub fn random(&mut self, values: &mut [f64]) -> Result<()> {
        let values = if values.is_empty() { (null_mut(), 0) } else { (values.as_mut_ptr(), values.len()) };
        check(unsafe { sys::mimo_env_random(self.handle(), values.0, values.1) })
    }

    /// Where an infant's skin feels, in the order of its touch fields; empty where touch is off.
    pub fn touch_sensors(&self, agent: usize) -> Result<Vec<TouchSensor>> {
        const FRAME: usize = sys::MIMO_TOUCH_FRAME_VALUES as usize;
        let (env, mut n) = (self.handle(), 0);
        let ask = |ids: [*mut i32; 2], values: [*mut f64; 2], room, n: &mut usize| {
            check(unsafe {
                sys::mimo_env_touch_sensors(env, agent, ids[0], ids[1], values[0], values[1], room, n)
            })
        };
        ask([null_mut(); 2], [null_mut(); 2], 0, &mut n)?;
        let (mut bodies, mut geoms) = (vec![0; n], vec![0; n]);
        let (mut places, mut frames) = (vec![[0.0; 3]; n], vec![[0.0; FRAME]; n]);
        let values = [places.as_mut_ptr() as *mut f64, frames.as_mut_ptr() as *mut f64];
        ask([bodies.as_mut_ptr(), geoms.as_mut_ptr()], values, n, &mut n)?;
        let sensor =
            |i| TouchSensor { body: bodies[i], geom: geoms[i], position: places[i], frame: frames[i] };
        Ok((0..n).map(sensor).collect())
    }

    /// Everything that the world's future depends on, as bytes.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_env_state_size(self.handle(), &mut bytes) })?;
        let mut state = vec![0; bytes];
        check(unsafe { sys::mimo_env_state_save(self.handle(), state.as_mut_ptr() as *mut c_void, bytes) })?;
        Ok(state)
    }

    /// Goes on from a state of a world of the same model, agents and task, exactly as that one did. What it lacks of a
    /// delay starts fresh.
    pub fn load(&mut self, state: &[u8]) -> Result<LoadReport> {
        let from = state.as_ptr() as *const c_void;
        LoadReport::of(|report| unsafe { sys::mimo_env_state_load(self.handle(), from, state.len(), report) })
    }
}

/// The i-th of rows that lie one behind the other.
fn row<const N: usize>(values: &[f64], i: usize) -> [f64; N] {
    let mut row = [0.0; N];
    row.copy_from_slice(&values[N * i..N * (i + 1)]);
    row
}
