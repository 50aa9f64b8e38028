//! Rollers: the ring against a plain sum, slopes, energy, and hard cases of lift-off, edges and tilts.

use crate::bearing::{
    BallLoads, BearingRotation, ContactDamping, Defect, DefectProfile, MountedBearing, Profile,
    Support, Surface, Vector5, Wave,
};
use crate::physics::{contact_modulus, line_stiffness};
use crate::rotor::{CageMotion, Damping, Freedoms, InitialPosition, InitialState, RotorDefinition};

use crate::tests::published::rollers::{spherical, tapered, thirteen};
use crate::tests::support::{assert_near, constant, model, rotor, samples, shaft, supports};

/// Places of a ring that press, tilt to an edge at 4 mrad, touch a few rollers only or none, and stand just at lift-off.
const PLACES: [Vector5; 6] = [
    [8e-6, -5e-6, 30e-6, 1e-4, -2e-4],
    [2e-6, 1e-6, 4e-6, -2.5e-3, 3.1e-3],
    [0.0, -25e-6, 1e-6, 3e-4, 0.0],
    [1e-9, -2e-9, 0.0, 0.0, 0.0],
    [-1e-6, 1e-6, -40e-6, 1e-6, 1e-6],
    [0.0; 5],
];

fn kinds() -> [MountedBearing; 4] {
    [
        thirteen(Profile::Flat, 30),
        thirteen(Profile::Logarithmic, 37),
        tapered(),
        spherical(),
    ]
}

fn support(bearing: &MountedBearing) -> Support {
    supports(std::slice::from_ref(bearing)).remove(0)
}

fn modulus(bearing: &MountedBearing) -> f64 {
    let own = &bearing.bearing;
    contact_modulus(&own.ball_material, &own.ring_material)
}

/// The force by the formula, roller by roller and slice by slice, and the sum of the sizes of its terms.
fn plain_sum(bearing: &MountedBearing, place: &Vector5, cage: f64) -> (Vector5, f64) {
    weighted_sum(bearing, place, cage, |_| 1.0)
}

/// The same with the load of every slice times a factor by how its approach follows the ring.
fn weighted_sum(
    bearing: &MountedBearing,
    place: &Vector5,
    cage: f64,
    factor: impl Fn(&Vector5) -> f64,
) -> (Vector5, f64) {
    let geometry = &bearing.bearing.geometry;
    let rollers = geometry.rollers().expect("rollers");
    let stiffness = line_stiffness(rollers.length, modulus(bearing)) / rollers.laminae as f64;
    let [x, y, z, tilt_x, tilt_y] = *place;
    let (mut force, mut size) = ([0.0; 5], 0.0);
    let balls = geometry.balls();
    for number in 0..balls * geometry.rows() {
        let azimuth = std::f64::consts::TAU * (number % balls) as f64 / balls as f64 + cage;
        let (sin, cos) = azimuth.sin_cos();
        let side = if number < balls { 1.0 } else { -1.0 };
        let (sin_a, cos_a) = (side * geometry.contact_angle()).sin_cos();
        for slice in rollers.slices(geometry.ball_diameter()) {
            // how the approach follows x, y, z, θx, θy
            let (radius, along) = match geometry.rows() {
                1 => (
                    0.5 * geometry.pitch_diameter() - slice.position * sin_a,
                    slice.position * cos_a,
                ),
                // a sphere about the middle of the bearing
                _ => (0.0, 0.0),
            };
            let tilting = sin_a * radius - cos_a * along;
            let row = [
                cos_a * cos,
                cos_a * sin,
                sin_a,
                tilting * sin,
                -tilting * cos,
            ];
            let moved: f64 = row
                .iter()
                .zip([x, y, z, tilt_x, tilt_y])
                .map(|(a, b)| a * b)
                .sum();
            let approach = moved - 0.5 * cos_a * rollers.clearance - 2.0 * slice.drop;
            let load = stiffness * approach.max(0.0).powf(10.0 / 9.0) * factor(&row);
            size += load.abs();
            for axis in 0..5 {
                force[axis] += load * row[axis];
            }
        }
    }
    (force, size)
}

#[test]
fn the_ring_is_the_plain_sum_of_all_slices() {
    for bearing in kinds() {
        let support = support(&bearing);
        for place in PLACES {
            let cage = 0.3;
            let rotation = BearingRotation::at_start(100.0).with_cage_at(cage);
            let (expected, size) = plain_sum(&bearing, &place, cage);
            let force = support.force(&place, &rotation);
            let mut loads = BallLoads::new(support.known_balls(), true);
            let observed = support.force_and_loads(&place, &rotation, &mut loads);
            for axis in 0..5 {
                assert_near("force", force[axis], expected[axis], 2e-12 * size);
                assert_near("observed", observed[axis], expected[axis], 2e-12 * size);
            }
            let borne: f64 = loads.load[0].iter().sum();
            assert_near("loads", borne, size, 2e-12 * size);
        }
    }
}

/// Whatever cells rollers come to, and beyond all of them.
#[test]
fn forces_of_motions_are_the_plain_sum_everywhere() {
    for bearing in kinds() {
        let support = support(&bearing);
        for number in 1..40 {
            let size = 1.5_f64.powi(number - 25);
            let part = |step: i32| 1e-3 * size * (f64::from(step * number) * 0.618).sin();
            let place = [part(1), part(2), part(3), 20.0 * part(4), 20.0 * part(5)];
            let rotation = BearingRotation::at_start(100.0).with_cage_at(f64::from(number));
            let (expected, size) = plain_sum(&bearing, &place, f64::from(number));
            let force = support.force(&place, &rotation);
            for axis in 0..5 {
                assert_near("force", force[axis], expected[axis], 2e-12 * size);
            }
        }
    }
}

#[test]
fn stiffness_is_the_slope_of_the_force() {
    for bearing in kinds() {
        let support = support(&bearing);
        let rotation = BearingRotation::at_start(0.0).with_cage_at(0.2);
        for place in &PLACES[..3] {
            let tangent = support.tangent(place, &rotation);
            let scale = [1.0, 1.0, 1.0, 0.02, 0.02];
            for column in 0..5 {
                let step = 1e-10 / scale[column];
                let [mut below, mut above] = [*place; 2];
                below[column] -= step;
                above[column] += step;
                let [below, above] = [below, above].map(|place| support.force(&place, &rotation));
                for row in 0..5 {
                    let slope = (above[row] - below[row]) / (2.0 * step);
                    let size = tangent.stiffness.amax() * scale[row] * scale[column];
                    let own = tangent.stiffness[(row, column)];
                    assert_near("K", own, slope, 1e-4 * size.max(1.0));
                    assert_near(
                        "symmetry",
                        own,
                        tangent.stiffness[(column, row)],
                        1e-9 * size.max(1.0),
                    );
                }
            }
        }
    }
}

/// q max(c δ̇/2, −1)/2 at either race, slice by slice, along how the approach δ follows the ring.
#[test]
fn damping_is_the_plain_sum_of_all_slices() {
    let loss = [0.2, 0.5];
    for mut bearing in kinds() {
        bearing.contact_damping = ContactDamping {
            inner: loss[0],
            outer: loss[1],
        };
        let support = support(&bearing);
        let rotation = BearingRotation::at_start(0.0).with_cage_at(0.3);
        // slowly, and so fast that contacts would pull
        for speed in [0.01, 20.0] {
            let velocity = [0.4, -1.0, 0.7, 20.0, -35.0].map(|part| speed * part);
            for place in PLACES {
                let factor = |row: &Vector5| {
                    let rate: f64 = row.iter().zip(velocity).map(|(a, b)| a * b).sum();
                    let at_race = |loss: f64| 0.5 * (0.75 * loss * rate).max(-1.0);
                    loss.map(at_race).iter().sum()
                };
                let (expected, size) = weighted_sum(&bearing, &place, 0.3, factor);
                let [_, damping] = support.damped_force(&place, &velocity, &rotation);
                for axis in 0..5 {
                    assert_near("damping", damping[axis], expected[axis], 2e-12 * size);
                }
                let power: f64 = damping.iter().zip(velocity).map(|(a, b)| a * b).sum();
                assert!(power >= 0.0, "{power}");
            }
        }
    }
}

#[test]
fn the_force_is_the_slope_of_the_stored_energy() {
    for bearing in kinds() {
        let support = support(&bearing);
        let rotation = BearingRotation::at_start(0.0);
        assert!(support.has_potential(false));
        for place in &PLACES[..3] {
            let force = support.force(place, &rotation);
            for axis in 0..5 {
                let step = if axis < 3 { 1e-9 } else { 1e-7 };
                let [mut below, mut above] = [*place; 2];
                below[axis] -= step;
                above[axis] += step;
                let [below, above] =
                    [below, above].map(|place| support.stored_energy(&place, &rotation));
                let slope = (above - below) / (2.0 * step);
                let size = force
                    .iter()
                    .fold(1.0_f64, |most, part| most.max(part.abs()));
                assert_near("force", force[axis], slope, 1e-4 * size);
            }
        }
    }
}

#[test]
fn standing_rollers_at_the_point_of_lift_off_bear_nothing() {
    let support = support(&thirteen(Profile::Flat, 30));
    let rotation = BearingRotation::at_start(0.0);
    let tangent = support.tangent(&[0.0; 5], &rotation);
    assert_eq!(tangent.force, [0.0; 5]);
    assert_eq!(tangent.stiffness.amax(), 0.0);
    let mut past = vec![1.0; support.balls_that_lift_off()];
    support.past_lift_offs(&[0.0; 5], &rotation, &mut past);
    assert_eq!(past, [0.0; 13 * 30]);
    assert_eq!(support.lift_off_exponent(), 10.0 / 9.0);
}

#[test]
fn a_tilt_lifts_the_middle_off_before_the_end() {
    // 4 mrad press the ends of flat rollers in by 3.87 mm · 4 mrad while their middles are 5 µm apart
    let support = support(&thirteen(Profile::Flat, 30));
    let rotation = BearingRotation::at_start(0.0);
    let mut past = vec![0.0; support.balls_that_lift_off()];
    support.past_lift_offs(&[-5e-6, 0.0, 0.0, 0.0, 4e-3], &rotation, &mut past);
    // of the roller on the x axis, from one end to the other
    for (lamina, past) in past.iter().step_by(13).enumerate() {
        let position = 4e-3 * ((2 * lamina + 1) as f64 / 30.0 - 1.0);
        assert_near("past", *past, 4e-3 * position - 5e-6, 1e-18);
    }
}

/// A spall drops a roller along its whole length, and on one row alone: it bears what a sound one bears whose ring is less
/// far in by the drop.
#[test]
fn a_spalled_race_drops_its_roller() {
    for (bearing, row) in [(thirteen(Profile::Logarithmic, 30), 13), (spherical(), 15)] {
        let depth = 3e-6;
        let spall = Defect {
            on: Surface::Outer,
            angle: 0.0,
            length: 1e-3,
            depth,
            profile: DefectProfile::HalfSine,
        };
        let mut spalled = bearing.clone();
        spalled.imperfections.defects = vec![spall];
        let rotation = BearingRotation::at_start(0.0);
        let loads = |bearing: &MountedBearing, x: f64| {
            let support = support(bearing);
            let mut loads = support.room_for_loads(false);
            support.force_and_loads(&[x, 0.0, 0.0, 0.0, 0.0], &rotation, &mut loads);
            loads.load[0].clone()
        };
        let x = 30e-6;
        let cosine = bearing.bearing.geometry.contact_angle().cos();
        let (own, sound) = (loads(&spalled, x), loads(&bearing, x));
        let less = loads(&bearing, x - depth / cosine);
        assert_near("over the spall", own[0], less[0], 1e-12 * less[0]);
        assert!(own[0] < 0.95 * sound[0]);
        assert_eq!(own[1..], sound[1..], "{row}");
    }
}

#[test]
fn a_roller_that_is_too_large_bears_more() {
    let mut bearing = thirteen(Profile::Flat, 30);
    bearing.imperfections.oversizes = vec![0.0; 13];
    bearing.imperfections.oversizes[0] = 2e-6;
    let state = support(&bearing).state(&[5e-6, 0.0, 0.0, 0.0, 0.0], 0.0, 0.0, CageMotion::Frozen);
    // its approach is larger by its excess
    let stiffness = line_stiffness(8e-3, modulus(&bearing));
    let expected = stiffness * 7e-6f64.powf(10.0 / 9.0);
    assert_near("Q", state.balls[0].inner.load, expected, 1e-9 * expected);
}

#[test]
fn energy_closes_where_rollers_lift_off() {
    let mut damaged = thirteen(Profile::Logarithmic, 30);
    damaged.imperfections.defects = vec![Defect {
        on: Surface::Outer,
        angle: -1.5,
        length: 0.5e-3,
        depth: 0.1e-3,
        profile: DefectProfile::Edges,
    }];
    let wave = Wave {
        order: 14,
        amplitude: 0.3e-6,
        phase: 0.4,
    };
    damaged.imperfections.waves = vec![(Surface::Inner, wave)];
    let mut damped = damaged.clone();
    damped.contact_damping = ContactDamping {
        inner: 0.1,
        outer: 0.2,
    };
    for (bearing, freedoms, load) in [
        (
            thirteen(Profile::Logarithmic, 30),
            Freedoms::Lateral,
            [0.0, -500.0, 0.0, 0.0, 0.1],
        ),
        (damaged, Freedoms::Radial, [0.0, -500.0, 0.0, 0.0, 0.0]),
        (damped, Freedoms::Radial, [0.0, -500.0, 0.0, 0.0, 0.0]),
        (tapered(), Freedoms::All, [0.0, -300.0, 900.0, 0.0, 0.0]),
        (
            spherical(),
            Freedoms::Translational,
            [0.0, -800.0, 100.0, 0.0, 0.0],
        ),
    ] {
        let mut shaft = shaft(freedoms);
        shaft.eccentricity = 20e-6;
        let definition = RotorDefinition {
            speed: 300.0,
            damping: Damping::Coefficients([300.0, 300.0, 300.0, 0.3, 0.3]),
            loads: constant(load),
            initial: InitialState {
                from: InitialPosition::Equilibrium,
                velocity: [Some(2e-3), None, None, None, None],
                ..InitialState::default()
            },
            ..rotor(shaft, vec![bearing])
        };
        let mut model = model(definition, 0.004, 10_000.0);
        model.energy = true;
        // at 1e-9 kinks that steps pass over leave 1.2e-6 of the kinetic energy of the damaged bearing
        model.integrator.tolerance = 2e-10;
        let found = samples(&model, 0.0);
        let start = found[0].energy.expect("energy");
        let residual = |sample: &crate::rotor::Sample| {
            sample.energy.as_ref().expect("energy").residual(&start)
        };
        let worst = found.iter().map(residual).map(f64::abs).fold(0.0, f64::max);
        let kinetic = 0.5 * 5.0 * 2e-3_f64.powi(2);
        assert!(worst < 1e-6 * kinetic, "{worst:e} of {kinetic:e} J");
    }
}
