//! What it costs to ask a system for its derivative.

/// Time that a system takes to answer, on one core of one server.
///
/// Whoever chooses by it needs ratios alone, and no clock: the same scene is always worth the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Of the derivative, s.
    pub derivative: f64,
    /// Of its slopes, s.
    pub linearisation: f64,
}

impl Effort {
    /// Of a system of a few products that says nothing of itself.
    pub const SMALL: Self = Self {
        derivative: 50e-9,
        linearisation: 500e-9,
    };
}
