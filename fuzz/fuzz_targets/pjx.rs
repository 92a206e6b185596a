//! Any bytes as a project file.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::parse(bytes));
