//! What keeps a spectrum from being estimated.

/// Why a spectrum could not be estimated.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EstimateError {
    /// The record holds no segment.
    #[error(
        "the record holds {samples} samples (after the settle time of a run), and a segment {needed}: make it longer or the \
         segment shorter"
    )]
    TooShort {
        /// Samples there are.
        samples: usize,
        /// Samples of a segment.
        needed: usize,
    },
    /// A segment of hardly any samples.
    #[error("a segment of {samples} samples is too short: at least {needed} make a spectrum")]
    ShortSegment {
        /// Its samples.
        samples: usize,
        /// Fewest samples.
        needed: usize,
    },
    /// The shaft turns back, and its angle says no more where the record is.
    #[error("the shaft turns back at t = {time:.4e} s: there is no spectrum over its orders")]
    TurnsBack {
        /// Time, s.
        time: f64,
    },
    /// Less than one revolution.
    #[error(
        "the shaft makes {turns:.2} revolutions (after the settle time of a run): a spectrum over orders needs at least one"
    )]
    NoRevolution {
        /// Revolutions there are.
        turns: f64,
    },
    /// The shaft is so fast that no order is below half the sampling rate.
    #[error(
        "the shaft turns at up to {speed:.4e} rad/s, and {rate:.4e} samples a second are fewer than two a revolution: a spectrum over \
         orders needs a higher sampling rate; of a measured speed, check the unit"
    )]
    TooFast {
        /// Highest speed, rad/s.
        speed: f64,
        /// Samples a second.
        rate: f64,
    },
    /// Revolutions of changing length make no segments of equal time.
    #[error(
        "the speed changes, and segments in revolutions are not equally long: take the spectrum over orders, or give the segment \
         in seconds"
    )]
    UnevenRevolutions,
    /// Seconds make no segments of equal angle.
    #[error("a spectrum over orders has segments in revolutions, not in seconds")]
    SecondsOverOrders,
    /// The product of two channels has no amplitude.
    #[error("a cross spectrum is a power or a density: it has no amplitude")]
    CrossAmplitude,
}
