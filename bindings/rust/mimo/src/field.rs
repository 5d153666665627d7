//! What stands where in a block.
use crate::error::{text, Error, Kind, Result};
use crate::sys;
use std::ops::Range;

/// Type of a field's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Type {
    /// `u8`
    U8,
    /// `i32`
    I32,
    /// `f32`
    F32,
    /// `f64`
    F64,
}

impl Type {
    fn of(dtype: i32) -> Option<Type> {
        match dtype as u32 {
            sys::MIMO_U8 => Some(Type::U8),
            sys::MIMO_I32 => Some(Type::I32),
            sys::MIMO_F32 => Some(Type::F32),
            sys::MIMO_F64 => Some(Type::F64),
            _ => None,
        }
    }
}

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
    pub dtype: Type,
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
    pub(crate) unsafe fn of(raw: &sys::mimo_field) -> Result<Field> {
        let name = text(raw.name);
        let dtype = Type::of(raw.dtype).ok_or_else(|| {
            let message = format!("the type {} of the field \"{}\" is not known here", raw.dtype, name);
            Error::new(Kind::Unsupported, message)
        })?;
        Ok(Field {
            name,
            unit: text(raw.unit),
            frame: text(raw.frame),
            dtype,
            shape: std::slice::from_raw_parts(raw.shape, raw.ndim).to_vec(),
            bytes: raw.offset..raw.offset + raw.bytes,
            low: raw.low,
            high: raw.high,
            start: raw.start,
            end: raw.end,
            period: raw.period,
            receptors: raw.receptors,
            sample_rate: raw.sample_rate,
        })
    }
}
