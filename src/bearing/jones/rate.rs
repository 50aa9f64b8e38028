//! A number that carries its derivatives by the state of a ball.

/// Value and derivatives by the length at the inner race and by both contact angles.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rate {
    pub(super) value: f64,
    /// By the distance L_i of ball and inner groove centre, 1/m.
    pub(super) by_length: f64,
    /// By the contact angle α_i, 1/rad.
    pub(super) by_inner: f64,
    /// By the contact angle α_o, 1/rad.
    pub(super) by_outer: f64,
}

impl Rate {
    /// `weight` × `self` + (1 − `weight`) × `other`; the weight depends on the length alone.
    #[inline(always)]
    pub(super) fn blend(&self, other: &Self, weight: &Self) -> Self {
        let (mine, others) = (weight.value, 1.0 - weight.value);
        Self {
            value: mine * self.value + others * other.value,
            by_length: mine * self.by_length
                + others * other.by_length
                + weight.by_length * (self.value - other.value),
            by_inner: mine * self.by_inner + others * other.by_inner,
            by_outer: mine * self.by_outer + others * other.by_outer,
        }
    }

    /// `self` − `other`
    #[inline(always)]
    pub(super) fn minus(&self, other: &Self) -> Self {
        Self {
            value: self.value - other.value,
            by_length: self.by_length - other.by_length,
            by_inner: self.by_inner - other.by_inner,
            by_outer: self.by_outer - other.by_outer,
        }
    }

    /// `self` × `factor`
    #[inline(always)]
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            by_length: self.by_length * factor,
            by_inner: self.by_inner * factor,
            by_outer: self.by_outer * factor,
        }
    }
}
