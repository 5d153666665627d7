//! Memory for observations, and typed views of it.
use crate::constants::{FieldType, Status};
use crate::error::{Error, Result};
use crate::field::Field;
use std::fmt;
use std::os::raw::c_void;
use std::ptr::null_mut;
use std::sync::Arc;

/// A block consists of lines, so that fields lie at multiples of 64 bytes in memory, too.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// Memory for the observations of one world, or of all worlds of a batch. It knows its fields.
#[derive(Clone)]
pub struct Block {
    lines: Vec<Line>,
    world_bytes: usize,
    fields: Arc<[Field]>,
}

// A block prints its fields, not its millions of bytes.
impl fmt::Debug for Block {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let worlds = self.worlds();
        out.debug_struct("Block")
            .field("worlds", &worlds)
            .field("fields", &self.fields)
            .finish_non_exhaustive()
    }
}

impl Block {
    pub(crate) fn new(world_bytes: usize, worlds: usize, fields: Arc<[Field]>) -> Block {
        // The library's sizes are multiples of 64. A smaller block would be too short for its fields.
        let lines = vec![Line([0; 64]); world_bytes / 64 * worlds];
        Block { lines, world_bytes, fields }
    }

    /// All bytes, world after world.
    pub fn as_bytes(&self) -> &[u8] {
        unsafe { std::slice::from_raw_parts(self.lines.as_ptr() as *const u8, self.lines.len() * 64) }
    }

    /// All bytes, for example to normalise them. Every step overwrites every byte.
    pub fn as_bytes_mut(&mut self) -> &mut [u8] {
        unsafe { std::slice::from_raw_parts_mut(self.lines.as_mut_ptr() as *mut u8, self.lines.len() * 64) }
    }

    /// The number of worlds whose observations it holds.
    pub fn worlds(&self) -> usize {
        self.as_bytes().len() / self.world_bytes.max(1)
    }

    /// The observation of one world. Panics if there is no such world, as an index does.
    pub fn world(&self, world: usize) -> Observation<'_> {
        let start = world * self.world_bytes;
        Observation { bytes: &self.as_bytes()[start..start + self.world_bytes], fields: &self.fields }
    }

    /// The fields, in the order of the block.
    pub fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// A `u8` field of the first world; see [`Observation::u8`].
    pub fn u8(&self, name: &str) -> Result<&[u8]> {
        self.world(0).u8(name)
    }

    /// An `i32` field of the first world; see [`Observation::i32`].
    pub fn i32(&self, name: &str) -> Result<&[i32]> {
        self.world(0).i32(name)
    }

    /// An `f32` field of the first world; see [`Observation::f32`].
    pub fn f32(&self, name: &str) -> Result<&[f32]> {
        self.world(0).f32(name)
    }

    /// An `f64` field of the first world; see [`Observation::f64`].
    pub fn f64(&self, name: &str) -> Result<&[f64]> {
        self.world(0).f64(name)
    }
}

/// Pointer and length of a block for the library; NULL and 0 without a block.
pub(crate) fn memory(block: Option<&mut Block>) -> (*mut c_void, usize) {
    match block {
        Some(block) => (block.lines.as_mut_ptr().cast(), block.as_bytes().len()),
        None => (null_mut(), 0),
    }
}

/// The observation of one world: its part of a block.
#[derive(Clone, Copy)]
pub struct Observation<'a> {
    bytes: &'a [u8],
    fields: &'a [Field],
}

impl fmt::Debug for Observation<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("Observation").field("fields", &self.fields).finish_non_exhaustive()
    }
}

impl<'a> Observation<'a> {
    /// All its bytes.
    pub fn as_bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// A field of bytes: colour pictures, height x width x 3, row 0 is the top. No copy.
    pub fn u8(&self, name: &str) -> Result<&'a [u8]> {
        self.view(name, FieldType::U8)
    }

    /// A field of integers: segmentation, height x width. No copy.
    pub fn i32(&self, name: &str) -> Result<&'a [i32]> {
        self.view(name, FieldType::I32)
    }

    /// A field of single precision numbers: all senses except colour and segmentation. No copy.
    pub fn f32(&self, name: &str) -> Result<&'a [f32]> {
        self.view(name, FieldType::F32)
    }

    /// A field of double precision numbers. No copy.
    pub fn f64(&self, name: &str) -> Result<&'a [f64]> {
        self.view(name, FieldType::F64)
    }

    /// `T` is the type that `dtype` stands for. All its bit patterns are valid.
    fn view<T>(&self, name: &str, dtype: FieldType) -> Result<&'a [T]> {
        let field = self.find(name)?;
        if field.dtype != dtype {
            let message = format!("the field \"{}\" has the type {:?}, not {:?}", name, field.dtype, dtype);
            return Err(Error::new(Status::INVALID_ARGUMENT, message));
        }
        let bytes = &self.bytes[field.bytes.clone()];
        assert_eq!(bytes.as_ptr().align_offset(std::mem::align_of::<T>()), 0);
        let count = bytes.len() / std::mem::size_of::<T>();
        Ok(unsafe { std::slice::from_raw_parts(bytes.as_ptr() as *const T, count) })
    }

    fn find(&self, name: &str) -> Result<&'a Field> {
        self.fields.iter().find(|field| field.name == name).ok_or_else(|| {
            let names: Vec<&str> = self.fields.iter().map(|field| field.name.as_str()).collect();
            let message = format!("no field is named \"{}\"; there are: {}", name, names.join(", "));
            Error::new(Status::NOT_FOUND, message)
        })
    }
}
