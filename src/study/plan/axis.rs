//! The values that one number of a scenario takes.

use super::Distribution;

/// The values of one number of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The values.
    pub values: AxisValues,
}

/// Where the values of an axis come from.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisValues {
    /// A list, SI units.
    Listed(Vec<f64>),
    /// Evenly spaced.
    Spaced {
        /// First value, SI units.
        from: f64,
        /// Last value, SI units.
        to: f64,
        /// How many.
        count: u64,
        /// Whether by equal ratios instead of equal differences.
        logarithmic: bool,
    },
    /// Drawn.
    Drawn(Distribution),
}

impl Axis {
    /// Number of values on a grid; zero where they are drawn.
    pub fn length(&self) -> u64 {
        match &self.values {
            AxisValues::Listed(values) => values.len() as u64,
            AxisValues::Spaced { count, .. } => *count,
            AxisValues::Drawn(_) => 0,
        }
    }

    /// Value number `index` of a grid; NaN where there is none.
    pub fn value(&self, index: u64) -> f64 {
        match &self.values {
            AxisValues::Listed(values) => {
                let index = usize::try_from(index).ok();
                index
                    .and_then(|index| values.get(index))
                    .map_or(f64::NAN, |value| *value)
            }
            AxisValues::Spaced {
                from,
                to,
                count,
                logarithmic,
            } => between(*from, *to, *logarithmic, index, count.saturating_sub(1)),
            AxisValues::Drawn(_) => f64::NAN,
        }
    }

    /// Value that a share of all draws does not exceed: a list is drawn from evenly, spaced values are a
    /// uniform distribution from the first to the last (of the logarithm, where spaced by ratios).
    pub fn quantile(&self, share: f64) -> f64 {
        match &self.values {
            AxisValues::Listed(values) => {
                let index = (share * values.len() as f64) as usize;
                let last = values.len().saturating_sub(1);
                values.get(index.min(last)).map_or(f64::NAN, |value| *value)
            }
            AxisValues::Spaced {
                from,
                to,
                logarithmic,
                ..
            } => part_way(*from, *to, *logarithmic, share),
            AxisValues::Drawn(distribution) => distribution.quantile(share),
        }
    }
}

/// Value `index` of those that divide a range into `steps`, exact at both ends.
fn between(from: f64, to: f64, logarithmic: bool, index: u64, steps: u64) -> f64 {
    match index {
        0 => from,
        _ if index >= steps => to,
        _ => part_way(from, to, logarithmic, index as f64 / steps as f64),
    }
}

fn part_way(from: f64, to: f64, logarithmic: bool, part: f64) -> f64 {
    if logarithmic {
        return (from.ln() * (1.0 - part) + to.ln() * part).exp();
    }
    from * (1.0 - part) + to * part
}
