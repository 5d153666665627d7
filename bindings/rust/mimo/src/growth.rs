//! How old, large and strong an infant is.
use crate::error::Result;
use crate::structs::defaults;
use crate::sys;
use std::ptr::null;

/// An infant's age and growth, for [`AgentConfig::growth`](crate::AgentConfig::growth).
#[derive(Clone, Copy, Debug)]
pub struct Growth {
    raw: sys::mimo_growth,
}

impl Growth {
    /// The median infant of an age, 0 to 24 months; the mean of girls and boys.
    pub fn of_age(months: f64) -> Result<Growth> {
        let mut raw: sys::mimo_growth = defaults(sys::mimo_growth_init)?;
        raw.age = months;
        Ok(Growth { raw })
    }

    /// A `MIMO_SEX_` constant.
    pub fn sex(&mut self, sex: u32) -> &mut Self {
        self.raw.sex = sex as i32;
        self
    }

    /// Of length, weight and head at once among infants of that age and sex, 1 to 99.865 percent.
    pub fn percentile(&mut self, percentile: f64) -> &mut Self {
        self.raw.percentile = percentile;
        self
    }

    /// Standard deviations of length, weight and head from the median, each -3 to 3.
    pub fn z_scores(&mut self, length: f64, weight: f64, head: f64) -> &mut Self {
        self.raw.z_length = length;
        self.raw.z_weight = weight;
        self.raw.z_head = head;
        self
    }

    /// Another age, in months, for strength, range of motion and tone.
    pub fn physiological_age(&mut self, months: f64) -> &mut Self {
        self.raw.matures_apart = 1;
        self.raw.physiological_age = months;
        self
    }

    /// A `MIMO_GROWTH_` constant: where the sizes come from.
    pub fn model(&mut self, model: u32) -> &mut Self {
        self.raw.model = model as i32;
        self
    }

    /// `MIMO_MATURITY_` constants: what of it is as old; at first its body alone.
    pub fn maturity(&mut self, maturity: u32) -> &mut Self {
        self.raw.maturity = maturity;
        self
    }

    /// Everything else.
    pub fn raw_mut(&mut self) -> &mut sys::mimo_growth {
        &mut self.raw
    }

    pub(crate) fn raw(&self) -> &sys::mimo_growth {
        &self.raw
    }
}

/// Pointers to growths, as C has them; NULL for none.
pub(crate) fn pointers(growths: &[Option<Growth>]) -> Vec<*const sys::mimo_growth> {
    growths.iter().map(|growth| growth.as_ref().map_or(null(), |growth| growth.raw() as *const _)).collect()
}
