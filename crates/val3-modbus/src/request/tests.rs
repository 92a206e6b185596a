use expect_test::{Expect, expect};
use proptest::prelude::*;

use super::*;
use crate::image::tests::image;

fn send(image: &mut ModbusImage, request: &[u8]) -> Vec<u8> {
    let message = Message { transaction: 0x1234, unit: 255, request: request.to_vec() };
    let response = respond(&message, image).unwrap();
    let (header, body) = response.split_at(7);
    let length = u8::try_from(body.len() + 1).unwrap();
    assert_eq!(header, [0x12, 0x34, 0, 0, 0, length, 255], "the header of the request is repeated");
    body.to_vec()
}

fn check(requests: &[&[u8]], expected: Expect) {
    let mut image = image();
    let responses: Vec<String> = requests.iter().map(|request| format!("{:?}", send(&mut image, request))).collect();
    expected.assert_eq(&responses.join("\n"));
}

#[test]
fn bits_are_written_and_read() {
    check(
        &[&[15, 0, 0, 0, 5, 1, 0b1_0110], &[5, 0, 0, 0xFF, 0], &[5, 0, 1, 0, 0], &[1, 0, 0, 0, 16], &[2, 0, 2, 0, 3]],
        expect![[r#"
            [15, 0, 0, 0, 5]
            [5, 0, 0, 255, 0]
            [5, 0, 1, 0, 0]
            [1, 2, 21, 0]
            [2, 1, 5]"#]],
    );
}

#[test]
fn words_are_written_and_read_with_the_high_byte_first() {
    check(
        &[&[16, 0, 0, 0, 2, 4, 1, 2, 255, 255], &[6, 0, 2, 0, 7], &[3, 0, 0, 0, 3], &[4, 0, 2, 0, 1]],
        expect![[r#"
            [16, 0, 0, 0, 2]
            [6, 0, 2, 0, 7]
            [3, 6, 1, 2, 255, 255, 0, 7]
            [4, 2, 0, 7]"#]],
    );
}

#[test]
fn words_are_exchanged_in_one_request() {
    check(
        &[&[23, 0, 0, 0, 3, 0, 1, 0, 2, 4, 0, 5, 0, 6], &[22, 0, 1, 0xFF, 0xFD, 0, 0x0A], &[3, 0, 1, 0, 1]],
        expect![[r#"
            [23, 6, 0, 0, 0, 5, 0, 6]
            [22, 0, 1, 255, 253, 0, 10]
            [3, 2, 0, 7]"#]],
    );
}

/// Exceptions: 1 for a function, 2 for an address, 3 for a count or a value.
#[test]
fn other_requests_are_exceptions() {
    let exception = |request: &[u8]| {
        let mut image = image();
        let response = send(&mut image, request);
        assert_eq!((response.len(), response[0], image.take_writes()), (2, request[0] | 0x80, vec![]), "{request:?}");
        response[1]
    };
    for function in [0, 7, 8, 17, 24, 43, 100, 127] {
        assert_eq!(exception(&[function]), 1);
        assert_eq!(exception(&[function, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0]), 1);
    }
    for beyond in [
        &[1, 0, 16, 0, 1][..],
        &[2, 0xFF, 0xFF, 0, 1],
        &[3, 0, 7, 0, 2],
        &[5, 0, 16, 0, 0],
        &[6, 0, 8, 0, 0],
        &[15, 0, 15, 0, 2, 1, 3],
        &[16, 0, 7, 0, 2, 4, 0, 1, 0, 1],
        &[22, 0, 8, 0, 0, 0, 1],
        &[23, 0, 7, 0, 2, 0, 0, 0, 1, 2, 0, 9],
        &[23, 0, 0, 0, 2, 0, 7, 0, 2, 4, 0, 9, 0, 9],
    ] {
        assert_eq!(exception(beyond), 2, "{beyond:?}");
    }
    for wrong in [
        &[1, 0, 0, 0, 0][..],
        &[1, 0, 0, 0x07, 0xD1],
        &[3, 0, 0, 0, 126],
        &[3, 0, 0, 0],
        &[3, 0, 0, 0, 1, 0],
        &[5, 0, 0, 1, 0],
        &[6, 0, 0],
        &[15, 0, 0, 0x07, 0xD0, 1, 0],
        &[15, 0, 0, 0, 0, 0],
        &[15, 0, 0, 0, 9, 1, 0],
        &[16, 0, 0, 0x80, 0, 0],
        &[16, 0, 0, 0, 2, 4, 0],
        &[16, 0, 0, 0, 2, 3, 0, 0, 0],
        &[22, 0, 0, 0, 0, 0],
        &[23, 0, 0, 0, 1],
        &[23, 0, 0, 0, 126, 0, 0, 0, 1, 2, 0, 9],
        &[23, 0, 0, 0, 1, 0, 0, 0, 0, 0],
        &[23, 0, 0, 0, 1, 0, 0, 0, 2, 2, 0, 9],
    ] {
        assert_eq!(exception(wrong), 3, "{wrong:?}");
    }
}

proptest! {
    #[test]
    fn any_request_has_a_response(function in 0..0x80_u8, data in prop::collection::vec(any::<u8>(), 0..252)) {
        let request = [&[function], &data[..]].concat();
        let response = send(&mut image(), &request);
        prop_assert!(response[0] == function || response[0] == function | 0x80 && (1..=3).contains(&response[1]));
    }

    #[test]
    fn written_words_are_read(words in prop::collection::vec(any::<u16>(), 1..=4)) {
        let count = u8::try_from(words.len()).unwrap();
        let data: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        let mut image = image();
        send(&mut image, &[&[16, 0, 0, 0, count, 2 * count], &data[..]].concat());
        prop_assert_eq!(send(&mut image, &[3, 0, 0, 0, count]), [&[3, 2 * count], &data[..]].concat());
        let received: Vec<u16> = image.take_writes().into_iter().map(|write| write.value).collect();
        prop_assert_eq!(received, words);
    }
}
