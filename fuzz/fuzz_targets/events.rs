//! Any bytes as the events of a run that is repeated.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::events(bytes));
