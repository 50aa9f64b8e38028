//! Time that the library takes for a scenario, for `benches/speed.py` to compare with: load and run, samples in memory.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use jeffcott::scenario;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, file, repeats] = &arguments[..] else {
        return Err("usage: library_time FILE REPEATS".into());
    };
    for _ in 0..repeats.parse()? {
        let started = Instant::now();
        let run = scenario::load(Path::new(file))?.simulate()?;
        println!("{} {}", started.elapsed().as_secs_f64(), run.samples.len());
    }
    Ok(())
}
