//! The fields of a block.
use crate::constants::FieldType;
use crate::error::text;
use crate::sys;
use std::ops::Range;

/// One field of an observation block.
///
/// Its time: the value that a step writes belongs to the time from `start` to `end`, in seconds after the
/// step's end. Both are 0 for the current state, both are negative for values with a delay or of the start of
/// the last physics step, and `start` is before `end` for values that were gathered over a time. After a
/// reset, and from [`World::observe`](crate::World::observe), the value is the current one, except if it has
/// a delay.
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
    /// Its bytes in the block of one world.
    pub bytes: Range<usize>,
    /// Smallest possible value; -infinity if there is none.
    pub low: f64,
    /// Largest possible value; infinity if there is none.
    pub high: f64,
    /// Seconds after the step's end, <= 0.
    pub start: f64,
    /// Seconds after the step's end, `start` <= `end` <= 0.
    pub end: f64,
    /// Seconds between new values: the length of a step.
    pub period: f64,
    /// Number of skin receptors along its first axis; 0: not a skin field.
    pub receptors: usize,
    /// For sound: samples per second, the oldest first; 0: not a sound.
    pub sample_rate: f64,
}

impl Field {
    /// Reads the library's description.
    ///
    /// # Safety
    /// The library has filled `raw`, and its owner lives.
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
