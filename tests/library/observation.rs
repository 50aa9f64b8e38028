//! What a run observes of its bearings: events, load zone, life, every ball.

use std::f64::consts::{PI, TAU};
use std::io;

use crate::bearing::{
    BallContact, BallLoads, ContactLaw, MountedBearing, Oil, Preload, Profile, Support, Vector5,
};
use crate::physics::RaceControl;
use crate::rotor::load::{Interpolation, Series, SeriesComponent, Shock};
use crate::rotor::{
    BallContacts, CageMotion, Damping, Freedoms, Load, LoadKind, RotorDefinition, Sample,
    SpeedPoint,
};
use crate::simulate::{BearingHistory, Event, EventKind, Model, TraceSink};

use crate::tests::published::rollers::{spherical, thirteen};
use crate::tests::support::{
    assert_near, back_to_back_pair, bearing, constant, literature_bearing, model, mounted, rotor,
    shaft, simulate_into, supports, thrust_rotor,
};

/// Keeps all that a run hands out.
#[derive(Default)]
struct Everything {
    samples: Vec<Sample>,
    balls: Vec<BallContacts>,
    events: Vec<Event>,
}

impl TraceSink for Everything {
    fn needs_contact_angles(&self) -> bool {
        true
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.samples.push(sample.clone());
        Ok(())
    }

    fn balls(&mut self, sample: &Sample, balls: &BallContacts) -> io::Result<()> {
        assert_eq!(self.samples.last(), Some(sample));
        self.balls.push(balls.clone());
        Ok(())
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        self.events.push(*event);
        Ok(())
    }
}

fn observed(model: &Model) -> (Vec<BearingHistory>, Everything) {
    let mut sink = Everything::default();
    let run = simulate_into(model, &mut sink).expect("the model runs");
    (run.bearings, sink)
}

/// A shaft too heavy to move pressed into a bearing of 8 balls with 10 µm of radial clearance: the
/// balls go round, each through the load zone once a turn of the cage.
fn held(mounted: MountedBearing) -> RotorDefinition {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.mass = 1e12;
    RotorDefinition {
        speed: 200.0,
        loads: constant([1000.0, 0.0, 0.0, 0.0, 0.0]),
        ..rotor(shaft, vec![mounted])
    }
}

fn clearance_bearing() -> MountedBearing {
    mounted(literature_bearing(8, [12e-3, 50e-3], CLEARANCE, 8e9))
}

const CLEARANCE: f64 = 10e-6;

fn of_kind(events: &[Event], kind: EventKind) -> Vec<Event> {
    let same = |event: &&Event| event.kind == kind;
    events.iter().filter(same).copied().collect()
}

#[test]
fn a_ball_leaves_the_load_zone_where_its_clearance_opens() {
    let definition = held(clearance_bearing());
    let cage_speed = definition.speed * supports(&definition.bearings)[0].cage_ratio();
    let turns = 3.0;
    for rate in [2e3, 2e4] {
        let model = model(definition.clone(), turns * TAU / cage_speed, rate);
        let (bearings, seen) = observed(&model);
        let place = seen.samples[0].displacement[0];
        // x cos φ = c
        let half_zone = (CLEARANCE / place).acos();
        let lost = of_kind(&seen.events, EventKind::ContactLost);
        let regained = of_kind(&seen.events, EventKind::ContactRegained);
        assert_eq!((lost.len(), regained.len()), (24, 24));
        // linear between samples: an eighth of dt² times the acceleration x ω² cos φ over the speed
        // x ω sin φ; the band of contact is a tenth of a nanometre wide at most
        let by_interpolation = cage_speed / (8.0 * rate * rate * half_zone.tan());
        let by_band = 2e-9 / (place * cage_speed * half_zone.sin());
        let mut largest = 0.0_f64;
        for (events, edge) in [(lost, half_zone), (regained, -half_zone)] {
            for event in events {
                let ball = event.ball.expect("a ball") as f64;
                let azimuth = ball * TAU / 8.0 + cage_speed * event.time;
                // nearest turn
                let off = (azimuth - edge + PI).rem_euclid(TAU) - PI;
                largest = largest.max((off / cage_speed).abs());
            }
        }
        println!("{rate} Hz: {largest:e} s, allowed {by_interpolation:e} + {by_band:e} s");
        assert!(largest <= by_interpolation + by_band);
        assert_eq!(bearings[0].events(EventKind::ContactLost).count, 24);
    }
}

/// The zone holds 2 or 3 of 8 balls by their azimuth alone.
#[test]
fn the_load_zone_is_that_of_geometry() {
    let definition = held(clearance_bearing());
    let cage_speed = definition.speed * supports(&definition.bearings)[0].cage_ratio();
    let (bearings, seen) = observed(&model(definition, TAU / cage_speed, 2e4));
    let half_zone = (CLEARANCE / seen.samples[0].displacement[0]).acos();
    let zone = bearings[0].load_zone.expect("a zone");
    let pitch = TAU / 8.0;
    assert_eq!(zone.balls.smallest, (2.0 * half_zone / pitch).floor());
    assert_eq!(zone.balls.largest, (2.0 * half_zone / pitch).ceil());
    // a ball is in the zone for that share of its turn; counted in samples
    let mean = 8.0 * half_zone / PI;
    assert_near(
        "mean",
        zone.balls.mean,
        mean,
        8.0 / seen.samples.len() as f64,
    );
    // contiguous: the arc is one pitch a ball
    assert_near("arc", zone.extent.mean, pitch * zone.balls.mean, 1e-12);
    let sample = |sample: &Sample| f64::from(sample.balls_loaded.unwrap());
    let traced = seen.samples.iter().map(sample).sum::<f64>() / seen.samples.len() as f64;
    assert_near("as in the trace", zone.balls.mean, traced, 1e-12);
}

/// A radial load bears alike on both rows, whose rollers are at the same azimuths.
#[test]
fn the_arc_of_two_rows_is_that_of_one() {
    let (bearings, seen) = observed(&model(held(spherical()), 0.1, 2e3));
    let zone = bearings[0].load_zone.expect("a zone");
    let pitch = TAU / 15.0;
    assert!(zone.balls.smallest > 0.0 && zone.extent.largest < PI);
    let arc = 0.5 * pitch * zone.balls.mean;
    assert_near("arc", zone.extent.mean, arc, 1e-12);
    // the second row leans the other way
    let (first, second) = seen.balls[0].bearings()[0].angle[0].split_at(15);
    assert!(first.iter().all(|angle| *angle > 0.0) && second.iter().all(|angle| *angle < 0.0));
}

/// A blow that dents the races, and one that no bearing bears.
#[test]
fn rollers_that_are_pressed_too_hard_are_no_balls() {
    for (peak, bears) in [(-150e3, true), (-30e6, false)] {
        let shock = Shock {
            peak: [0.0, peak, 0.0, 0.0, 0.0],
            start: 1e-3,
            duration: 2e-3,
            every: None,
        };
        let mut loads = constant([0.0, -1000.0, 0.0, 0.0, 0.0]);
        loads.push(Load {
            kind: LoadKind::Shock(shock),
            position: 0.0,
        });
        let definition = RotorDefinition {
            speed: 100.0,
            damping: Damping::Ratio(0.1),
            loads,
            ..rotor(shaft(Freedoms::Radial), vec![thirteen(Profile::Flat, 4)])
        };
        let run = simulate_into(&model(definition, 3e-3, 5e4), &mut Everything::default());
        assert_eq!(run.is_ok(), bears, "{run:?}");
        let told = run.map_or_else(|error| error.to_string(), |run| run.warnings.join("\n"));
        assert!(told.contains("roller") && !told.contains("ball"), "{told}");
    }
}

/// Behind a film no load is ever zero; still each ball leaves once a turn, after its dry twin.
#[test]
fn behind_a_film_a_ball_leaves_once_a_turn_and_later() {
    let dry = clearance_bearing();
    let oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    let wet = MountedBearing {
        oil: Some(oil),
        ..dry.clone()
    };
    let [dry, wet] = [dry, wet].map(|mounted| {
        let definition = held(mounted);
        let cage_speed = definition.speed * supports(&definition.bearings)[0].cage_ratio();
        observed(&model(definition, TAU / cage_speed, 2e4)).1
    });
    let [dry_lost, wet_lost] =
        [&dry, &wet].map(|seen| of_kind(&seen.events, EventKind::ContactLost));
    assert_eq!((dry_lost.len(), wet_lost.len()), (8, 8));
    for (dry, wet) in dry_lost.iter().zip(&wet_lost) {
        assert_eq!(dry.ball, wet.ball);
        assert!(wet.time > dry.time);
    }
    let loads = wet
        .balls
        .iter()
        .flat_map(BallContacts::bearings)
        .flat_map(BallLoads::contacts);
    assert!(loads.map(|ball| ball.load_inner).fold(f64::MAX, f64::min) > 0.0);
}

/// 2 kg of weight in a bearing with clearance, shaken by its unbalance until it jumps.
fn chatter() -> Model {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.mass = 2.0;
    shaft.eccentricity = 5e-4;
    shaft.gravity = true;
    let definition = RotorDefinition {
        speed: 300.0,
        damping: Damping::Coefficients([200.0; 5]),
        ..rotor(shaft, vec![clearance_bearing()])
    };
    let mut model = model(definition, 0.5, 2e4);
    model.integrator.tolerance = 1e-8;
    model
}

#[test]
fn events_tell_the_contact_of_every_ball_at_every_sample() {
    let model = chatter();
    let (bearings, seen) = observed(&model);
    let band = supports(&model.rotor.bearings)[0].contact_band(300.0);
    let in_order = |pair: &[Event]| pair[0].time <= pair[1].time;
    assert!(seen.events.windows(2).all(in_order));
    let touches = |ball: BallContact| ball.approach >= band.lost;
    let mut contact: Vec<bool> = seen.balls[0].bearings()[0]
        .contacts()
        .map(touches)
        .collect();
    let mut events = seen.events.iter().peekable();
    for (sample, balls) in seen.samples.iter().zip(&seen.balls) {
        while let Some(event) = events.next_if(|event| event.time <= sample.time) {
            let ball = event.ball.expect("a ball");
            let meets = event.kind == EventKind::ContactRegained;
            assert_ne!(contact[ball], meets, "{event:?}");
            contact[ball] = meets;
        }
        for (ball, contact) in balls.bearings()[0].contacts().zip(&contact) {
            let certain = ball.approach < band.lost || ball.approach > band.regained;
            assert!(!certain || *contact == touches(ball));
        }
    }
    assert_eq!(events.next(), None);
    let counted = bearings[0].events(EventKind::ContactLost);
    let lost = of_kind(&seen.events, EventKind::ContactLost);
    println!("{} times lost", lost.len());
    assert!(lost.len() > 100);
    assert_eq!(counted.count, lost.len() as u64);
    let span = [lost[0].time, lost[lost.len() - 1].time];
    assert_eq!(counted.span, Some(span));
}

#[test]
fn a_settle_time_changes_no_event() {
    let mut model = chatter();
    let (all, before) = observed(&model);
    model.settle = 0.3;
    let (settled, after) = observed(&model);
    assert_eq!(before.events, after.events);
    assert_eq!(all[0].events, settled[0].events);
    assert_ne!(all[0].load_zone, settled[0].load_zone);
}

/// Takes events, and needs no sample for it.
#[derive(Default)]
struct EventsAlone {
    samples: usize,
    events: Vec<Event>,
}

impl TraceSink for EventsAlone {
    fn starts_at(&self) -> f64 {
        f64::INFINITY
    }

    fn sample(&mut self, _: &Sample) -> io::Result<()> {
        self.samples += 1;
        Ok(())
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        self.events.push(*event);
        Ok(())
    }
}

/// Before the settle time samples are left out where neither the sink nor an event needs them.
#[test]
fn samples_that_nobody_needs_are_left_out() {
    for events in [true, false] {
        let mut model = chatter();
        model.settle = 0.8 * model.duration;
        model.spectrum = None;
        model.analyses.settled_only = !events;
        let (bearings, seen) = observed(&model);
        let mut sink = EventsAlone::default();
        let run = simulate_into(&model, &mut sink).expect("the model runs");
        assert_eq!(sink.events, seen.events);
        assert_eq!(run.bearings[0].load_zone, bearings[0].load_zone);
        let looked_at = sink.samples as f64 / seen.samples.len() as f64;
        assert!(events || looked_at < 0.21, "{looked_at}");
        assert_eq!(events, !seen.events.is_empty());
    }
}

/// A pair of 200 N of preload each, struck by 3 kN along +z: the bearing behind it lets go.
fn struck(preload: impl Fn(MountedBearing) -> MountedBearing) -> Model {
    let shock = Shock {
        peak: [0.0, 0.0, 3000.0, 0.0, 0.0],
        start: 5e-3,
        duration: 4e-3,
        every: None,
    };
    let definition = RotorDefinition {
        speed: 100.0,
        damping: Damping::Ratio(0.1),
        loads: vec![Load {
            kind: LoadKind::Shock(shock),
            position: 0.0,
        }],
        ..rotor(
            shaft(Freedoms::All),
            back_to_back_pair().into_iter().map(preload).collect(),
        )
    };
    model(definition, 0.03, 5e4)
}

#[test]
fn a_preload_is_lost_while_no_ball_bears() {
    let (bearings, seen) = observed(&struck(|mounted| mounted));
    // struck along +z, the bearing that faces +z is pressed, the other one let go
    assert_eq!(bearings[0].events(EventKind::PreloadLost).count, 0);
    let lost = of_kind(&seen.events, EventKind::PreloadLost);
    let regained = of_kind(&seen.events, EventKind::PreloadRegained);
    assert!(!lost.is_empty() && lost.len() == regained.len());
    assert!(
        lost.iter()
            .all(|event| (event.bearing, event.ball) == (1, None))
    );
    for (sample, balls) in seen.samples.iter().zip(&seen.balls) {
        let let_go = lost
            .iter()
            .zip(&regained)
            .any(|(lost, regained)| lost.time < sample.time && sample.time < regained.time);
        let loaded = balls.bearings()[1]
            .contacts()
            .any(|ball| ball.load_inner > 1e-3);
        assert_ne!(loaded, let_go, "at {} s", sample.time);
    }
    // the last ball to leave takes the preload along
    let last_ball = seen
        .events
        .iter()
        .filter(|event| event.kind == EventKind::ContactLost && event.time <= lost[0].time)
        .map(|event| event.time)
        .fold(0.0, f64::max);
    assert_eq!(last_ball, lost[0].time);
}

/// A spring holds its force wherever the shaft goes.
#[test]
fn a_spring_never_loses_its_preload() {
    let spring = |mounted: MountedBearing| match mounted.position < 0.0 {
        true => mounted,
        false => MountedBearing {
            preload: Preload::Spring(200.0),
            ..mounted
        },
    };
    let (bearings, _) = observed(&struck(spring));
    assert_eq!(bearings[1].events(EventKind::PreloadLost).count, 0);
}

/// Without preload there is none to lose, and none is counted.
#[test]
fn only_a_preloaded_bearing_counts_its_preload() {
    let kinds = |definition: RotorDefinition| -> Vec<EventKind> {
        let (bearings, _) = observed(&model(definition, 1e-3, 1e4));
        bearings[0].events.iter().map(|(kind, _)| *kind).collect()
    };
    assert_eq!(kinds(thrust_rotor()), EventKind::ALL[..2]);
    let mut preloaded = thrust_rotor();
    preloaded.bearings[0].preload = Preload::Force(100.0);
    assert_eq!(kinds(preloaded), EventKind::ALL);
}

#[test]
fn a_linear_bearing_knows_no_balls() {
    let mut definition = thrust_rotor();
    definition.bearings[0].law = ContactLaw::Linear;
    let (bearings, seen) = observed(&model(definition, 1e-2, 1e4));
    assert_eq!(bearings[0].balls, 0);
    assert!(bearings[0].events.is_empty() && seen.events.is_empty());
    assert!(bearings[0].load_zone.is_none() && bearings[0].life.is_none());
    assert!(
        seen.balls[0]
            .bearings()
            .iter()
            .all(|bearing| bearing.balls() == 0)
    );
}

/// The balls of a trace bear what the trace says the bearings bear.
#[test]
fn the_balls_add_up_to_the_force_on_the_shaft() {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-5;
    let (_, seen) = observed(&model(definition, 0.02, 1e4));
    for (sample, balls) in seen.samples.iter().zip(&seen.balls) {
        let axial: f64 = balls.bearings()[0]
            .contacts()
            .map(|ball| ball.load_inner * ball.angle_inner.sin())
            .sum();
        assert_near(
            "F_z",
            -sample.force_on_shaft.unwrap()[2],
            axial,
            1e-9 * axial,
        );
        assert_near("F_z", balls.axial_forces()[0], axial, 1e-9 * axial);
        let largest = |load: f64, ball: BallContact| load.max(ball.load_inner);
        let largest = balls.bearings()[0].contacts().fold(0.0, largest);
        assert_eq!(sample.largest_ball_load, Some(largest));
    }
}

/// L10r of a bearing standing at a displacement, 10⁶ revolutions.
fn static_life(support: &Support, displacement: &Vector5, speed: f64) -> f64 {
    let life = support
        .state(displacement, 0.0, speed, CageMotion::Frozen)
        .life;
    life.expect("a life")
}

/// With the cage frozen and nothing that moves the shaft, the run is the static state.
#[test]
fn a_constant_load_lives_as_long_as_the_static_bearing() {
    let oil = Some(Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    });
    for (law, oil) in [
        (ContactLaw::Hertz, None),
        (ContactLaw::Hertz, oil),
        (ContactLaw::Jones(RaceControl::Outer), None),
        (ContactLaw::Jones(RaceControl::Outer), oil),
    ] {
        let mut definition = thrust_rotor();
        definition.cage = CageMotion::Frozen;
        definition.loads = constant([0.0, -300.0, 1000.0, 0.0, 0.0]);
        definition.bearings[0].law = law;
        definition.bearings[0].oil = oil;
        let speed = definition.speed;
        let support = Support::new(&definition.bearings[0], speed).expect("a support");
        let (bearings, seen) = observed(&model(definition, 0.1, 1e4));
        let expected = static_life(&support, &seen.samples[0].displacement, speed);
        let life = bearings[0].life.expect("a life").whole_run;
        let value = life.rating_life().expect("a life");
        println!("{law:?}: {value}, {:e} off", value / expected - 1.0);
        assert_near("L10r", value, expected, 1e-9 * expected);
        assert_near("revolutions", life.revolutions, 0.1 * speed / TAU, 1e-9);
        // 10⁶ revolutions at 500 rad/s
        let hours = value * 1e6 * TAU / speed / 3600.0;
        assert_near("hours", life.hours().expect("hours"), hours, 1e-9 * hours);
    }
}

/// ∫ dψ/(2π)/L10r over a function of time that gives 1/L10r and ω, by Simpson's rule.
fn consumed(span: [f64; 2], rate: impl Fn(f64) -> f64) -> f64 {
    let pieces = 400;
    let step = (span[1] - span[0]) / f64::from(pieces);
    let weight = |index| match index {
        0 => 1.0,
        _ if index == pieces => 1.0,
        _ if index % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let term = |index| weight(index) * rate(span[0] + step * f64::from(index));
    (0..=pieces).map(term).sum::<f64>() * step / 3.0 * 1e-6 / TAU
}

/// L10r under a thrust in N at a speed.
fn thrust_life(thrust: f64, speed: f64, law: ContactLaw) -> f64 {
    let mounted = MountedBearing {
        law,
        ..mounted(bearing("7205C"))
    };
    let supports = [Support::new(&mounted, speed).expect("a support")];
    let problem = crate::rotor::StaticProblem {
        supports: &supports,
        load: [0.0, 0.0, thrust, 0.0, 0.0],
        free: [false, false, true, false, false],
        start: [0.0; 5],
        speed,
    };
    let place = problem.solve().expect("an equilibrium").displacement;
    static_life(&supports[0], &place, speed)
}

/// 1000 N and 2000 N by turns: Miner's sum n₁/L₁ + n₂/L₂, and the ramps between.
#[test]
fn two_levels_of_load_add_up_by_miner() {
    let (hold, ramp) = (0.1, 0.04);
    let (mut times, mut extra, mut now) = (vec![0.0], vec![0.0], 0.0);
    for level in [1000.0, 0.0, 1000.0, 0.0] {
        now += hold;
        times.push(now);
        extra.push(*extra.last().expect("a value"));
        now += ramp;
        times.push(now);
        extra.push(level);
    }
    now += hold;
    times.push(now);
    extra.push(0.0);
    let series = Series::new(
        times,
        vec![SeriesComponent {
            axis: 2,
            values: extra,
        }],
        Interpolation::Linear,
    );
    let mut definition = thrust_rotor();
    // slow against the axial mode of some 550 Hz, which is damped well
    definition.damping = Damping::Ratio(0.7);
    definition.loads.push(Load {
        kind: LoadKind::Series(series.expect("a series")),
        position: 0.0,
    });
    let speed = definition.speed;
    let (bearings, _) = observed(&model(definition, now, 2e4));
    let life = |thrust| thrust_life(thrust, speed, ContactLaw::Hertz);
    let [low, high] = [life(1000.0), life(2000.0)];
    let held = hold * speed / TAU * 1e-6 * (3.0 / low + 2.0 / high);
    let ramps = 4.0
        * consumed([0.0, ramp], |time| {
            speed / life(1000.0 + 1000.0 * time / ramp)
        });
    let value = bearings[0].life.expect("a life").whole_run.share;
    println!(
        "levels {held:e}, ramps {ramps:e}, run {value:e}: {:e} off",
        value / (held + ramps) - 1.0
    );
    // The dampers let the balls lag by 0.4 ms: what a rise loses by it a fall gives back. What is
    // left is of second order in the lag, ∫ (d²(1/L)/dP²) Ṗ² (1 − 2ζ²)/ω_n² dt: some 5e-6 of it all.
    assert_near("Miner", value, held + ramps, 1e-5 * held);
    // by the cube of the ball loads, which less than double, for the contact angle rises
    let ratio = low / high;
    assert!((4.0..8.0).contains(&ratio), "{ratio}");
}

/// From rest to 1500 rad/s: revolutions are the integral of the speed, and with ball inertia the
/// life changes along the way.
#[test]
fn a_run_up_consumes_the_integral_over_its_speeds() {
    for law in [ContactLaw::Hertz, ContactLaw::Jones(RaceControl::Outer)] {
        let (duration, top) = (0.5, 1500.0);
        let mut definition = thrust_rotor();
        definition.speed = 0.0;
        definition.speed_points = vec![SpeedPoint {
            time: duration,
            speed: top,
        }];
        definition.bearings[0].law = law;
        // a damper would let the axial motion lag, by 12 µs of the half second at a ratio of 0.02
        definition.damping = Damping::Undamped;
        let (bearings, _) = observed(&model(definition, duration, 2e4));
        let speed = |time: f64| top * time / duration;
        let expected = consumed([0.0, duration], |time| {
            speed(time) / thrust_life(1000.0, speed(time), law)
        });
        let life = bearings[0].life.expect("a life").whole_run;
        println!("{law:?}: {:e} off", life.share / expected - 1.0);
        assert_near("share", life.share, expected, 1e-7 * expected);
        let revolutions = 0.5 * top * duration / TAU;
        assert_near("revolutions", life.revolutions, revolutions, 1e-9);
        let rest = thrust_life(1000.0, 0.0, law);
        let value = life.rating_life().expect("a life");
        let same = (value / rest - 1.0).abs() < 1e-6;
        assert_eq!(same, law == ContactLaw::Hertz, "{value} and {rest}");
    }
}

#[test]
fn without_a_rating_or_at_rest_there_is_no_life() {
    let mut unrated = thrust_rotor();
    unrated.bearings[0].bearing.dynamic_rating = None;
    let mut standing = thrust_rotor();
    standing.speed = 0.0;
    for definition in [unrated, standing] {
        let (bearings, _) = observed(&model(definition, 1e-2, 1e4));
        assert_eq!(bearings[0].life, None);
        assert!(bearings[0].load_zone.is_some());
    }
}

/// The life after the settle time rests on the samples after it.
#[test]
fn the_settle_time_is_left_out_of_the_life() {
    let mut model = model(thrust_rotor(), 0.1, 1e4);
    model.settle = 0.04;
    let (bearings, _) = observed(&model);
    let life = bearings[0].life.expect("a life");
    assert_near("time", life.after_settle.time, 0.06, 1e-12);
    assert_near("time", life.whole_run.time, 0.1, 1e-12);
    let [whole, settled] = [life.whole_run, life.after_settle].map(|life| life.rating_life());
    let (whole, settled) = (whole.expect("a life"), settled.expect("a life"));
    assert_near("L10r", settled, whole, 1e-9 * whole);
}
