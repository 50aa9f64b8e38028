//! Bearings seen at instants side by side against the same seen by themselves.

use super::*;
use crate::bearing::{
    CageAngle, ContactDamping, ContactLaw, Facing, MountedBearing, Preload, Vector5, catalogue,
};

/// A preset bearing off the centre of mass that faces −z.
pub(in crate::bearing) fn support(name: &str) -> Support {
    let entry = catalogue::find(name).expect("in the catalogue");
    let mounted = MountedBearing {
        bearing: entry.bearing().expect("a bearing"),
        law: ContactLaw::Hertz,
        oil: None,
        position: 0.03,
        facing: Facing::MinusZ,
        preload: Preload::AxialOffset(8e-6),
        contact_damping: ContactDamping::default(),
        first_ball: 0.1,
    };
    Support::new(&mounted, 0.0).expect("a support")
}

fn places(step: i32) -> ([Vector5; LANES], [f64; LANES]) {
    let part = |lane: usize| f64::from(step) * 0.37 + 1.3 * lane as f64;
    let place = |lane| [3e-5, 2e-5, 4e-5, 1e-3, 2e-3].map(|size| size * part(lane).sin());
    (std::array::from_fn(place), std::array::from_fn(part))
}

/// Axis by axis.
fn look(seen: &mut SupportObservation, places: &[Vector5; LANES], cages: [f64; LANES]) {
    let rows: [[f64; LANES]; 5] =
        std::array::from_fn(|axis| places.each_ref().map(|place| place[axis]));
    seen.make_room(1);
    seen.observe(0, rows.each_ref(), &cages, 1.0);
}

fn near(found: f64, expected: f64, scale: f64) {
    assert!(
        (found - expected).abs() < 1e-11 * scale,
        "{found:e} {expected:e}"
    );
}

#[test]
fn every_instant_is_what_it_is_by_itself() {
    for name in ["7205C", "6306"] {
        let support = support(name);
        let mut seen = SupportObservation::new(&support).expect("a plain bearing");
        let mut alone = vec![BallContact::default(); support.known_balls()];
        let mut beside = alone.clone();
        for step in 0..200 {
            let (places, cages) = places(step);
            look(&mut seen, &places, cages);
            for lane in 0..LANES {
                let cage = CageAngle::new(cages[lane]);
                let force = support.force(&places[lane], cage, 0.0);
                support.observe_balls(&places[lane], cage, 0.0, true, &mut alone);
                seen.fill(lane, true, &mut beside);
                let largest = alone.iter().map(|ball| ball.load_inner);
                let largest = largest.fold(1.0, f64::max);
                for (row, expected) in seen.force(0).iter().zip(force) {
                    near(row.0[lane], expected, 10.0 * largest);
                }
                for (ball, expected) in beside.iter().zip(&alone) {
                    near(ball.load_inner, expected.load_inner, largest);
                    near(ball.load_outer, expected.load_outer, largest);
                    near(ball.angle_outer, expected.angle_outer, 1.0);
                    near(ball.approach, expected.approach, 1e-4);
                }
                near(seen.axial_force(0, lane), -force[2], 10.0 * largest);
            }
        }
    }
}

#[test]
fn extremes_and_powers_are_those_of_its_balls() {
    let support = support("6306");
    let mut seen = SupportObservation::new(&support).expect("a plain bearing");
    let rating = RatingLife::new(&support.definition().bearing.geometry, 23_400.0);
    for step in 0..200 {
        let (places, cages) = places(step);
        look(&mut seen, &places, cages);
        for lane in 0..LANES {
            let loads = || seen.loads(lane);
            let extremes = [loads().fold(0.0, f64::max), loads().fold(1e9, f64::min)];
            let found = [seen.largest_loads(0), seen.smallest_loads(0)];
            assert_eq!(found.map(|loads| loads[lane]), extremes);
            let approaches = seen.approaches().map(|approaches| approaches[lane]);
            let lowest = approaches.fold(f64::INFINITY, f64::min);
            assert_eq!(seen.lowest_approach(0)[lane], lowest);
            for (found, power) in seen.seen[0].powers.iter().zip([3.0, 10.0 / 3.0]) {
                let expected: f64 = loads().map(|load| load.powf(power)).sum();
                near(found.0[lane], expected, expected);
            }
            let life = rating.consumption(loads().map(|load| [load; 2]));
            let mut found = [[0.0; LANES]];
            seen.consumptions(&rating, &mut found);
            near(found[0][lane], life, life);
        }
    }
}

#[test]
fn neighbours_and_widths_of_registers_change_no_byte() {
    let wide = SupportObservation::new(&support("7205C")).expect("a plain bearing");
    let narrow = SupportObservation {
        level: Level::baseline(),
        ..wide.clone()
    };
    let bytes = |mut seen: SupportObservation, places, cages, lane: usize| {
        look(&mut seen, &places, cages);
        let loads: Vec<u64> = seen.loads(lane).map(f64::to_bits).collect();
        (loads, seen.force(0).map(|row| row.0[lane].to_bits()))
    };
    for step in 0..50 {
        let (places, cages) = places(step);
        let together = bytes(wide.clone(), places, cages, 2);
        let copies = bytes(wide.clone(), [places[2]; LANES], [cages[2]; LANES], 0);
        assert_eq!(together, copies);
        assert_eq!(together, bytes(narrow.clone(), places, cages, 2));
    }
}

#[test]
fn groups_seen_at_once_are_each_what_they_are_by_themselves() {
    let mut seen = SupportObservation::new(&support("6306")).expect("a plain bearing");
    let mut alone = seen.clone();
    seen.make_room(3);
    let groups: Vec<_> = (0..3).map(places).collect();
    let row = |axis: usize| -> Vec<[f64; LANES]> {
        let of = |places: &[Vector5; LANES]| places.each_ref().map(|place| place[axis]);
        groups.iter().map(|(places, _)| of(places)).collect()
    };
    let rows: [_; 5] = std::array::from_fn(row);
    let angles: Vec<_> = groups.iter().map(|(_, cages)| *cages).collect();
    seen.observe_all(rows.each_ref().map(Vec::as_slice), &angles, 1.0);
    for (number, (places, cages)) in groups.iter().enumerate() {
        look(&mut alone, places, *cages);
        let of = |seen: &SupportObservation, number| {
            let force = seen.force(number).map(|row| row.0);
            let loads = [seen.largest_loads(number), seen.smallest_loads(number)];
            (
                force,
                loads.map(|loads| *loads),
                *seen.lowest_approach(number),
            )
        };
        assert_eq!(of(&seen, number), of(&alone, 0));
    }
}
