//! Nodes on a closed curve of states, and trigonometric interpolation between them.

use std::f64::consts::TAU;

use nalgebra::DMatrix;

/// A node may be off its even share of the circle by this part of the distance of two nodes.
const UNEVEN: f64 = 0.25;
/// Periods searched for nodes, per node.
const LONGEST_SEARCH: u64 = 1 << 13;

/// States at the same phase of a first forcing, and all around the phase of a second one.
///
/// The first forcing has the period T, and while it passes the phase of the second one turns by ρ. A
/// function of that phase is kept by its values at an odd number M of nodes, as a Fourier series of
/// (M − 1)/2 harmonics. The nodes are phases after whole periods, picked so that they are spaced almost
/// evenly: a system that knows nothing but time can be integrated from them.
#[derive(Debug, Clone, PartialEq)]
pub struct Circle {
    /// The period T, s.
    pub period: f64,
    /// How far the second phase turns in a period, rad.
    pub rotation: f64,
    /// Numbers of whole periods after which the nodes are passed.
    pub strobes: Vec<u64>,
    /// The nodes: phases of the second forcing, rad.
    pub angles: Vec<f64>,
    /// Mean, and cosine and sine of every harmonic in turn, from values at the nodes: a matrix.
    pub coefficients: DMatrix<f64>,
    /// Matrix from values at the nodes to those a period later.
    pub shift: DMatrix<f64>,
}

impl Circle {
    /// A single state: there is no second forcing.
    pub fn point(period: f64) -> Self {
        Self {
            period,
            rotation: 0.0,
            strobes: vec![0],
            angles: vec![0.0],
            coefficients: DMatrix::identity(1, 1),
            shift: DMatrix::identity(1, 1),
        }
    }

    /// Nodes for a number of harmonics of a second forcing that turns by `rotation` (rad) in a period
    /// (s); `None` where whole periods do not lead all around, as where both repeat together soon.
    pub fn around(period: f64, rotation: f64, harmonics: usize) -> Option<Self> {
        let strobes = nodes(rotation, 2 * harmonics + 1, Self::searched(harmonics))?;
        let angles: Vec<f64> = strobes.iter().map(|j| phase(rotation, *j)).collect();
        let coefficients = basis(&angles, harmonics).try_inverse()?;
        let shift = basis(&turned(&angles, rotation), harmonics) * &coefficients;
        Some(Self {
            period,
            rotation,
            strobes,
            angles,
            coefficients,
            shift,
        })
    }

    /// Periods that are searched for the nodes of a number of harmonics.
    pub fn searched(harmonics: usize) -> u64 {
        LONGEST_SEARCH * (2 * harmonics as u64 + 1)
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.angles.len()
    }

    /// Number of harmonics.
    pub fn harmonics(&self) -> usize {
        self.angles.len() / 2
    }

    /// Matrix from mean, and cosine and sine of every harmonic in turn, to values at the nodes.
    pub fn basis(&self) -> DMatrix<f64> {
        basis(&self.angles, self.harmonics())
    }

    /// Matrix from values at the nodes to those a period before.
    pub fn back(&self) -> DMatrix<f64> {
        self.values_at(&turned(&self.angles, -self.rotation))
    }

    /// Matrix from values at the nodes to the values at other phases, rad.
    pub fn values_at(&self, angles: &[f64]) -> DMatrix<f64> {
        basis(angles, self.harmonics()) * &self.coefficients
    }

    /// Phase of the second forcing after whole periods, rad.
    pub fn phase(&self, strobe: u64) -> f64 {
        phase(self.rotation, strobe)
    }
}

fn turned(angles: &[f64], by: f64) -> Vec<f64> {
    angles.iter().map(|angle| angle + by).collect()
}

/// 1, cos φ, sin φ, cos 2φ, …, a row an angle.
fn basis(angles: &[f64], harmonics: usize) -> DMatrix<f64> {
    DMatrix::from_fn(angles.len(), 2 * harmonics + 1, |row, column| {
        let turned = column.div_ceil(2) as f64 * angles[row];
        if column % 2 == 1 || column == 0 {
            turned.cos()
        } else {
            turned.sin()
        }
    })
}

/// Phase after whole periods, 0 … 2π; whole turns are taken off before they cost digits.
fn phase(rotation: f64, strobe: u64) -> f64 {
    TAU * (rotation / TAU * strobe as f64).rem_euclid(1.0)
}

/// The first whole periods that lead almost evenly around.
fn nodes(rotation: f64, count: usize, searched: u64) -> Option<Vec<u64>> {
    let mut found: Vec<Option<u64>> = vec![None; count];
    let mut left = count;
    for strobe in 0..searched {
        let share = phase(rotation, strobe) / TAU * count as f64;
        let nearest = share.round();
        let slot = &mut found[nearest as usize % count];
        if slot.is_none() && (share - nearest).abs() <= UNEVEN {
            *slot = Some(strobe);
            left -= 1;
            if left == 0 {
                return found.into_iter().collect();
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_period_is_not_turned() {
        assert_eq!(Circle::point(0.5).shift[(0, 0)], 1.0);
    }

    #[test]
    fn harmonics_are_turned_exactly() {
        let circle =
            Circle::around(1.0, 0.3 * 3f64.sqrt(), 2).expect("an irrational part of a turn");
        // a second harmonic is turned exactly
        let values = circle.angles.iter().map(|angle| (2.0 * angle).cos());
        let values = nalgebra::DVector::from_iterator(5, values);
        let turned = &circle.shift * values;
        let expected = (2.0 * (circle.angles[1] + 0.3 * 3f64.sqrt())).cos();
        assert!((turned[1] - expected).abs() < 1e-14);
    }
}
