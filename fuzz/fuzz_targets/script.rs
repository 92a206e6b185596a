//! Any bytes as a script of a run.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::script(bytes));
