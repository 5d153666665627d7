//! How episodes start.
use crate::error::{Error, Kind, Result};
use crate::structs::sized;
use crate::sys;
use std::ptr::null;

/// How an episode starts: the random numbers go on, unless a seed is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reset {
    seed: Option<u64>,
}

impl Reset {
    /// The random numbers go on.
    pub fn new() -> Reset {
        Reset::default()
    }

    /// The random numbers start anew from this number.
    pub fn seed(self, seed: u64) -> Reset {
        Reset { seed: Some(seed) }
    }

    pub(crate) fn raw(&self) -> sys::mimo_reset_config {
        let (seeded, seed) = self.seed.map_or((0, 0), |seed| (1, seed));
        sys::mimo_reset_config { seeded, seed, ..sized() }
    }
}

/// Which worlds of a batch start an episode, and how: all, with their own random numbers, unless told otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BatchReset<'a> {
    seeds: Option<&'a [u64]>,
    mask: Option<&'a [bool]>,
}

impl<'a> BatchReset<'a> {
    /// All worlds, with their own random numbers.
    pub fn new() -> BatchReset<'a> {
        BatchReset::default()
    }

    /// One seed for each world.
    pub fn seeds(self, seeds: &'a [u64]) -> BatchReset<'a> {
        BatchReset { seeds: Some(seeds), ..self }
    }

    /// Only the worlds whose entry is true; the others, and their blocks, stay as they are.
    pub fn mask(self, mask: &'a [bool]) -> BatchReset<'a> {
        BatchReset { mask: Some(mask), ..self }
    }

    pub(crate) fn raw(&self) -> Result<sys::mimo_batch_reset_config> {
        let (seeds, seed_count) = self.seeds.map_or((null(), 0), |seeds| (seeds.as_ptr(), seeds.len()));
        let (mask, mask_length) = chosen(self.mask);
        // C knows one length for both.
        if self.seeds.is_some() && self.mask.is_some() && seed_count != mask_length {
            let message =
                format!("mask has {} entries, expected {}, as many as seeds", mask_length, seed_count);
            return Err(Error::new(Kind::InvalidArgument, message));
        }
        Ok(sys::mimo_batch_reset_config { seeds, mask, worlds: seed_count.max(mask_length), ..sized() })
    }
}

/// A mask as C has it, and its length. `bool` is a byte of 0 or 1.
pub(crate) fn chosen(mask: Option<&[bool]>) -> (*const u8, usize) {
    mask.map_or((null(), 0), |mask| (mask.as_ptr().cast(), mask.len()))
}
