//! Waves around a surface.

/// One wave around a race or a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Waves around the circumference, n.
    pub order: u32,
    /// Amplitude A normal to the surface, m.
    pub amplitude: f64,
    /// Phase φ, rad.
    pub phase: f64,
}

/// Waves of one surface: it lies lower by
///
/// ```text
/// h(θ) = Σ A cos(n θ + φ)
/// ```
///
/// in m at the angle θ from its mark.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Waves(Vec<Term>);

#[derive(Debug, Clone, Copy, PartialEq)]
struct Term {
    order: f64,
    /// Orders from the term before it.
    gap: u32,
    /// A cos φ and A sin φ.
    parts: [f64; 2],
}

impl Waves {
    /// Several waves at once.
    pub fn new(waves: impl Iterator<Item = Wave>) -> Self {
        let mut waves: Vec<Wave> = waves.collect();
        waves.sort_by_key(|wave| wave.order);
        let mut before = 0;
        let term = |wave: Wave| {
            let gap = wave.order - std::mem::replace(&mut before, wave.order);
            let (sin, cos) = wave.phase.sin_cos();
            Term {
                order: f64::from(wave.order),
                gap,
                parts: [wave.amplitude * cos, wave.amplitude * sin],
            }
        };
        Self(waves.into_iter().map(term).collect())
    }

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        self.0.is_empty()
    }

    /// Sum of the amplitudes, m.
    pub fn bound(&self) -> f64 {
        let amplitudes = self.0.iter().map(|term| term.parts[0].hypot(term.parts[1]));
        amplitudes.sum()
    }

    /// Drop, m, and its slope by the angle, m/rad, in the direction (cos θ, sin θ).
    pub fn at(&self, direction: [f64; 2]) -> [f64; 2] {
        let mut turned = [1.0, 0.0];
        let [mut drop, mut slope] = [0.0; 2];
        for Term { order, gap, parts } in &self.0 {
            turned = product(turned, power(direction, *gap));
            drop += parts[0] * turned[0] - parts[1] * turned[1];
            slope -= order * (parts[0] * turned[1] + parts[1] * turned[0]);
        }
        [drop, slope]
    }
}

/// Product of two complex numbers.
fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// A whole power of a complex number.
fn power(mut base: [f64; 2], mut exponent: u32) -> [f64; 2] {
    if exponent == 1 {
        return base;
    }
    let mut result = [1.0, 0.0];
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = product(result, base);
        }
        base = product(base, base);
        exponent >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_add_up_with_their_slopes() {
        let wave = |order, amplitude, phase| Wave {
            order,
            amplitude,
            phase,
        };
        let waves = [
            wave(37, 2e-7, 1.0),
            wave(2, 5e-6, -0.4),
            wave(36, 1e-7, 0.0),
            wave(2, 1e-6, 2.0),
        ];
        let sum = Waves::new(waves.into_iter());
        let angle = 2.3_f64;
        let (sin, cos) = angle.sin_cos();
        let [drop, slope] = sum.at([cos, sin]);
        let terms = waves.map(|wave| {
            let order = f64::from(wave.order);
            let (sin, cos) = (order * angle + wave.phase).sin_cos();
            [wave.amplitude * cos, -order * wave.amplitude * sin]
        });
        let [expected, by_angle] =
            [0, 1].map(|part| terms.iter().map(|term| term[part]).sum::<f64>());
        assert!((drop - expected).abs() < 1e-18);
        assert!((slope - by_angle).abs() < 1e-16);
        assert!((sum.bound() - 6.3e-6).abs() < 1.2e-6);
    }
}
