//! Basic reference rating life of ISO/TS 16281.

use super::Geometry;

/// Basic reference rating life L10r of a single-row radial ball bearing with a turning inner ring,
/// 10⁶ revolutions; none where no ball is loaded.
///
/// ```text
/// g    = 1.044 ((1 − γ)/(1 + γ))^1.72 (f_i (2f_o − 1)/(f_o (2f_i − 1)))^0.41
/// Q_ci = C/(0.407 Z cos^0.7 α) (1 + g^(10/3))^0.3
/// Q_ce = C/(0.389 Z cos^0.7 α) (1 + g^(−10/3))^0.3
/// Q_ei = (mean of Q_i³)^(1/3)   Q_ee = (mean of Q_o^(10/3))^(3/10)
/// L10r = [(Q_ci/Q_ei)^(−10/3) + (Q_ce/Q_ee)^(−10/3)]^(−9/10)
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | C | basic dynamic radial load rating, `dynamic_rating` | N |
/// | Q_i, Q_o | `loads` of every ball at the inner and the outer race, 0 where unloaded | N |
/// | α | nominal contact angle, [`Geometry::nominal_angle`] | rad |
/// | γ | D cos α/d_m with that nominal angle | – |
/// | f_i, f_o | groove factors | – |
///
/// The load stands still and the inner ring turns past it. Lubrication, contamination and fatigue
/// limit are left out. Balls thrown outwards load the outer race alone, and wear it.
///
/// Source: ISO/TS 16281:2008, eqs. for radial ball bearings; ISO 281.
pub fn reference_rating_life(
    geometry: &Geometry,
    dynamic_rating: f64,
    loads: impl Iterator<Item = [f64; 2]>,
) -> Option<f64> {
    let sums = loads.fold([0.0; 2], |[inner, outer], [load_inner, load_outer]| {
        [
            inner + load_inner.powi(3),
            outer + load_outer.powi(3) * load_outer.cbrt(),
        ]
    });
    let consumption = RatingLife::new(geometry, dynamic_rating).consumption(sums);
    (consumption > 0.0).then(|| 1.0 / consumption)
}

/// How fast a bearing lives under given loads: the reciprocal of [`reference_rating_life`], which
/// Miner's rule sums along a history of loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatingLife {
    /// Q_ci^(−10/3)/Z^(10/9) and Q_ce^(−10/3)/Z.
    weights: [f64; 2],
}

impl RatingLife {
    /// Of a bearing with the basic dynamic load rating C in N.
    pub fn new(geometry: &Geometry, dynamic_rating: f64) -> Self {
        let [inner, outer] = race_ratings(geometry, dynamic_rating);
        let balls = geometry.balls() as f64;
        Self {
            weights: [
                inner.powf(-10.0 / 3.0) * balls.powf(-10.0 / 9.0),
                outer.powf(-10.0 / 3.0) / balls,
            ],
        }
    }

    /// 1/L10r per 10⁶ revolutions under sums over the balls of Q_i³ and Q_o^(10/3), as a
    /// [`super::BallLoads`] has them; zero without load.
    ///
    /// ```text
    /// 1/L10r = [(Q_ei/Q_ci)^(10/3) + (Q_ee/Q_ce)^(10/3)]^(9/10)
    /// Q_ei^(10/3) = (mean of Q_i³)^(10/9)   Q_ee^(10/3) = mean of Q_o^(10/3)
    /// ```
    pub fn consumption(&self, [inner, outer]: [f64; 2]) -> f64 {
        let damage = self.weights[0] * inner.powf(10.0 / 9.0) + self.weights[1] * outer;
        damage.powf(0.9)
    }
}

/// Basic dynamic load ratings Q_ci and Q_ce of one ball at the inner and the outer race, N.
fn race_ratings(geometry: &Geometry, dynamic_rating: f64) -> [f64; 2] {
    let cosine = geometry.nominal_angle().cos();
    let gamma = geometry.ball_diameter() * cosine / geometry.pitch_diameter();
    let (f_i, f_o) = (
        geometry.groove_factor_inner(),
        geometry.groove_factor_outer(),
    );
    // g = 1.044 ((1 − γ)/(1 + γ))^1.72 (f_i (2f_o − 1)/(f_o (2f_i − 1)))^0.41
    let g = 1.044
        * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72)
        * (f_i * (2.0 * f_o - 1.0) / (f_o * (2.0 * f_i - 1.0))).powf(0.41);
    // C/(Z cos^0.7 α)
    let share = dynamic_rating / (geometry.balls() as f64 * cosine.powf(0.7));
    [
        // Q_ci = C/(0.407 Z cos^0.7 α) (1 + g^(10/3))^0.3
        share / 0.407 * (1.0 + g.powf(10.0 / 3.0)).powf(0.3),
        // Q_ce = C/(0.389 Z cos^0.7 α) (1 + g^(−10/3))^0.3
        share / 0.389 * (1.0 + g.powf(-10.0 / 3.0)).powf(0.3),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::catalogue;

    #[test]
    fn nothing_is_consumed_without_load() {
        let bearing = catalogue::find("6305").expect("an entry").bearing();
        let rating = RatingLife::new(&bearing.expect("a bearing").geometry, 23_400.0);
        let consumption = |load: f64| rating.consumption([load; 2]);
        assert_eq!(consumption(0.0), 0.0);
        assert!(consumption(300.0) > 0.0 && consumption(f64::NAN).is_nan());
    }

    #[test]
    fn half_the_load_lives_eight_times_as_long() {
        let bearing = catalogue::find("6305").expect("an entry").bearing();
        let geometry = bearing.expect("a bearing").geometry;
        let life =
            |load: f64| reference_rating_life(&geometry, 23_400.0, [[load; 2]; 7].into_iter());
        // (10/3) 0.9 = 3
        let ratio = life(100.0).expect("a life") / life(200.0).expect("a life");
        assert!((ratio - 8.0).abs() < 1e-12);
        assert_eq!(life(0.0), None);
    }
}
