//! Speed against error: the measurement itself, the promise of the tolerance, and the choice of the law.

mod choice;
mod measurement;
mod method_use;
mod promise;
mod reduction;

use crate::scenario::{self, Format, Scenario};

/// A loaded 7205C for 0.03 s, with more tables at its end; `contact` is what `[model]` says.
fn text(speed: &str, contact: &str, tables: &str) -> String {
    format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"5 um\"\nfreedoms = \"translational\"\n\
         gravity = true\n[speed]\nconstant = \"{speed}\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         [model]\n{contact}\n[damping]\nratio = 0.02\n\
         [[load]]\nconstant = {{ y = \"-300 N\", z = \"1000 N\" }}\n\
         [time]\nduration = \"0.03 s\"\nsettle = \"0.01 s\"\n{tables}"
    )
}

fn read(text: &str) -> Scenario {
    scenario::parse(text, "accuracy.toml", Format::Toml).unwrap_or_else(|e| panic!("{e}"))
}
