//! How a run ends early, what it keeps, and how it goes on.

mod failure;
mod parts;
mod restart_file;
mod scene;
