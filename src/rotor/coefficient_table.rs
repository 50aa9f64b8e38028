//! Springs and dampers whose coefficients follow the speed of the shaft, as those of journal bearings and seals.

use super::element::ElementMotion;
use super::force_law::ForceLaw;
use super::load::{Interpolation, Series, SeriesComponent, SeriesError};
use super::{LinearLaw, dot};
use crate::bearing::{Matrix5, Vector5};

/// Stiffness and damping over the speed, `F = K(ω) u + C(ω) u̇`. Between the rows they follow monotone cubics, beyond the
/// first and the last row the coefficients of that row are kept, those of a single row at all speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct CoefficientTable {
    /// First and last speed, rad/s.
    speeds: [f64; 2],
    stiffness: Series,
    damping: Series,
}

/// Entries of K and of C, in this order: row and column.
const ENTRIES: [(usize, usize); 5] = [(0, 0), (0, 1), (1, 0), (1, 1), (2, 2)];

impl CoefficientTable {
    /// Of rising speeds in rad/s and columns of K and of C: xx, xy, yx, yy, zz.
    ///
    /// # Errors
    /// [`SeriesError`] with the row that is wrong.
    pub(crate) fn new(
        speeds: &[f64],
        [stiffness, damping]: [Vec<Vec<f64>>; 2],
    ) -> Result<Self, SeriesError> {
        // a series has two rows
        let twice = |row: &[f64], apart: f64| match row {
            [only] => vec![*only, only + apart],
            rows => rows.to_vec(),
        };
        let series = |columns: Vec<Vec<f64>>| {
            let columns = columns.into_iter().enumerate();
            let columns = columns.map(|(axis, values)| SeriesComponent {
                axis,
                values: twice(&values, 0.0),
            });
            let (speeds, columns) = (twice(speeds, 1.0), columns.collect());
            Series::new(speeds, columns, Interpolation::MonotoneCubic)
        };
        let (stiffness, damping) = (series(stiffness)?, series(damping)?);
        Ok(Self {
            speeds: [speeds[0], speeds[speeds.len() - 1]],
            stiffness,
            damping,
        })
    }

    /// First and last speed, rad/s.
    pub(crate) fn speeds(&self) -> [f64; 2] {
        self.speeds
    }

    /// The coefficients at a speed in rad/s.
    pub(crate) fn at(&self, speed: f64) -> LinearLaw {
        let [stiffness, damping] = [&self.stiffness, &self.damping].map(|series| {
            let mut matrix = Matrix5::zeros();
            for (place, value) in ENTRIES.into_iter().zip(series.at(speed)) {
                matrix[place] = value;
            }
            matrix
        });
        LinearLaw { stiffness, damping }
    }
}

impl ForceLaw for CoefficientTable {
    fn force(&self, motion: &ElementMotion) -> Vector5 {
        let law = self.at(motion.rotation.speed);
        law.force(&motion.displacement, &motion.rate)
    }

    fn slopes(&self, motion: &ElementMotion) -> [Matrix5; 2] {
        let law = self.at(motion.rotation.speed);
        [law.stiffness, law.damping]
    }

    fn supplied(&self, motion: &ElementMotion) -> f64 {
        let law = self.at(motion.rotation.speed);
        -dot(&law.force(&motion.displacement, &[0.0; 5]), &motion.rate)
    }
}
