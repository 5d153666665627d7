//! What the library brings along, by name.
use crate::error::{check, text, Result};
use crate::structs::described;
use crate::sys;
use std::os::raw::c_char;

/// Names of the built-in scenes.
pub fn builtin_scenes() -> Vec<String> {
    names(sys::mimo_scene_name)
}

/// Names of the rooms for [`Scene::set_room`](crate::Scene::set_room).
pub fn rooms() -> Vec<String> {
    names(sys::mimo_room_name)
}

/// Names of the faces of the built-in bodies.
pub fn faces() -> Vec<String> {
    names(sys::mimo_face_name)
}

/// Names of the materials for [`Scene::set_material`](crate::Scene::set_material).
pub fn materials() -> Vec<String> {
    names(sys::mimo_material_name)
}

/// Names of the tasks for [`EnvConfig::task`](crate::EnvConfig::task).
pub fn tasks() -> Vec<String> {
    names(sys::mimo_task_name)
}

fn names(by_index: unsafe extern "C" fn(usize) -> *const c_char) -> Vec<String> {
    (0..).map(|index| text(unsafe { by_index(index) })).take_while(|name| !name.is_empty()).collect()
}

/// A number by which a task can be changed, with [`Scene::set_parameter`](crate::Scene::set_parameter).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// "reach/success_reward".
    pub name: String,
    /// One line, with unit.
    pub description: String,
    /// Value unless set.
    pub standard: f64,
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
}

/// The parameters of all tasks.
pub fn parameters() -> Result<Vec<Parameter>> {
    let mut count = 0;
    check(unsafe { sys::mimo_parameter_count(&mut count) })?;
    (0..count).map(parameter).collect()
}

fn parameter(index: usize) -> Result<Parameter> {
    let raw: sys::mimo_parameter = described(|raw| unsafe { sys::mimo_parameter_describe(index, raw) })?;
    Ok(Parameter {
        name: text(raw.name),
        description: text(raw.description),
        standard: raw.standard,
        low: raw.low,
        high: raw.high,
    })
}
