//! Scenarios as they are read: the models they make, the studies they ask for, and any text at all.

mod fuzz;
mod models;
mod one_fault;
mod schema;
mod study;
