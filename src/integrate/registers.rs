//! Sums over stages in registers as wide as the processor has them.

/// Evaluates an expression compiled for the wide registers of a level of the processor, or as all code is
/// where it has none: twice instead of once a level, for trial steps are long and there are many of them. What
/// it calls must be inlined to be compiled for them; no products are fused, so that the numbers are the same.
macro_rules! in_wide_registers {
    ($level:expr, $value:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            match $level.as_avx2() {
                Some(avx2) => fearless_simd::Simd::vectorize(
                    avx2,
                    #[inline(always)]
                    || $value,
                ),
                None => $value,
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            // other processors have no wider registers than those that all code is compiled for
            let _ = $level;
            $value
        }
    }};
}

pub(super) use in_wide_registers;
