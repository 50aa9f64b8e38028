//! Fits and temperatures of a mounted bearing: what they leave of its clearance, contact angle and preload.

use super::{Bearing, BearingError, Facing, FitState, MountedBearing, Preload, Support};
use crate::physics::{
    Material, STEEL_EXPANSION, inner_ring_fit, outer_ring_fit, thermal_clearance_change,
};

/// How a bearing sits on its shaft and in its housing, and how warm everything is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Interference of inner ring and shaft, of outer ring and housing, at the reference temperature, m.
    pub interference: [f64; 2],
    /// Bore of the shaft, zero of a solid one, m.
    pub shaft_bore: f64,
    /// Outside diameter of the housing, infinite of a thick one, m.
    pub housing_outside: f64,
    /// Materials of shaft and housing.
    pub mates: [Material; 2],
    /// Thermal expansion of shaft and housing, 1/K.
    pub expansions: [f64; 2],
    /// Thermal expansion of the balls, 1/K; the rings are of steel.
    pub ball_expansion: f64,
    /// Temperatures of inner ring, balls and outer ring above the reference, K.
    pub rings: [f64; 3],
    /// Temperatures of shaft and housing above the reference, K.
    pub around: [f64; 2],
}

impl Fit {
    /// What the fit does to the clearance of a bearing of a bore and an outside diameter in m.
    fn state(&self, bearing: &Bearing, [bore, outside]: [f64; 2]) -> FitState {
        let geometry = &bearing.geometry;
        let (ball, pitch) = (geometry.ball_diameter(), geometry.pitch_diameter());
        let [inner, _, outer] = self.rings;
        let [shaft, housing] =
            std::array::from_fn(|side| self.expansions[side] * self.around[side]);
        // what the mates grow more than the rings
        let interference = [
            self.interference[0] + bore * (shaft - STEEL_EXPANSION * inner),
            self.interference[1] + outside * (STEEL_EXPANSION * outer - housing),
        ];
        let ring = &bearing.ring_material;
        let ([on_shaft, in_housing], [shaft, housing]) = (interference, &self.mates);
        let (hole, wall) = (self.shaft_bore, self.housing_outside);
        let fits = [
            inner_ring_fit(bore, pitch - ball, hole, on_shaft, ring, shaft),
            outer_ring_fit(outside, pitch + ball, wall, in_housing, ring, housing),
        ];
        let clearance_loss = fits.map(|fit| fit.clearance_loss);
        let thermal_change = thermal_clearance_change(ball, pitch, self.rings, self.ball_expansion);
        FitState {
            interference,
            pressure: fits.map(|fit| fit.pressure),
            clearance_loss,
            thermal_change,
            clearance_change: thermal_change - clearance_loss[0] - clearance_loss[1],
            angle_before: geometry.contact_angle(),
            angle: geometry.contact_angle(),
            axial_offset: None,
        }
    }

    /// How far the inner ring of a bearing at a position in m moves along Z from its outer ring, m.
    ///
    /// `a (α_s ΔT_s − α_h ΔT_h)`
    fn axial_growth(&self, position: f64) -> f64 {
        let [shaft, housing] = self.around;
        position * (self.expansions[0] * shaft - self.expansions[1] * housing)
    }
}

impl MountedBearing {
    /// The bearing in operation, from one that is mounted without interference at the reference temperature: clearance and
    /// contact angle change, and with rings that keep their axial places the preload.
    ///
    /// ```text
    /// A cos α' = A cos α − ΔP_d/2     δ' = δ + A (sin α − sin α') + s a (α_s ΔT_s − α_h ΔT_h)
    /// ```
    ///
    /// δ is the axial preset, s the facing, a the position from the centre of mass. A preload given as a force is that before;
    /// a spring presses as before.
    ///
    /// # Errors
    /// [`BearingError`] where the contact angle exceeds 60° or the balls are squeezed too much, or the preload cannot be reached.
    pub(crate) fn with_fit(&self, fit: &Fit, boundary: [f64; 2]) -> Result<Self, BearingError> {
        let before = &self.bearing.geometry;
        let mut state = fit.state(&self.bearing, boundary);
        let geometry = before.with_clearance_change(state.clearance_change)?;
        state.angle = geometry.contact_angle();
        let preload = match self.preload {
            Preload::Spring(force) => Preload::Spring(force),
            _ => {
                let alone = Self {
                    facing: Facing::PlusZ,
                    ..self.clone()
                };
                let offset = Support::new(&alone, 0.0)?.seat.offset();
                let growth = self.facing.sign() * fit.axial_growth(self.position);
                let shift = before.free_axial() - geometry.free_axial();
                let after = offset + shift + growth;
                state.axial_offset = Some([offset, after]);
                Preload::AxialOffset(after)
            }
        };
        Ok(Self {
            bearing: Bearing {
                geometry,
                fit: Some(state),
                ..self.bearing
            },
            preload,
            ..self.clone()
        })
    }
}
