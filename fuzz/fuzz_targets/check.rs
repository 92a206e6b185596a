//! Any bytes as a complete application.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::check(bytes));
