//! How episodes start.
use crate::configs::Growth;
use crate::constants::Status;
use crate::error::{Error, Result};
use crate::structs::sized;
use crate::sys;
use std::ptr::null;

/// How an episode starts. Without a seed the random numbers continue.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reset<'a> {
    seed: Option<u64>,
    ages: &'a [Option<Growth>],
}

impl<'a> Reset<'a> {
    /// Without a seed: the random numbers continue.
    pub fn new() -> Reset<'a> {
        Reset::default()
    }

    /// The random numbers restart from this seed.
    pub fn seed(self, seed: u64) -> Reset<'a> {
        Reset { seed: Some(seed), ..self }
    }

    /// New ages: one for all infants of the world, or one for each; None keeps the age.
    pub fn ages(self, ages: &'a [Option<Growth>]) -> Reset<'a> {
        Reset { ages, ..self }
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_reset_config) -> R) -> R {
        let (seeded, seed) = self.seed.map_or((0, 0), |seed| (1, seed));
        let growth = pointers(self.ages);
        let (growth, growth_count) = (growth.as_ptr(), growth.len());
        use_it(&sys::mimo_reset_config { seeded, seed, growth, growth_count, ..sized() })
    }
}

/// Which worlds of a batch start an episode, and how. By default all worlds do, and their random numbers
/// continue.
#[derive(Clone, Copy, Debug, Default)]
pub struct BatchReset<'a> {
    seeds: Option<&'a [u64]>,
    mask: Option<&'a [bool]>,
    ages: Option<&'a [Option<Growth>]>,
}

impl<'a> BatchReset<'a> {
    /// All worlds; their random numbers continue.
    pub fn new() -> BatchReset<'a> {
        BatchReset::default()
    }

    /// One seed for each world.
    pub fn seeds(self, seeds: &'a [u64]) -> BatchReset<'a> {
        BatchReset { seeds: Some(seeds), ..self }
    }

    /// Only the worlds whose entry is true. The others, and their blocks, do not change.
    pub fn mask(self, mask: &'a [bool]) -> BatchReset<'a> {
        BatchReset { mask: Some(mask), ..self }
    }

    /// A new age for the infants of each world; None keeps the age.
    pub fn ages(self, ages: &'a [Option<Growth>]) -> BatchReset<'a> {
        BatchReset { ages: Some(ages), ..self }
    }

    // C has one length for all three.
    fn worlds(&self) -> Result<usize> {
        let lengths = [self.seeds.map(<[u64]>::len), self.mask.map(<[bool]>::len), self.ages.map(<[_]>::len)];
        let mut given = lengths.into_iter().flatten();
        let worlds = given.next().unwrap_or(0);
        match given.find(|&length| length != worlds) {
            None => Ok(worlds),
            Some(other) => {
                let message = format!(
                    "seeds, mask and ages have {} and {} entries, expected equal numbers",
                    worlds, other
                );
                Err(Error::new(Status::INVALID_ARGUMENT, message))
            }
        }
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_batch_reset_config) -> R) -> Result<R> {
        let worlds = self.worlds()?;
        let seeds = self.seeds.map_or(null(), |seeds| seeds.as_ptr());
        let (mask, _) = chosen(self.mask);
        let growth = self.ages.map(pointers);
        let growth = growth.as_ref().map_or(null(), |growth| growth.as_ptr());
        Ok(use_it(&sys::mimo_batch_reset_config { seeds, mask, worlds, growth, ..sized() }))
    }
}

/// Pointers for C; NULL for an age that stays.
fn pointers(ages: &[Option<Growth>]) -> Vec<*const sys::mimo_growth> {
    ages.iter().map(Growth::pointer).collect()
}

/// A mask for C, and its length. `bool` is a byte of 0 or 1.
pub(crate) fn chosen(mask: Option<&[bool]>) -> (*const u8, usize) {
    mask.map_or((null(), 0), |mask| (mask.as_ptr().cast(), mask.len()))
}
