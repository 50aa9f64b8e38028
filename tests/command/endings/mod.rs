//! How a run ends early, and what it keeps.

mod failure;
mod scene;
