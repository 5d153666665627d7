//! Your own task with a goal in the observation, for several worlds: the infant has to move its left
//! hand to a point that each episode draws. A learner reads goal and hand from the observation, and may
//! replace a missed goal by an achieved one. `cargo run --example own_goal`
use mimo::{
    BatchReset, Kind, Moment, Outcome, Quantity, Result, TaskField, Touch, Verdict, Vision, World,
};

const WORLDS: usize = 4;
const STEPS: usize = 100;
const NEAR: f64 = 0.1; // m

/// The box of possible goals: its middle and its half sizes, m.
const MIDDLE: [f64; 3] = [0.15, 0.15, 0.3];
const HALF: [f64; 3] = [0.1, 0.1, 0.1];

/// All worlds share it, and only read it.
struct Reach {
    hand: i32,
}

impl mimo::Task for Reach {
    fn terms(&self) -> Vec<String> {
        vec!["nearness".into(), "effort".into()]
    }

    fn fields(&self) -> Vec<TaskField> {
        ["desired_goal", "achieved_goal"]
            .map(|name| TaskField {
                unit: "m".into(),
                frame: "world".into(),
                ..TaskField::new(name, &[3])
            })
            .into()
    }

    fn reset(&self, world: &mut World, moment: &mut Moment) -> Result<()> {
        let mut shares = [0.0; 3]; // from the world's own stream: seeds it, and it is repeatable
        world.random(&mut shares)?;
        for i in 0..3 {
            moment.fields[i] = (MIDDLE[i] + HALF[i] * (2.0 * shares[i] - 1.0)) as f32;
        }
        self.feel(world, moment)
    }

    fn evaluate(
        &self,
        world: &mut World,
        moment: &mut Moment,
        verdict: &mut Verdict,
    ) -> Result<()> {
        self.feel(world, moment)?;
        let (goal, hand) = moment.fields.split_at(3);
        let square: f64 = goal
            .iter()
            .zip(hand)
            .map(|(a, b)| f64::from(a - b).powi(2))
            .sum();
        let action = moment.action.unwrap_or(&[]);
        let effort: f64 = action.iter().map(|&a| f64::from(a).powi(2)).sum();
        verdict.terms[0] = -square.sqrt();
        verdict.terms[1] = -0.001 * effort;
        if square.sqrt() < NEAR {
            verdict.outcome = Outcome::SUCCESS;
        }
        verdict.goes_on = true; // it may hold its hand there
        verdict.truncated = moment.step >= STEPS as u64;
        Ok(())
    }
}

impl Reach {
    /// The position of the hand is the achieved goal.
    fn feel(&self, world: &World, moment: &mut Moment) -> Result<()> {
        let place = world.get(Quantity::BODY_POSITION, &[self.hand])?;
        for (field, place) in moment.fields[3..].iter_mut().zip(place) {
            *field = place as f32;
        }
        Ok(())
    }
}

fn make_batch() -> Result<mimo::Batch> {
    let mut scene = mimo::Scene::builtin("benchmark")?;
    let mut agent = scene.default_agent()?;
    agent.vision(Vision::empty()).touch(Touch::empty());
    scene.add_agent(&agent)?;
    let config = mimo::EnvConfig::new()?;
    let hand = mimo::Env::new(&scene, &config)?.find(Kind::BODY, "left_hand")?;
    scene.set_task(Reach { hand })?;
    mimo::Batch::new(&scene, &config, &mimo::BatchConfig::new(WORLDS as u32)?)
}

fn main() -> Result<()> {
    let mut batch = make_batch()?;
    let mut blocks = batch.new_blocks()?;
    let mut results = batch.new_results()?;
    let mut actions = vec![0.0; WORLDS * batch.layout()?.action_count()];
    batch.reset(BatchReset::new().seeds(&[1, 2, 3, 4]), Some(&mut blocks))?;
    let mut nearest = [f32::INFINITY; WORLDS];
    for step in 0..STEPS {
        for (i, action) in actions.iter_mut().enumerate() {
            *action = ((step / 10 + i) as f32 * 2.4).sin();
        }
        batch.step(&actions, Some(&mut blocks), &mut results)?;
        for (world, nearest) in nearest.iter_mut().enumerate() {
            let seen = blocks.world(world);
            let (goal, hand) = (seen.f32("desired_goal")?, seen.f32("achieved_goal")?);
            let square: f32 = goal.iter().zip(hand).map(|(a, b)| (a - b).powi(2)).sum();
            *nearest = nearest.min(square.sqrt());
        }
    }
    assert!(results.truncated.iter().all(|&cut| cut));
    println!("how near each hand came to its goal, m: {:.2?}", nearest);
    Ok(())
}
