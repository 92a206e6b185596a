//! Any bytes as an arm file.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::arm(bytes));
