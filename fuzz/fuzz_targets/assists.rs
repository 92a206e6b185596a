//! Bytes that choose a program, which prints the same before and after each assist.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| val3_fuzz::assists(bytes));
