//! The widest instructions of the processor, chosen at run time.

#[cfg(target_arch = "x86_64")]
use fearless_simd::{Level, Simd as _};

/// Does this compiled for the widest instructions there are: to be called with closures marked `#[inline(always)]` that call
/// nothing but what is inlined.
#[expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instructions chosen at run time"
)]
#[inline(always)]
pub(crate) fn widest<R>(job: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    {
        let level = Level::new();
        if let Some(simd) = level.as_avx512() {
            return simd.vectorize(job);
        }
        if let Some(simd) = level.as_avx2() {
            return simd.vectorize(job);
        }
    }
    job()
}
