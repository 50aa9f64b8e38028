//! What is sought, and what was measured.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::{Effort, NoAnswer, Point, Scene, Work};
use crate::study::Variable;

/// A quantity of a scenario whose value is sought.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    /// Its key and unit.
    pub variable: Variable,
    /// Least and largest value.
    pub range: [f64; 2],
    /// Where the first search starts.
    pub start: f64,
    /// Whether the ends of its range are one, as those of a full turn.
    pub wraps: bool,
}

/// A number that was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    /// What it is called.
    pub name: String,
    /// Unit of the number, as it is computed.
    pub unit: String,
    /// What was measured.
    pub measured: f64,
    /// Its standard deviation, where that is known.
    pub sigma: Option<f64>,
    /// Whether it is an angle, rad, of which whole turns do not matter.
    pub wraps: bool,
}

/// What is sought, and what was measured.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// The unknowns.
    pub unknowns: &'a [Unknown],
    /// The observations, as many as numbers of a point.
    pub observations: &'a [Observation],
    /// The numbers at values of the unknowns.
    pub scene: Scene<'a>,
    /// Searches from different starts.
    pub starts: usize,
    /// Threads, and whether to stop.
    pub work: Work<'a>,
}

/// A place in the ranges, each from 0 to 1, with what is computed there.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub shares: DVector<f64>,
    pub point: Point,
    pub residuals: DVector<f64>,
    /// Slopes of the residuals by the shares, as far as the search knows them.
    pub slopes: Option<DMatrix<f64>>,
    /// Whether it is the lowest around: the search was neither stopped nor given up.
    pub is_lowest: bool,
}

impl Place {
    /// χ².
    pub fn chi_square(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

impl Unknown {
    /// Length of its range.
    pub fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    /// A share of its range that is within it.
    pub(super) fn inside(&self, share: f64) -> f64 {
        match self.wraps {
            true => share.rem_euclid(1.0),
            false => share.clamp(0.0, 1.0),
        }
    }
}

impl Observation {
    /// Difference of a computed number from the measured one, in standard deviations or, where none is known, in parts of
    /// what was measured.
    pub fn residual(&self, computed: f64) -> f64 {
        self.in_turn(computed - self.measured) / self.sigma.unwrap_or_else(|| self.scale())
    }

    /// A number; of an angle within half a turn of zero.
    pub fn in_turn(&self, value: f64) -> f64 {
        match self.wraps {
            true => value - TAU * (value / TAU).round(),
            false => value,
        }
    }

    /// What residuals are parts of where no standard deviation is known: of an angle a radian; what was measured is not zero.
    pub fn scale(&self) -> f64 {
        match self.wraps {
            true => 1.0,
            false => self.measured.abs(),
        }
    }
}

impl Problem<'_> {
    /// Whether the standard deviations of the observations are known.
    pub(super) fn has_deviations(&self) -> bool {
        self.observations.iter().all(|one| one.sigma.is_some())
    }

    /// Values at shares of the ranges.
    pub fn values(&self, shares: &DVector<f64>) -> Vec<f64> {
        let pairs = self.unknowns.iter().zip(shares.iter());
        pairs
            .map(|(unknown, share)| match *share {
                1.0 => unknown.range[1],
                share => unknown.range[0] + share * unknown.length(),
            })
            .collect()
    }

    /// What is computed at a place, from a neighbour.
    pub(super) fn place(
        &self,
        shares: DVector<f64>,
        near: Option<&Point>,
        effort: Effort,
    ) -> Result<Place, NoAnswer> {
        let point = (self.scene)(&self.values(&shares), near, effort)?;
        let pairs = self.observations.iter().zip(&point.numbers);
        let residuals = pairs.map(|(observation, number)| observation.residual(number.value));
        let residuals = DVector::from_vec(residuals.collect());
        match residuals.iter().all(|residual| residual.is_finite()) {
            true => Ok(Place {
                shares,
                point,
                residuals,
                slopes: None,
                is_lowest: false,
            }),
            false => Err(NoAnswer::Failed("a number is missing there".to_owned())),
        }
    }

    /// Difference of two places, the short way round where a range has no ends.
    pub(super) fn apart(&self, first: &DVector<f64>, second: &DVector<f64>) -> DVector<f64> {
        let mut apart = first - second;
        for (part, unknown) in apart.iter_mut().zip(self.unknowns) {
            *part -= if unknown.wraps { part.round() } else { 0.0 };
        }
        apart
    }
}
