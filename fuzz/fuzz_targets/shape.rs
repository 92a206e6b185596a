//! Any bytes as a link shape.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::shape(bytes));
