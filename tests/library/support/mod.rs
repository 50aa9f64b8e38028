//! What the tests share: builders of models that differ from a plain one in what a test names,
//! a sink that keeps samples, and comparison with printed numbers.

use std::f64::consts::FRAC_PI_2;
use std::io;
use std::sync::atomic::AtomicBool;

use crate::bearing::{
    BallContact, BallLoads, Bearing, BearingRotation, BearingState, Elements, Facing, FreePosition,
    Geometry, HertzLaw, InternalGeometry, Matrix5, MountedBearing, Preload, Ring, Support, Vector5,
    catalogue,
};
use crate::integrate::{Method, Settings, System};
use crate::rotor::{
    Damping, Freedoms, InitialPosition, InitialState, Load, RotorDefinition, Sample, Shaft,
};
use crate::rotor::{Equilibrium, EquilibriumError, StaticProblem};
use crate::scenario::Scenario;
use crate::simulate::{
    Analyses, Model, Monitor, Run, Sampling, SimulateError, TraceSink, simulate,
};
use nalgebra::DMatrix;

/// Micrometre in m.
pub const MICROMETRE: f64 = 1e-6;

/// A deep-groove bearing of the catalogue without clearance.
pub fn without_clearance(designation: &str) -> Bearing {
    let bearing = bearing(designation);
    let geometry = Geometry::new(
        bearing.geometry.balls(),
        bearing.geometry.ball_diameter(),
        bearing.geometry.pitch_diameter(),
        FreePosition::DiametralClearance(0.0),
        bearing.geometry.groove_factors()[0],
        bearing.geometry.groove_factors()[1],
    );
    Bearing {
        geometry: geometry.expect("a geometry"),
        ..bearing
    }
}

/// Balls and grooves of a state.
pub fn inside(state: &BearingState) -> InternalGeometry {
    match state.geometry.elements {
        Elements::Balls(own) => own,
        Elements::Rollers(own) => panic!("{own:?}"),
    }
}

/// A catalogue bearing of bearing steel.
pub fn bearing(designation: &str) -> Bearing {
    let entry = catalogue::find(designation).expect("a designation of the catalogue");
    entry.bearing().expect("catalogue bearings are sound")
}

/// A bearing of the literature's two-freedom models: contact stiffness in N/m^1.5 and radial
/// clearance in m given directly, lengths in m.
pub fn literature_bearing(
    balls: usize,
    diameters: [f64; 2],
    clearance: f64,
    contact_stiffness: f64,
) -> Bearing {
    let [ball, pitch] = diameters;
    let free = FreePosition::RadialClearance(clearance);
    Bearing {
        contact_stiffness: Some(contact_stiffness),
        ..Bearing::of_steel(Geometry::new(balls, ball, pitch, free, 0.52, 0.52).expect("a bearing"))
    }
}

/// [`MountedBearing::new`].
pub fn mounted(bearing: Bearing) -> MountedBearing {
    MountedBearing::new(bearing)
}

/// Two 7205C back to back, 30 mm either side of the centre of mass, preloaded with 200 N.
pub fn back_to_back_pair() -> Vec<MountedBearing> {
    [(-0.03, Facing::PlusZ), (0.03, Facing::MinusZ)]
        .map(|(position, facing)| MountedBearing {
            position,
            facing,
            preload: Preload::Force(200.0),
            ..mounted(bearing("7205C"))
        })
        .to_vec()
}

/// The literature's shaft of varying compliance: x and y free, 200 N s/m of damping, loaded along −y towards
/// ball 0.
pub fn varying_compliance(speed: f64, mass: f64, weight: f64, bearing: Bearing) -> RotorDefinition {
    RotorDefinition {
        speed,
        damping: Damping::Coefficients([200.0, 200.0, 0.0, 0.0, 0.0]),
        loads: constant([0.0, -weight, 0.0, 0.0, 0.0]),
        ..rotor(
            Shaft {
                mass,
                ..shaft(Freedoms::Radial)
            },
            vec![MountedBearing {
                first_ball: -FRAC_PI_2,
                ..mounted(bearing)
            }],
        )
    }
}

/// The ring of balls of a bearing under its law of Hertz contacts.
pub struct HertzRing {
    pub ring: Ring,
    law: HertzLaw,
}

impl HertzRing {
    pub fn force(&self, place: &Vector5, rotation: &BearingRotation) -> Vector5 {
        self.ring.force(&self.law, place, rotation)
    }

    pub fn force_and_stiffness(
        &self,
        place: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        self.ring.force_and_stiffness(&self.law, place, rotation)
    }

    pub fn loads(&self, place: &Vector5, rotation: &BearingRotation, loads: &mut BallLoads) {
        self.ring.loads(&self.law, place, rotation, loads);
    }
}

/// The ring of balls of a bearing, ball 0 at an azimuth in rad.
pub fn ring_from(bearing: &Bearing, first_ball: f64) -> HertzRing {
    HertzRing {
        ring: Ring::new(&bearing.geometry, first_ball),
        law: law(bearing),
    }
}

/// The same with ball 0 on +X.
pub fn ring(bearing: &Bearing) -> HertzRing {
    ring_from(bearing, 0.0)
}

/// The law of its balls.
pub fn law(bearing: &Bearing) -> HertzLaw {
    HertzLaw::new(
        bearing.load_deflection_constant().expect("a contact"),
        bearing.geometry.groove_centre_distance(),
    )
}

/// Supports of mounted bearings.
pub fn supports(bearings: &[MountedBearing]) -> Vec<Support> {
    let support = |bearing| Support::new(bearing, 0.0).expect("a bearing that can be mounted");
    bearings.iter().map(support).collect()
}

/// Contacts of every ball of a support, its cage where it starts, at a speed in rad/s.
pub fn contacts(support: &Support, displacement: &Vector5, speed: f64) -> Vec<BallContact> {
    let mut loads = BallLoads::new(support.known_balls(), true);
    support.force_and_loads(displacement, &BearingRotation::at_start(speed), &mut loads);
    loads.contacts().collect()
}

/// Static equilibrium of a standing shaft, searched from q = 0.
pub fn equilibrium(
    bearings: &[MountedBearing],
    load: Vector5,
    free: [bool; 5],
) -> Result<Equilibrium, EquilibriumError> {
    StaticProblem {
        supports: &supports(bearings),
        load,
        free,
        start: [0.0; 5],
        speed: 0.0,
    }
    .solve()
}

/// 5 kg, balanced, without weight; tilts turn 2 g m² transverse and 1.5 g m² polar.
pub fn shaft(freedoms: Freedoms) -> Shaft {
    Shaft {
        mass: 5.0,
        inertia_transverse: 2e-3,
        inertia_polar: 1.5e-3,
        eccentricity: 0.0,
        unbalance: Default::default(),
        freedoms,
        gravity: false,
        held_tilt: [0.0; 2],
    }
}

/// From the static equilibrium at rest.
pub const AT_EQUILIBRIUM: InitialState = InitialState {
    from: InitialPosition::Equilibrium,
    displacement: [None; 5],
    velocity: [None; 5],
};

/// The shaft on the bearings: standing, undamped, unloaded, cages rolling.
pub fn rotor(shaft: Shaft, bearings: Vec<MountedBearing>) -> RotorDefinition {
    RotorDefinition::new(shaft, bearings)
}

/// A constant load at the centre of mass, N and N m.
pub fn constant(parts: Vector5) -> Vec<Load> {
    vec![Load::constant(parts, 0.0)]
}

/// The definition under further loads.
pub fn under(
    definition: RotorDefinition,
    further: impl IntoIterator<Item = Load>,
) -> RotorDefinition {
    let loads = definition.loads.iter().cloned().chain(further);
    RotorDefinition {
        loads: loads.collect(),
        ..definition
    }
}

/// A 7205C under 1000 N of thrust, 5 kg, x, y and z free, 2 % damping, 500 rad/s.
pub fn thrust_rotor() -> RotorDefinition {
    RotorDefinition {
        speed: 500.0,
        damping: Damping::Ratio(0.02),
        loads: constant([0.0, 0.0, 1000.0, 0.0, 0.0]),
        ..rotor(
            shaft(Freedoms::Translational),
            vec![mounted(bearing("7205C"))],
        )
    }
}

/// Dop853 at a tolerance, with steps enough for any test.
pub fn settings(tolerance: f64) -> Settings {
    Settings {
        method: Method::Dop853,
        tolerance,
        step_limit: 100_000_000,
    }
}

/// The rotor over a time, sampled so and so often a second: no verifying pass, no spectra.
pub fn model(rotor: RotorDefinition, duration: f64, rate: f64) -> Model {
    Model {
        rotor,
        duration,
        settle: 0.0,
        sampling: Sampling::Rate(rate),
        integrator: settings(1e-10),
        verify: false,
        energy: false,
        table: false,
        spectrum: None,
        analyses: Analyses::default(),
        spectra: Vec::new(),
    }
}

/// Keeps the samples from a time on.
#[derive(Default)]
pub struct Collector {
    /// Time of the first sample kept, s.
    pub from: f64,
    /// The samples.
    pub samples: Vec<Sample>,
}

impl TraceSink for Collector {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        if sample.time >= self.from {
            self.samples.push(sample.clone());
        }
        Ok(())
    }
}

/// Runs a model; the samples up to a failure are returned with it.
pub fn try_run(model: &Model, from: f64) -> (Result<Run, SimulateError>, Vec<Sample>) {
    let mut sink = Collector {
        from,
        samples: Vec::new(),
    };
    let result = simulate_into(model, &mut sink);
    (result, sink.samples)
}

/// Runs a model into a sink without watching it.
pub fn simulate_into(model: &Model, sink: &mut dyn TraceSink) -> Result<Run, SimulateError> {
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    simulate(model, sink, &mut monitor)
}

/// Samples of a run that must succeed, from a time on.
pub fn samples(model: &Model, from: f64) -> Vec<Sample> {
    let (result, samples) = try_run(model, from);
    result.expect("the model runs");
    samples
}

/// Largest minus smallest value.
pub fn peak_to_peak(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    high - low
}

/// Asserts |value − expected| ≤ tolerance, with a name to find it by.
#[track_caller]
pub fn assert_near(name: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    assert!(
        error <= tolerance,
        "{name}: {value:.12e} is not {expected:.12e}: {error:.2e} apart, {tolerance:.2e} allowed"
    );
}

/// A scenario given as text.
#[track_caller]
pub fn scenario(text: &str) -> Scenario {
    Scenario::from_toml(text).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

/// Asserts that a value, rounded as the printed number is, is that number.
#[track_caller]
pub fn assert_printed(name: &str, value: f64, printed: &str) {
    let expected: f64 = printed.parse().expect("a printed number");
    assert_near(name, value, expected, half_last_digit(printed));
}

/// Half a unit of the last printed digit, and round-off of the comparison itself.
pub fn half_last_digit(printed: &str) -> f64 {
    let (digits, exponent) = printed.split_once('e').unwrap_or((printed, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
    let exponent: i32 = exponent.parse().expect("an exponent");
    0.500_001 * 10f64.powi(exponent - decimals as i32)
}

/// `∂f/∂y` and `∂f/∂t` of a system.
pub fn linearisation(system: &dyn System, time: f64, state: &[f64]) -> (DMatrix<f64>, Vec<f64>) {
    let mut jacobian = DMatrix::zeros(state.len(), state.len());
    let mut by_time = vec![0.0; state.len()];
    system.linearisation(time, state, &mut jacobian);
    system.rate_by_time(time, state, &mut by_time);
    (jacobian, by_time)
}
