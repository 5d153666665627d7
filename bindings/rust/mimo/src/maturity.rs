//! How mature eyes and nerves are.
use crate::error::{check, Result};
use crate::structs::{defaults, sized};
use crate::sys;
use std::mem::size_of;

/// How mature an agent's eyes and nerves are, in numbers, for [`Scene::set_maturity`](crate::Scene::set_maturity). A nerve
/// is late by its length over `conduction_speed`, and by what its way through the brain adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maturity {
    /// The finest lines that are seen, cycles per degree; 0: pictures as drawn.
    pub acuity: f64,
    /// The greatest contrast sensitivity.
    pub peak_contrast: f64,
    /// Share of colour that is seen, 0 (grey) to 1.
    pub chroma: f64,
    /// Faster changes are seen less and less, Hz; 0: all are seen.
    pub flicker: f64,
    /// Contrasts too faint for such eyes are gone.
    pub contrast_threshold: bool,
    /// Of large nerve fibres, m/s; 0: they take no time.
    pub conduction_speed: f64,
    /// From the brain stem to the cortex, s.
    pub sensory_delay: f64,
    /// From the cortex to the brain stem, s.
    pub motor_delay: f64,
    /// From the eye to the cortex, s.
    pub vision_delay: f64,
    /// From the inner ear to the brain stem, s.
    pub vestibular_delay: f64,
    /// From the ear to the cortex, s.
    pub hearing_delay: f64,
}

impl Default for Maturity {
    /// Perfect eyes, and nerves that take no time.
    fn default() -> Maturity {
        Maturity {
            acuity: 0.0,
            peak_contrast: 2.0,
            chroma: 1.0,
            flicker: 0.0,
            contrast_threshold: false,
            conduction_speed: 0.0,
            sensory_delay: 0.0,
            motor_delay: 0.0,
            vision_delay: 0.0,
            vestibular_delay: 0.0,
            hearing_delay: 0.0,
        }
    }
}

impl Maturity {
    /// That of an age, 0 (a newborn) to 24 months; flicker and contrast_threshold, which are options, stay off.
    pub fn of_age(months: f64) -> Result<Maturity> {
        let mut raw: sys::mimo_maturity = sized();
        check(unsafe { sys::mimo_maturity_at(months, &mut raw, size_of::<sys::mimo_maturity>()) })?;
        Ok(Maturity {
            acuity: raw.acuity,
            peak_contrast: raw.peak_contrast,
            chroma: raw.chroma,
            flicker: raw.flicker,
            contrast_threshold: raw.contrast_threshold != 0,
            conduction_speed: raw.conduction_speed,
            sensory_delay: raw.sensory_delay,
            motor_delay: raw.motor_delay,
            vision_delay: raw.vision_delay,
            vestibular_delay: raw.vestibular_delay,
            hearing_delay: raw.hearing_delay,
        })
    }

    pub(crate) fn raw(&self) -> Result<sys::mimo_maturity> {
        Ok(sys::mimo_maturity {
            acuity: self.acuity,
            peak_contrast: self.peak_contrast,
            chroma: self.chroma,
            flicker: self.flicker,
            contrast_threshold: u32::from(self.contrast_threshold),
            conduction_speed: self.conduction_speed,
            sensory_delay: self.sensory_delay,
            motor_delay: self.motor_delay,
            vision_delay: self.vision_delay,
            vestibular_delay: self.vestibular_delay,
            hearing_delay: self.hearing_delay,
            ..defaults(sys::mimo_maturity_init)?
        })
    }
}
