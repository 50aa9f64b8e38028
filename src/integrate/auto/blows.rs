//! Blows that a run is to take: loads between breaks that make contacts open or close, and the ringing after them.

use nalgebra::SMatrix;

use crate::integrate::System;
use crate::integrate::course::Course;

/// Stretches between breaks that are looked at.
const STRETCHES: u32 = 40;
/// How far a pulse of half a sine throws, over how far its peak would hold, per radian of the motion in it.
const PULSE: f64 = 2.0 / std::f64::consts::PI;

/// How long a motion rings with blows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blows {
    /// Part of the time up to an end, s, in which it does.
    pub part: f64,
    pub end: f64,
}

impl Blows {
    /// Of a run with these slopes at the origin, whose modes have a mean frequency, rad/s, and have decayed after some
    /// time, s.
    pub fn ahead<S: System<N>, const N: usize>(
        course: &Course<'_, S, N>,
        slopes: &SMatrix<f64, N, N>,
        frequency: f64,
        decayed: f64,
    ) -> Self {
        let (mut start, mut rings, mut until) = (course.limit_after(0.0), 0.0, 0.0_f64);
        for _ in 1..STRETCHES {
            if start >= course.end {
                break;
            }
            let end = course.limit_after(start);
            if opens_or_closes_contacts(course, slopes, [start, end], frequency) {
                let over = (end + decayed).min(course.end);
                rings += over - start.max(until);
                until = over;
            }
            start = end;
        }
        // what comes later is taken to be as what was seen
        let (seen, end) = if start < course.end {
            (start.max(until), course.end)
        } else {
            (until, until)
        };
        let part = if rings > 0.0 { rings / seen } else { 0.0 };
        Self { part, end }
    }
}

/// Whether what drives the motion between two times, s, throws it from the origin over surfaces.
fn opens_or_closes_contacts<S: System<N>, const N: usize>(
    course: &Course<'_, S, N>,
    slopes: &SMatrix<f64, N, N>,
    [start, end]: [f64; 2],
    frequency: f64,
) -> bool {
    let (system, origin) = (course.system, &course.scaling.origin);
    if !system.is_second_order() {
        return false;
    }
    let middle = 0.5 * (start + end);
    let (mut rate, mut state) = ([0.0; N], *origin);
    system.derivative(middle, origin, &mut rate);
    let thrown = (PULSE * frequency * (end - start)).min(1.0);
    for i in 0..N / 2 {
        // each freedom by itself
        let stiffness = -slopes[(N / 2 + i, i)];
        if stiffness > 0.0 {
            state[i] += thrown * rate[N / 2 + i] / stiffness;
        }
    }
    if system.shift([origin, &state]) < system.clearance(origin) {
        return false;
    }
    let sides = |state| system.surroundings(middle, state).sides;
    sides(&state) != sides(origin)
}
