//! Any bytes as the description of an arm.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::arm(bytes));
