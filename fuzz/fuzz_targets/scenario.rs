//! Any bytes as a test scenario.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::scenario(bytes));
