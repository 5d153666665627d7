//! Names that the library knows.
use crate::error::{check, text, Result};
use crate::records::Parameter;
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

/// The parameters of all tasks.
pub fn parameters() -> Result<Vec<Parameter>> {
    let mut count = 0;
    check(unsafe { sys::mimo_parameter_count(&mut count) })?;
    let parameter = |index| described(|raw| unsafe { sys::mimo_parameter_describe(index, raw) });
    (0..count).map(|index| Ok(Parameter::of(&parameter(index)?))).collect()
}
