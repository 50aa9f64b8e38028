//! Bearings of rotors that move side by side.

use fearless_simd::Simd;

use super::hertz_law::lateral;
use super::ring_lanes::{Azimuths, LaneSums};
use super::support::{imposed, on_shaft};
use super::{HertzLaw, LANES, Lanes, Ring, Support};

/// A number of every rotor side by side.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(32))]
pub(crate) struct LaneRow(pub [f64; LANES]);

impl LaneRow {
    /// In a register.
    #[inline(always)]
    pub fn load<S: Simd>(&self, simd: S) -> Lanes<S> {
        simd.load_array_ref_f64x4(&self.0)
    }
}

/// Bearings of as many rotors that move side by side, a rotor a lane: no sum leaves its lane, and none is
/// without a ball.
///
/// The equations are those of [`Ring`] under the [`HertzLaw`], summed ball after ball.
#[derive(Debug, Clone)]
pub(crate) struct SupportEnsemble {
    /// Ball by ball.
    azimuths: Vec<Azimuths>,
    sign: LaneRow,
    position: LaneRow,
    free_axial: LaneRow,
    free_radial: LaneRow,
    arm: LaneRow,
    load_deflection_constant: LaneRow,
    distance: LaneRow,
}

impl SupportEnsemble {
    /// The bearings side by side; none unless they are plain Hertz rings of equally many balls in fixed seats.
    pub fn new(supports: [&Support; LANES]) -> Option<Self> {
        let [Some(a), Some(b), Some(c), Some(d)] = supports.map(plain) else {
            return None;
        };
        let rings = [a, b, c, d];
        let balls = a.0.azimuths.len();
        if rings.iter().any(|(ring, _)| ring.azimuths.len() != balls) {
            return None;
        }
        let row = |of: fn(&Ring<HertzLaw>) -> f64| LaneRow(rings.map(|(ring, _)| of(ring)));
        let azimuths = (0..balls).map(|ball| rings.map(|(ring, _)| ring.azimuths[ball]));
        Some(Self {
            azimuths: azimuths.map(|lanes| Azimuths::new(&lanes)).collect(),
            sign: LaneRow(supports.map(|support| support.sign)),
            position: LaneRow(supports.map(|support| support.definition.position)),
            free_axial: LaneRow(rings.map(|(ring, offset)| ring.free_axial + offset)),
            free_radial: row(|ring| ring.free_radial),
            arm: row(|ring| ring.arm),
            load_deflection_constant: row(|ring| ring.law().load_deflection_constant),
            distance: row(|ring| ring.law().distance),
        })
    }

    /// Forces and moments that hold each shaft at its displacement against its bearing, by the cosines and
    /// sines of the cages.
    #[inline(always)]
    pub fn forces<S: Simd>(
        &self,
        simd: S,
        displacement: &[Lanes<S>; 5],
        cage: [Lanes<S>; 2],
    ) -> [Lanes<S>; 5] {
        let [sign, position] = [self.sign.load(simd), self.position.load(simd)];
        let [start, arm] = [self.free_axial.load(simd), self.arm.load(simd)];
        let free_radial = self.free_radial.load(simd);
        let stiffness = self.load_deflection_constant.load(simd);
        let distance = self.distance.load(simd);
        let place = imposed(displacement, sign, position);
        let mut sums = LaneSums::new(simd);
        for azimuths in &self.azimuths {
            let directions = azimuths.turned_by(simd, cage);
            let axial = directions.axial(start, &place, arm);
            let radial = directions.radial(free_radial, &place);
            let lateral = lateral(axial, radial, stiffness, distance);
            let force = lateral * axial;
            sums.add(&directions, [lateral * radial, force, force]);
        }
        on_shaft(&sums.forces(arm), sign, position)
    }
}

/// The ring of a bearing and its axial preset in m, where they know nothing but Hertz contacts.
pub(super) fn plain(support: &Support) -> Option<(&Ring<HertzLaw>, f64)> {
    match support.frozen {
        Some(_) => None,
        None => support.plain_ring(),
    }
}
