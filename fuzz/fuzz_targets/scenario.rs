//! Any bytes as a scenario of tests.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::scenario(bytes));
