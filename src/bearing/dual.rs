//! A number that carries its slopes along.

use std::ops::{Add, Div, Mul, Sub};

use super::number::{Function, Number, Plain};

/// A number and its slopes by D variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<T, const D: usize> {
    /// The number.
    pub value: T,
    /// Its slopes.
    pub slopes: [T; D],
}

impl<T: Plain, const D: usize> Dual<T, D> {
    /// A number that does not change with the variables.
    #[inline(always)]
    pub fn fixed(value: T) -> Self {
        Self {
            value,
            slopes: [value.constant(0.0); D],
        }
    }

    /// The variable with this index.
    #[inline(always)]
    pub fn variable(value: T, index: usize) -> Self {
        let mut dual = Self::fixed(value);
        dual.slopes[index] = value.constant(1.0);
        dual
    }

    /// A function of it with this value, and with this slope by it.
    #[inline(always)]
    pub fn chained(mut self, value: T, factor: T) -> Self {
        for slope in &mut self.slopes {
            *slope = *slope * factor;
        }
        self.value = value;
        self
    }
}

impl<T: Plain, const D: usize> Number for Dual<T, D> {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self::fixed(self.value.constant(value))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let slope = root.constant(0.5) / (root + f64::MIN_POSITIVE);
        self.chained(root, slope)
    }

    #[inline(always)]
    fn positive(self) -> Self {
        let mut positive = self;
        for slope in &mut positive.slopes {
            *slope = self.value.if_positive(*slope);
        }
        positive.value = self.value.positive();
        positive
    }

    #[inline(always)]
    fn apply<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> [Self; M] {
        let mut position = [at[0].value; K];
        for k in 0..K {
            position[k] = at[k].value;
        }
        let (values, slopes) = T::with_slopes(function, position);
        let mut result = [Self::fixed(values[0]); M];
        for m in 0..M {
            result[m].value = values[m];
            for d in 0..D {
                for k in 0..K {
                    result[m].slopes[d] = result[m].slopes[d] + slopes[m][k] * at[k].slopes[d];
                }
            }
        }
        result
    }
}

impl<T: Plain, const D: usize> Add for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        self.value = self.value + other.value;
        for d in 0..D {
            self.slopes[d] = self.slopes[d] + other.slopes[d];
        }
        self
    }
}

impl<T: Plain, const D: usize> Sub for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        self.value = self.value - other.value;
        for d in 0..D {
            self.slopes[d] = self.slopes[d] - other.slopes[d];
        }
        self
    }
}

impl<T: Plain, const D: usize> Mul for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mut product = self;
        product.value = self.value * other.value;
        for d in 0..D {
            product.slopes[d] = self.slopes[d] * other.value + self.value * other.slopes[d];
        }
        product
    }
}

impl<T: Plain, const D: usize> Div for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let mut quotient = self;
        quotient.value = self.value / other.value;
        let inverse = other.value.constant(1.0) / other.value;
        for d in 0..D {
            quotient.slopes[d] = (self.slopes[d] - quotient.value * other.slopes[d]) * inverse;
        }
        quotient
    }
}

impl<T: Plain, const D: usize> Add<f64> for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn add(mut self, other: f64) -> Self {
        self.value = self.value + other;
        self
    }
}

impl<T: Plain, const D: usize> Sub<f64> for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn sub(mut self, other: f64) -> Self {
        self.value = self.value - other;
        self
    }
}

impl<T: Plain, const D: usize> Mul<f64> for Dual<T, D> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let factor = self.value.constant(other);
        self.chained(self.value * other, factor)
    }
}
