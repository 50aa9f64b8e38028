//! `jeffcott` simulates a shaft that spins on ball bearings. The shaft is a rigid, eccentric mass (a Jeffcott rotor), or
//! consists of sections and discs and bends; the force that holds it is that of the quasi-static model of real bearings. A
//! scenario goes in; traces, spectra and the measured error of the answer come out.
//!
//! The command and its reports are the feature `command`, on by default. With `default-features = false` the library has
//! all floors below but `cli`, `ask` and [`report`], and a third fewer packages.
//!
//! # Floors
//!
//! Data climbs once; code depends downwards only. Floors with a link are public; the others are how they work inside, which
//! may change with every version.
//!
//! | floor | what it does |
//! |---|---|
//! | `cli` | what was typed → exit code, one file a verb |
//! | `ask` | the question of each verb → findings: tables, figures, document, text, warnings; also for Python |
//! | [`report`] | results → CSV, JSON, Parquet, SVG, pages; comparison of results |
//! | [`scenario`] | text → checked, typed model; units; every message |
//! | `measurement` | what sensors measured in, what is found of it out: by the code that runs are analysed by |
//! | `fit` | answers at values of keys: how they change with each, and which values explain what was measured |
//! | [`study`] | many questions: one number varied, many runs, natural frequencies over the speed, speed against error, the contact law that a scene needs |
//! | [`mod@steady`] | a model in, the motion that it settles to out |
//! | [`mod@simulate`] | a model in, a run out |
//! | `quasi_static` | a static question in, an answer out; no time passes |
//! | [`analysis`] | the columns of a sample → spectra, peaks and their sources, kinds of motion, maps of run-ups |
//! | `rotor` | shaft, bearings, loads, speed, drive → the equation of motion, its energy and its linearisation |
//! | `shooting` | the map over a period → motions that repeat, their stability, their branches |
//! | `integrate` | derivative and events → states on a time grid, with error control |
//! | [`bearing`] | geometry, catalogue, laws of a ball, the ring that sums over balls, equilibrium, life, friction |
//! | [`physics`] | closed-form laws: material, curvature, Hertz contact, films, kinematics, friction |
//!
//! Below them [`record`] reads the files of sensors and recorders; inside, `table` has columns that know their quantity and
//! unit, `keys` names quantities in results, and `numerics` has what knows nothing of bearings and shafts: roots,
//! eigenvectors, products of matrices that have blocks of zeros, steps compiled for wide registers.
//!
//! Inside, a ball law is a pure function from the position of a ball's inner groove centre to the force there, written once
//! for plain numbers, for balls side by side and for numbers with slopes. A ring visits the balls once and sums over them. A
//! rotor holds a linear part, the elements at their attachments, which know where and how turned each sits, and what excites
//! the shaft; the integrator never knows which law runs. What is observed of an instant is a sample, whose columns
//! [`analysis::Channel`] lists.
//!
//! [`seed_paper`] holds no code: it says figure by figure where the paper that the crate started from
//! and this crate agree, and where they cannot.
//!
//! [`speed_and_error`] holds none either: it says what an error costs, by measurement.
//!
//! # Frame and signs
//!
//! SI units inside: m, N, kg, s, rad, Pa. Units appear only in scenario files and column headers.
//! The frame is right-handed and fixed in the housing: Z along the shaft, X horizontal, Y up;
//! gravity acts along −Y. The shaft turns by ψ = ∫ω dt ≥ 0 about +Z; the unbalance points along +X at
//! ψ = 0. The azimuth φ of a ball counts from +X towards +Y. F(q) is what the shaft presses onto the
//! bearing at the displacement q = (x, y, z, θx, θy) of the inner ring; the bearing's force on the
//! shaft is −F(q), and K = ∂F/∂q.
//!
//! # Symbols
//!
//! | symbol | meaning | in the code |
//! |---|---|---|
//! | Z, D, d_m | number and diameter of the balls, pitch diameter | `balls`, `ball_diameter`, `pitch_diameter` |
//! | f_i, f_o | groove radius over ball diameter, inner and outer race | `groove_factor_inner`, `groove_factor_outer` |
//! | A | distance of the groove centres, unloaded: (f_i + f_o − 1)D | `groove_centre_distance` |
//! | α0, α | contact angle, free and loaded | `contact_angle`, `angle_inner`, `angle_outer` |
//! | γ | D cos α0/d_m | `gamma` |
//! | R_i | radius of the circle of inner groove centres | `inner_groove_radius` |
//! | A1, A2 | position of the inner groove centre from the outer one | `axial`, `radial` |
//! | Q, δ, K_n | ball load, approach, load–deflection constant: Q = K_n δ^1.5 | `load`, `approach`, `load_deflection_constant` |
//! | e, ω, ψ | mass eccentricity, angular speed and angle of the shaft | `eccentricity`, `speed`, `angle` |
//! | ω_c, ψ_c | speed and angle of the cage | `cage_speed`, `BearingRotation` |
//! | ζ, τ | damping ratio, stiffness time c = τK | `Damping` |
//!
//! # A run from Rust
//!
//! ```
//! use jeffcott::bearing::Bearing;
//! use jeffcott::scenario::Scenario;
//!
//! let text = r#"
//!     [shaft]
//!     mass = "5 kg"
//!     eccentricity = "0.01 mm"
//!     freedoms = "translational"
//!     [speed]
//!     constant = "500 rad/s"
//!     [[bearing]]
//!     catalogue = "7205C"
//!     [damping]
//!     ratio = 0.02
//!     [[load]]
//!     constant = { z = "1000 N" }
//!     [time]
//!     duration = "0.1 s"
//! "#;
//! let run = Scenario::from_toml(text)?.simulate()?;
//! let heaviest = run.column("largest_ball_load")?.into_iter().fold(0.0, f64::max);
//! assert!((250.0..260.0).contains(&heaviest)); // N
//! assert!(run.error().is_some_and(|error| error.relative < 1e-7));
//!
//! let load = [0.0, 0.0, 1000.0, 0.0, 0.0]; // N
//! let stiffness = *Bearing::catalogue("7205C")?.equilibrium(load)?.stiffness();
//! assert!(stiffness[(0, 0)] > stiffness[(2, 2)]); // stiffer across its axis
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`simulate::simulate`] takes samples as they come, tells its progress and can be stopped.

#![warn(clippy::panic, clippy::unwrap_used)]
#![cfg_attr(
    not(feature = "command"),
    allow(dead_code, unused_imports, reason = "what the command alone asks for")
)]

pub mod analysis;
#[cfg(feature = "command")]
#[doc(hidden)]
pub mod ask;
pub mod bearing;
#[cfg(feature = "command")]
#[doc(hidden)]
pub mod cli;
mod fit;
mod integrate;
#[cfg(feature = "command")]
#[doc(hidden)]
pub mod internals;
mod keys;
mod measurement;
mod numerics;
pub mod physics;
mod quasi_static;
pub mod record;
#[cfg(feature = "command")]
pub mod report;
mod rotor;
pub mod scenario;
mod shooting;
pub mod simulate;
pub mod steady;
pub mod study;
mod table;
#[cfg(test)]
#[path = "../tests/library/mod.rs"]
mod tests;

/// Speed against error: what the benches measure, and how to get their figures.
///
#[doc = include_str!("../benches/README.md")]
pub mod speed_and_error {}

/// The studies of the paper that the crate started from, figure by figure.
///
#[doc = include_str!("../scenarios/seed/README.md")]
pub mod seed_paper {}
