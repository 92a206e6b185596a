//! Any bytes as an encrypted library.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::archive(bytes));
