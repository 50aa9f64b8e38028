//! The command `jeffcott`.
fn main() {}
