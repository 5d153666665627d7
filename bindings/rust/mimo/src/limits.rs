//! How much less an agent senses than there is to be sensed, or does than it wants.
use crate::error::Result;
use crate::structs::defaults;
use crate::sys;

/// Limits of a sense, for [`Scene::limit_sense`](crate::Scene::limit_sense), or of the way to a motor, for
/// [`Scene::limit_motor`](crate::Scene::limit_motor). First the picture is blurred, then comes the gain, then the
/// delay, then the noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Factor of all values, >= 0.
    pub gain: f64,
    /// Standard deviation of the Gaussian noise that is added, in the field's or action's unit (colours: levels of 255).
    pub noise: f64,
    /// Seconds by which it comes late, 0 to 2: the nearest whole number of time steps of the model.
    pub delay: f64,
    /// Of pictures in colour: lines this fine, in cycles per degree, keep half their contrast; 0: sharp.
    pub blur: f64,
    /// Standard deviation of further noise as a share of the value.
    pub signal_noise: f64,
}

impl Default for Limits {
    /// A perfect sense or motor.
    fn default() -> Limits {
        Limits { gain: 1.0, noise: 0.0, delay: 0.0, blur: 0.0, signal_noise: 0.0 }
    }
}

impl Limits {
    pub(crate) fn raw(&self) -> Result<sys::mimo_limits> {
        let Limits { gain, noise, delay, blur, signal_noise } = *self;
        Ok(sys::mimo_limits { gain, noise, delay, blur, signal_noise, ..defaults(sys::mimo_limits_init)? })
    }
}
