//! Steps in registers as wide as the processor has them.

/// Evaluates an expression compiled for the wide registers of a level of the processor, or as all code is
/// where it has none, by a token of its width where one is named: twice instead of once a level, for steps are
/// long and there are many of them. What it calls must be inlined to be compiled for them; no products are
/// fused, so that the numbers are the same.
macro_rules! in_wide_registers {
    ($level:expr, $simd:ident => $value:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            match $level.as_avx2() {
                Some($simd) => fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $value,
                ),
                None => {
                    let $simd = fearless_simd::Fallback::new();
                    $value
                }
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            fearless_simd::dispatch!($level, $simd => $value)
        }
    }};
    ($level:expr, $value:expr) => {
        in_wide_registers!($level, _simd => $value)
    };
}

pub(crate) use in_wide_registers;
