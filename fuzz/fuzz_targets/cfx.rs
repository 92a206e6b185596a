//! Any bytes as the files of a controller around an application.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::cfx(bytes));
