//! Motions that repeat, found directly: where the map over one period of the forcing returns a state to
//! itself, or a closed curve of states to itself where a second frequency has no common period with the
//! first.
//!
//! A [`ReturnMap`] is all that is known of a system: the states after a period, and how that
//! depends on where they began. [`solve`] finds what returns by Newton's method, [`multipliers`] tells
//! whether a neighbouring motion comes closer, and [`follow`] goes along a parameter, past turning
//! points, and finds where the motion changes its kind.
//!
//! Source: R. Seydel, *Practical Bifurcation and Stability Analysis*, 3rd ed. (2010), ch. 4, 5 and 7;
//! for closed curves of the map F. Schilder, H. Osinga & W. Vogt, *SIAM J. Appl. Dyn. Syst.* 4 (2005)
//! 459–488.

mod branch;
mod circle;
mod continuation;
mod corrector;
mod factors;
mod map;
mod multipliers;
mod newton;
mod reduction;

pub use branch::{
    Branch, BranchEnd, BranchPoint, Continuation, Special, Unrefined, follow, follow_doubled,
};
pub use circle::Circle;
pub use map::{Image, MapError, ReturnMap, Slopes, mixed};
pub use multipliers::{Multipliers, SpecialKind, Stability, multipliers};
pub use newton::{Returned, ShootingError, solve, solve_within};
