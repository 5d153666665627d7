//! What stands where in a block.
use crate::sys;
use std::ops::Range;

/// Type of a field's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// One field of an observation block.
#[derive(Clone, Debug, PartialEq)]
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
    /// Whether it belongs to the end of a step; else to the start of the last physics step.
    pub at_end: bool,
    /// Smallest possible value; -infinity where there is none.
    pub low: f64,
    /// Largest possible value; infinity where there is none.
    pub high: f64,
}

impl Field {
    /// The description of a field by the library, which lies in a block as it says. None for a type of elements that
    /// this crate does not know.
    pub(crate) fn of(raw: &sys::mimo_field) -> Option<Field> {
        let dtype = match raw.dtype as u32 {
            sys::MIMO_U8 => Type::U8,
            sys::MIMO_I32 => Type::I32,
            sys::MIMO_F32 => Type::F32,
            sys::MIMO_F64 => Type::F64,
            _ => return None,
        };
        Some(Field {
            name: crate::error::text(raw.name),
            unit: crate::error::text(raw.unit),
            frame: crate::error::text(raw.frame),
            dtype,
            shape: raw.shape[..raw.ndim as usize].to_vec(),
            bytes: raw.offset..raw.offset + raw.bytes,
            at_end: raw.time == sys::MIMO_AT_END as i32,
            low: raw.low,
            high: raw.high,
        })
    }
}
