//! Explicit Runge–Kutta–Nyström pairs for motions whose forces know the velocity in constant linear
//! terms alone: those are taken exactly, and half of the work of a Runge–Kutta pair falls away.

mod any_factor;
#[cfg(test)]
mod conditions;
mod crossing;
mod dense;
mod dprkn12;
mod dprkn8;
mod entries;
mod factor;
mod numbers;
mod row;
mod stand;
mod tableau;
mod trial;
mod walk;
mod within;

pub(super) use dprkn8::Dprkn8;
pub(super) use dprkn12::Dprkn12;
pub(super) use walk::Walk;
