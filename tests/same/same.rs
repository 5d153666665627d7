//! The scenario of tests/capi/same.c, which gives the same hashes in every language.
fn hash_of(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(1099511628211)
    }) // FNV-1a
}

fn run(scene: &str) -> mimo::Result<()> {
    let mut env = mimo::Env::make(scene)?;
    let mut block = env.new_block()?;
    let mut actions = vec![0.0; env.action_size()?];
    env.reset(Some(7), Some(&mut block))?;
    let mut hash = hash_of(14695981039346656037, block.as_bytes());
    let mut sum = 0.0;
    for step in 0..100 {
        for (i, action) in actions.iter_mut().enumerate() {
            *action = (((7 * step + 3 * i) % 21) as f32 - 10.0) / 10.0;
        }
        sum += env.step(&actions, Some(&mut block))?.reward;
        hash = hash_of(hash, block.as_bytes());
    }
    println!("{} {:016x} {:.6}", scene, hash, sum);
    Ok(())
}

fn main() -> mimo::Result<()> {
    ["reach", "standup", "selfbody", "benchmark"]
        .into_iter()
        .try_for_each(run)
}
