//! Static deflections and mode shapes of a shaft that bends, along its length.

use nalgebra::{Complex, DVector};

use super::{Mode, Rotor};

/// Deflections of a shaft that bends, at its nodes from the left end on.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ShaftShape<T> {
    /// Positions of the nodes, m.
    pub positions: Vec<f64>,
    /// Along x and along y.
    pub deflections: [Vec<T>; 2],
}

impl Rotor {
    /// Deflections at the static equilibrium, m; none where the shaft is rigid.
    pub(crate) fn static_shape(&self) -> Option<ShaftShape<f64>> {
        let place = DVector::from_column_slice(&self.start.rest);
        self.shape_of(|rows| (rows * &place).iter().copied().collect())
    }

    /// Shape of a mode, of any size; none where the shaft is rigid.
    pub(crate) fn mode_shape(&self, mode: &Mode) -> Option<ShaftShape<Complex<f64>>> {
        // u = Lᵀ q
        let root = self.linear.mass.root().transpose().lu();
        let part = |of: fn(&Complex<f64>) -> f64| {
            let scaled = DVector::from_iterator(mode.shape.len(), mode.shape.iter().map(of));
            root.solve(&scaled)
        };
        let (real, imaginary) = (part(|own| own.re)?, part(|own| own.im)?);
        self.shape_of(|rows| {
            let (dofs, followers) = (real.len(), &self.structure.followers);
            let mut moving = rows.columns(0, dofs).into_owned();
            if !followers.is_empty() {
                let first = rows.ncols() - followers.nrows();
                moving += rows.columns(first, followers.nrows()) * followers;
            }
            let parts = [&moving * &real, &moving * &imaginary];
            let pairs = parts[0].iter().zip(parts[1].iter());
            pairs.map(|(re, im)| Complex::new(*re, *im)).collect()
        })
    }

    fn shape_of<T>(
        &self,
        deflections: impl Fn(&nalgebra::DMatrix<f64>) -> Vec<T>,
    ) -> Option<ShaftShape<T>> {
        let bending = self.structure.bending.as_ref()?;
        Some(ShaftShape {
            positions: bending.nodes.clone(),
            deflections: bending.deflections.each_ref().map(deflections),
        })
    }
}
