//! Steps allocate nothing in Rust either; the library's own tests count its allocations. This test has
//! its own file because an allocator belongs to the whole program.
use mimo::{Batch, BatchConfig, Env, EnvConfig, Scene};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

static COUNT: AtomicUsize = AtomicUsize::new(0);

struct Counting;

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        System.alloc(layout)
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        System.dealloc(memory, layout)
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// The number of allocations.
fn allocations(work: impl FnOnce()) -> usize {
    let before = COUNT.load(Ordering::Relaxed);
    work();
    COUNT.load(Ordering::Relaxed) - before
}

#[test]
fn steps_allocate_nothing() {
    let mut env = Env::make("reach").unwrap();
    let (mut block, mut results) = (env.new_block().unwrap(), env.new_results().unwrap());
    let action = vec![0.1; env.layout().unwrap().action_count()];
    assert!(allocations(|| drop(env.new_block().unwrap())) > 0); // it does count
    let steps = || {
        env.step(&action, Some(&mut block)).unwrap();
        env.step_into(&action, Some(&mut block), &mut results).unwrap();
    };
    assert_eq!(allocations(steps), 0);

    let mut scene = Scene::builtin("reach").unwrap();
    scene.add_agents(None).unwrap();
    let mut batch = Batch::new(&scene, &EnvConfig::new().unwrap(), &BatchConfig::new(2).unwrap()).unwrap();
    let (mut blocks, mut results) = (batch.new_blocks().unwrap(), batch.new_results().unwrap());
    let actions = action.repeat(2);
    assert_eq!(allocations(|| batch.step(&actions, Some(&mut blocks), &mut results).unwrap()), 0);
}
