//! Your own sense as a shared library: how high the head is, and for how many physics steps the episode has gone on.
//! `cargo build --example warm_nose` makes it; programs in any language load it by `Scene::load_sense`, and
//! `mimo run --sense` too.
use mimo::{
    Kind, Quantity, Result, SenseField, SenseFields, SenseMoment, SenseOpening, SenseParameter,
};

/// Looked up once for each infant and world; it never changes.
struct WarmNose {
    head: i32,
}

impl mimo::Sense for WarmNose {
    fn parameters() -> Vec<SenseParameter> {
        let (name, description) = ("gain".into(), "factor of the height, 1".into());
        vec![SenseParameter {
            name,
            description,
            standard: 1.0,
            low: 0.0,
            high: 10.0,
        }]
    }

    fn open(opening: &mut SenseOpening) -> Result<WarmNose> {
        let (unit, frame) = ("m".into(), "world".into());
        opening.add(&SenseField {
            unit,
            frame,
            ..SenseField::new("height", &[])
        })?;
        opening.add(&SenseField::new("steps", &[]))?;
        opening.memory = 1;
        let name = opening.moment.prefix() + "head";
        Ok(WarmNose {
            head: opening.moment.world.find(Kind::BODY, &name)?,
        })
    }

    // After each physics step.
    fn advance(&self, _: &SenseMoment, memory: &mut [f64]) -> Result<()> {
        memory[0] += 1.0;
        Ok(())
    }

    // For an observation. It changes nothing but the fields.
    fn write(&self, moment: &SenseMoment, memory: &[f64], fields: &mut SenseFields) -> Result<()> {
        let height = moment.world.get(Quantity::BODY_POSITION, &[self.head])?[2];
        fields.get::<f32>(0)[0] = (moment.parameter(0) * height) as f32;
        fields.get::<f32>(1)[0] = memory[0] as f32;
        Ok(())
    }
}

mimo::export_sense!("warm_nose", WarmNose);
