//! A second of an infant's life: `cargo run --example hello`.
fn main() -> mimo::Result<()> {
    let mut env = mimo::Env::make("benchmark")?;
    let mut block = env.new_block()?;
    let mut action = vec![0.0; env.layout()?.action_count()];
    env.reset(mimo::Reset::new().seed(1), Some(&mut block))?;
    for step in 0..100 {
        action[0] = if step < 50 { 1.0 } else { -1.0 };
        env.step(&action, Some(&mut block))?;
    }
    for field in block.fields() {
        println!(
            "{:<30} {:?} {:?} {}",
            field.name, field.dtype, field.shape, field.unit
        );
    }
    println!(
        "{:.2} s: the head feels {:?} m/s^2",
        env.time()?,
        block.f32("vestibular/acceleration")?
    );
    Ok(())
}
