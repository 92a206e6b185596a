//! Any bytes as a `val3.toml`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::config(bytes));
