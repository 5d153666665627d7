//! What stands where in a block.
use crate::constants::FieldType;
use crate::error::text;
use crate::sys;
use std::ops::Range;

/// One field of an observation block.
///
/// What a step gives belongs to the time from `start` to `end`, in seconds after the step's end: both are 0 for what is
/// true then, both are negative for what is late or belongs to the start of the last physics step, and `start` is before
/// `end` for what was gathered meanwhile. After a reset, and from [`World::observe`](crate::World::observe), it belongs to
/// now, but for what is late.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Field {
    /// Path, "proprioception/position"; fields of a named agent start with its name.
    pub name: String,
    /// Unit, "rad"; "" for none.
    pub unit: String,
    /// Frame of reference, "joint", "camera"; "" for none.
    pub frame: String,
    /// Type of the elements.
    pub dtype: FieldType,
    /// Dimensions, C order.
    pub shape: Vec<usize>,
    /// Where it lies in the block of one world, bytes.
    pub bytes: Range<usize>,
    /// Smallest possible value; -infinity where there is none.
    pub low: f64,
    /// Largest possible value; infinity where there is none.
    pub high: f64,
    /// Seconds after the step's end, <= 0.
    pub start: f64,
    /// Seconds after the step's end, `start` <= `end` <= 0.
    pub end: f64,
    /// Seconds from one new value to the next: those of a step.
    pub period: f64,
    /// On how many receptors of the skin it reports, in the order of its first axis; 0: it is not of skin.
    pub receptors: usize,
    /// Of sound, samples a second, the oldest first; 0: it is no sound.
    pub sample_rate: f64,
}

impl Field {
    /// The library's description, which lies in a block as it says.
    ///
    /// # Safety
    /// The library has filled it, and its owner lives.
    pub(crate) unsafe fn of(raw: &sys::mimo_field) -> Field {
        Field {
            name: text(raw.name),
            unit: text(raw.unit),
            frame: text(raw.frame),
            dtype: FieldType::from_raw(raw.dtype),
            shape: std::slice::from_raw_parts(raw.shape, raw.ndim).to_vec(),
            bytes: raw.offset..raw.offset + raw.bytes,
            low: raw.low,
            high: raw.high,
            start: raw.start,
            end: raw.end,
            period: raw.period,
            receptors: raw.receptors,
            sample_rate: raw.sample_rate,
        }
    }
}
