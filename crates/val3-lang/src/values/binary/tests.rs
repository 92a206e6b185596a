use proptest::prelude::{Strategy, any, prop_assert, prop_assert_eq, proptest};
use proptest::sample::select;

use super::*;

const FORMATS: [&str; 14] =
    ["-1", "1", "-2l", "-2b", "2l", "2b", "-4l", "-4b", "4l", "4b", "4.0l", "4.0b", "8.0l", "8.0b"];
const INVALID: Result<f64> = Err(Fault::INVALID_PARAMETER);

fn encoded(format: &str, value: f64) -> Vec<u8> {
    BinaryFormat::parse(format).unwrap().encode(value).collect()
}

fn decoded(format: &str, bytes: &[u8]) -> Option<f64> {
    let bytes: Vec<f64> = bytes.iter().map(|&byte| f64::from(byte)).collect();
    BinaryFormat::parse(format).unwrap().decode(&bytes)
}

#[track_caller]
fn check(format: &str, value: f64, bytes: &[u8]) {
    assert_eq!(encoded(format, value), bytes);
    assert_eq!(decoded(format, bytes), Some(value));
}

#[test]
fn bytes() {
    check("1", 0.0, &[0]);
    check("1", 255.0, &[255]);
    check("-1", 127.0, &[127]);
    check("-1", -1.0, &[255]);
    check("-1", -128.0, &[128]);
}

#[test]
fn words_in_both_orders() {
    check("2l", 258.0, &[2, 1]);
    check("2b", 258.0, &[1, 2]);
    check("2b", 65535.0, &[255, 255]);
    check("-2l", -2.0, &[254, 255]);
    check("-2b", -2.0, &[255, 254]);
    check("-2b", -32768.0, &[128, 0]);
    check("-2b", 32767.0, &[127, 255]);
}

#[test]
fn double_words_in_both_orders() {
    check("4l", 16_909_060.0, &[4, 3, 2, 1]);
    check("4b", 16_909_060.0, &[1, 2, 3, 4]);
    check("4b", 4_294_967_295.0, &[255; 4]);
    check("-4l", -2.0, &[254, 255, 255, 255]);
    check("-4b", -2.0, &[255, 255, 255, 254]);
    check("-4b", -2_147_483_648.0, &[128, 0, 0, 0]);
    check("-4l", 2_147_483_647.0, &[255, 255, 255, 127]);
}

#[test]
fn floating_point_in_both_orders() {
    check("4.0l", 1.0, &[0, 0, 0x80, 0x3f]);
    check("4.0b", 1.0, &[0x3f, 0x80, 0, 0]);
    check("4.0b", -2.5, &[0xc0, 0x20, 0, 0]);
    check("8.0l", 1.0, &[0, 0, 0, 0, 0, 0, 0xf0, 0x3f]);
    check("8.0b", 1.0, &[0x3f, 0xf0, 0, 0, 0, 0, 0, 0]);
    check("8.0b", 0.1, &[0x3f, 0xb9, 0x99, 0x99, 0x99, 0x99, 0x99, 0x9a]);
    check("8.0b", f64::MAX, &[0x7f, 0xef, 255, 255, 255, 255, 255, 255]);
    assert_eq!(decoded("4.0b", &encoded("4.0b", 0.1)), Some(f64::from(0.1_f32)));
}

#[test]
fn the_nearest_number_of_the_format_is_encoded() {
    assert_eq!(
        [254.5, 255.49, 256.0, 1e300, -0.6, -1.0].map(|value| encoded("1", value)[0]),
        [255, 255, 255, 255, 0, 0]
    );
    assert_eq!([127.6, -128.6, -0.5, -0.6].map(|value| encoded("-1", value)[0]), [127, 128, 0, 255]);
    assert_eq!(encoded("2b", 65536.0), [255, 255]);
    assert_eq!([encoded("-2b", 32768.0), encoded("-2b", -32769.0)], [[127, 255], [128, 0]]);
    assert_eq!(encoded("4b", 4_294_967_296.0), [255; 4]);
    assert_eq!([encoded("-4b", 1e10), encoded("-4b", -1e10)], [[127, 255, 255, 255], [128, 0, 0, 0]]);
    assert_eq!(
        [1e300, -1e300].map(|value| decoded("4.0l", &encoded("4.0l", value))),
        [f32::MAX, f32::MIN].map(|value| Some(f64::from(value)))
    );
    assert_eq!(encoded("4b", f64::NAN), [0; 4]);
}

#[test]
fn the_unknown_format_is_refused() {
    for format in ["", "0", "2", "4", "8", "-2", "1l", "-1b", "8l", "8.0", "4.0", "-8.0l", "4.0L", "2B", " 1", "1 "] {
        assert_eq!(BinaryFormat::parse(format), Err(Fault::INVALID_PARAMETER), "{format}");
        assert_eq!(to_binary(&[], 0.0, format, &mut []), INVALID, "{format}");
        assert_eq!(from_binary(&[], 0.0, format, &mut []), INVALID, "{format}");
    }
}

#[test]
fn a_transformation_goes_to_another_device() {
    let sent = [100.5, -200.25, 300.125, 0.1, -179.99999, 90.0];
    let (mut bytes, mut received) = ([0.0; 48], [0.0; 6]);
    assert_eq!(to_binary(&sent, 6.0, "8.0b", &mut bytes), Ok(48.0));
    assert_eq!(from_binary(&bytes, 48.0, "8.0b", &mut received), Ok(6.0));
    assert_eq!(received, sent);
}

#[test]
fn encodes_the_first_numbers() {
    let mut bytes = [9.0; 6];
    assert_eq!(to_binary(&[1.0, 2.0, 3.0], 2.4, "2b", &mut bytes), Ok(4.0));
    assert_eq!(bytes, [0.0, 1.0, 0.0, 2.0, 9.0, 9.0]);
    assert_eq!(to_binary(&[1.0], 0.0, "2b", &mut bytes), Ok(0.0));
}

#[test]
fn encodes_only_values_that_exist_and_fit() {
    let mut bytes = [9.0; 4];
    assert_eq!(to_binary(&[1.0, 2.0], 2.0, "2b", &mut bytes), Ok(4.0));
    bytes = [9.0; 4];
    assert_eq!(to_binary(&[1.0, 2.0], 3.0, "1", &mut bytes), INVALID);
    assert_eq!(to_binary(&[1.0, 2.0], -1.0, "1", &mut bytes), INVALID);
    assert_eq!(to_binary(&[1.0, 2.0], 2.0, "2b", &mut bytes[..3]), INVALID);
    assert_eq!(to_binary(&[1.0, 2.0], 1e300, "8.0b", &mut bytes), INVALID);
    assert_eq!(bytes, [9.0; 4]);
}

#[test]
fn decodes_the_first_bytes() {
    let mut values = [9.0; 3];
    assert_eq!(from_binary(&[0.0, 1.0, 0.0, 2.0, 0.0, 3.0], 4.4, "2b", &mut values), Ok(2.0));
    assert_eq!(values, [1.0, 2.0, 9.0]);
    assert_eq!(from_binary(&[0.0, 5.0, 6.0], 3.0, "2b", &mut values), Ok(1.0));
    assert_eq!(values, [5.0, 2.0, 9.0]);
    assert_eq!(from_binary(&[0.0], 0.0, "2b", &mut values), Ok(0.0));
}

#[test]
fn decodes_only_bytes_that_exist_and_fit() {
    let mut values = [9.0; 2];
    assert_eq!(from_binary(&[1.0, 2.0], 2.0, "1", &mut values), Ok(2.0));
    values = [9.0; 2];
    assert_eq!(from_binary(&[1.0, 2.0], 3.0, "1", &mut values), INVALID);
    assert_eq!(from_binary(&[1.0, 2.0], -1.0, "1", &mut values), INVALID);
    assert_eq!(from_binary(&[1.0, 2.0], 2.0, "1", &mut values[..1]), INVALID);
    assert_eq!(values, [9.0; 2]);
}

#[test]
fn corrupt_bytes_end_the_decoding() {
    let mut values = [9.0; 3];
    assert_eq!(from_binary(&[1.0, 2.0, 256.0], 3.0, "1", &mut values), Ok(-2.0));
    assert_eq!(values, [1.0, 2.0, 9.0]);
    assert_eq!(from_binary(&[7.0, -1.0, 3.0], 3.0, "1", &mut values), Ok(-1.0));
    assert_eq!(values, [7.0, 2.0, 9.0]);
    assert_eq!(from_binary(&[f64::NAN, 1.0], 2.0, "1", &mut values), Ok(0.0));
    assert_eq!(from_binary(&[0.0, 1.0, 0.0, 256.0], 4.0, "2b", &mut values), Ok(-1.0));
}

#[test]
fn bytes_are_rounded_before() {
    let mut values = [0.0; 4];
    assert_eq!(from_binary(&[-0.5, 0.5, 254.5, 255.49], 4.0, "1", &mut values), Ok(4.0));
    assert_eq!(values, [0.0, 1.0, 255.0, 255.0]);
    assert_eq!(from_binary(&[255.5], 1.0, "1", &mut values), Ok(0.0));
    assert_eq!(from_binary(&[-0.51], 1.0, "1", &mut values), Ok(0.0));
}

#[test]
fn infinite_numbers_are_corrupt() {
    assert_eq!(decoded("4.0b", &[0x7f, 0x80, 0, 0]), None);
    assert_eq!(decoded("4.0b", &[0x7f, 0xc0, 0, 0]), None);
    assert_eq!(decoded("4.0b", &[0x7f, 0x7f, 255, 255]), Some(f64::from(f32::MAX)));
    for odd in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(decoded("8.0l", &odd.to_le_bytes()), None);
    }
}

fn any_format() -> impl Strategy<Value = (&'static str, BinaryFormat)> {
    select(FORMATS.as_slice()).prop_map(|name| (name, BinaryFormat::parse(name).unwrap()))
}

proptest! {
    #[test]
    fn doubles_survive(value in any::<f64>(), high_first in any::<bool>()) {
        let format = if high_first { "8.0b" } else { "8.0l" };
        prop_assert_eq!(decoded(format, &encoded(format, value)), Some(value).filter(|value| value.is_finite()));
    }

    #[test]
    fn decoded_values_encode_to_the_same_bytes((name, format) in any_format(), bytes in any::<[u8; 8]>()) {
        let bytes = &bytes[..format.width()];
        if let Some(value) = decoded(name, bytes) {
            prop_assert_eq!(encoded(name, value), bytes);
        }
    }

    #[test]
    fn encoded_values_can_be_decoded((name, format) in any_format(), value in -1e300..1e300) {
        let bytes = encoded(name, value);
        prop_assert_eq!(bytes.len(), format.width());
        prop_assert!(decoded(name, &bytes).is_some());
    }

    #[test]
    fn the_orders_mirror_each_other(name in select(&["2", "-2", "4", "-4", "4.0", "8.0"][..]), value in -1e6..1e6) {
        let mut low_first = encoded(&format!("{name}l"), value);
        low_first.reverse();
        prop_assert_eq!(low_first, encoded(&format!("{name}b"), value));
    }
}
