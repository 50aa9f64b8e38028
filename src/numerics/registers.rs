//! Steps in registers as wide as the processor has them.

/// Evaluates an expression compiled for the wide registers of a level of the processor, or as all code is
/// where it has none, by a token of its width where one is named: twice instead of once a level, for steps are
/// long and there are many of them. What it calls must be inlined to be compiled for them; no products are
/// fused, so that the numbers are the same.
macro_rules! in_wide_registers {
    ($level:expr, $simd:ident => $value:expr) => {{
        #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
        {
            match $level.as_avx2() {
                Some($simd) => fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $value,
                ),
                None => $crate::numerics::registers::in_baseline_registers!($simd => $value),
            }
        }
        #[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2")))]
        {
            fearless_simd::dispatch!($level, $simd => $value)
        }
    }};
    ($level:expr, $value:expr) => {
        in_wide_registers!($level, _simd => $value)
    };
}

/// Evaluates an expression by a token of the registers that every processor of the target has: compiled once, for
/// what need not be fast.
macro_rules! in_baseline_registers {
    ($simd:ident => $value:expr) => {{
        #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2"))]
        {
            let $simd = fearless_simd::Level::baseline().as_sse2();
            let $simd = $simd.expect("the target has SSE2");
            $value
        }
        #[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "sse2")))]
        {
            fearless_simd::dispatch!(fearless_simd::Level::baseline(), $simd => $value)
        }
    }};
}

pub(crate) use {in_baseline_registers, in_wide_registers};
