//! Any bytes as recorded motion.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::trace(bytes));
