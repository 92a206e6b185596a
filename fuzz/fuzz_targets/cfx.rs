//! Any bytes as the controller files around an application.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::cfx(bytes));
