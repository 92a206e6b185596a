//! Any bytes as the shape of a link.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::shape(bytes));
