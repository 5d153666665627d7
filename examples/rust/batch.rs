//! Sixteen infants move at random, on all cores: `cargo run --example batch`.
use mimo::{Autoreset, BatchReset};

fn main() -> mimo::Result<()> {
    let mut scene = mimo::Scene::builtin("reach")?;
    let agent = scene.default_agent()?;
    scene.add_agent(&agent)?;
    let mut config = mimo::BatchConfig::new(16)?;
    config.autoreset(Autoreset::SAME_STEP).restart_failed(true);
    let mut batch = mimo::Batch::new(&scene, &mimo::EnvConfig::new()?, &config)?;

    let worlds = batch.worlds();
    let mut blocks = batch.new_blocks()?;
    let mut results = batch.new_results()?;
    let mut actions = vec![0.0f32; worlds * batch.layout()?.action_count()];
    let seeds: Vec<u64> = (0..worlds as u64).collect();
    batch.reset(BatchReset::new().seeds(&seeds), Some(&mut blocks))?;

    let mut random = 1u32;
    let mut sum = 0.0;
    for _ in 0..100 {
        for action in &mut actions {
            random = random.wrapping_mul(1664525).wrapping_add(1013904223); // good enough to wave with
            *action = random as f32 / u32::MAX as f32 * 2.0 - 1.0;
        }
        batch.step(&actions, Some(&mut blocks), &mut results)?;
        sum += results.reward.iter().sum::<f64>();
    }
    println!(
        "{} worlds, mean reward of a step: {:.4}",
        worlds,
        sum / (100 * worlds) as f64
    );
    Ok(())
}
