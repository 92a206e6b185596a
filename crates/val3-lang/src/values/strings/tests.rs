use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

use super::*;
use crate::fault::Fault;

const NEGATIVE: Result<Text> = Err(Fault::INVALID_PARAMETER);

#[track_caller]
fn check(actual: Result<Text>, expected: &str) {
    assert_eq!(actual, Ok(Text::from(expected)));
}

fn full() -> String {
    "0123456789abcdef".repeat(8)
}

#[test]
fn chr_gives_a_character() {
    assert_eq!(chr(65.0).as_str(), "A");
    assert_eq!([0.0, 34.0, 127.0].map(|code| chr(code).to_string()), ["\0", "\"", "\x7f"]);
    assert_eq!(chr(26426.0).as_str(), "机");
    assert_eq!(chr(64.5).as_str(), "A");
}

#[test]
fn chr_gives_nothing_where_there_is_no_character() {
    assert_eq!(chr(55295.0).as_str(), "\u{d7ff}");
    assert_eq!(chr(57344.0).as_str(), "\u{e000}");
    assert_eq!(chr(1_114_111.0).as_str(), "\u{10ffff}");
    for code in [-1.0, 55296.0, 57343.0, 1_114_112.0, 4_294_967_361.0, 1e300, f64::NAN] {
        assert_eq!(chr(code).as_str(), "", "{code}");
    }
}

#[test]
fn asc_gives_a_code_point() {
    assert_eq!(asc("A", 0.0), 65.0);
    assert_eq!([asc("é机🤖", 0.0), asc("é机🤖", 1.0), asc("é机🤖", 2.0)], [233.0, 26426.0, 129_302.0]);
    assert_eq!([asc("ab", 0.5), asc("ab", -0.5)], [98.0, 97.0]);
}

#[test]
fn asc_gives_minus_1_where_there_is_no_character() {
    assert_eq!([asc("A", 1.0), asc("A", 2.0), asc("A", -1.0), asc("", 0.0), asc("A", 1e300)], [-1.0; 5]);
}

#[test]
fn left_takes_the_first() {
    check(left("hello world", 5.0), "hello");
    check(left("hello world", 20.0), "hello world");
    check(left("hello world", 11.0), "hello world");
    check(left("hello world", 10.0), "hello worl");
    check(left("hello world", 0.0), "");
    check(left("hello world", -0.5), "");
    check(left("机器人", 2.0), "机器");
    check(left("", 1e300), "");
    assert_eq!(left("hello world", -1.0), NEGATIVE);
}

#[test]
fn right_takes_the_last() {
    check(right("hello world", 5.0), "world");
    check(right("hello world", 20.0), "hello world");
    check(right("hello world", 11.0), "hello world");
    check(right("hello world", 10.0), "ello world");
    check(right("hello world", 0.0), "");
    check(right("机器人", 2.0), "器人");
    assert_eq!(right("hello world", -1.0), NEGATIVE);
}

#[test]
fn mid_takes_from_the_middle() {
    check(mid("hello wild world", 4.0, 6.0), "wild");
    check(mid("hello wild world", 20.0, 6.0), "wild world");
    check(mid("hello", 1.0, 4.0), "o");
    check(mid("hello", 1.0, 5.0), "");
    check(mid("hello", 1.0, 6.0), "");
    check(mid("hello", 0.0, 1.0), "");
    check(mid("hello", 1e300, 1e300), "");
    check(mid("机器人", 1.0, 1.0), "器");
    check(mid("hello", 1.6, 0.6), "el");
    assert_eq!(mid("hello", -1.0, 0.0), NEGATIVE);
    assert_eq!(mid("hello", 1.0, -1.0), NEGATIVE);
}

#[test]
fn insert_puts_text_before_a_character() {
    check(insert("hello world", "wild", 6.0), "hello wildworld");
    check(insert("hello world", "wild ", 6.0), "hello wild world");
    check(insert("hello", "X", 0.0), "Xhello");
    check(insert("hello", "X", 5.0), "helloX");
    check(insert("hello", "X", 6.0), "helloX");
    check(insert("机器", "X", 1.0), "机X器");
    assert_eq!(insert("hello", "X", -1.0), NEGATIVE);
}

#[test]
fn insert_cuts_the_end() {
    let full = full();
    check(insert(&full[..127], "X", 0.0), &format!("X{}", &full[..127]));
    check(insert(&full, "X", 0.0), &format!("X{}", &full[..127]));
    check(insert(&full, "X", 128.0), &full);
    check(insert(&format!("{}机", &full[..125]), "X", 0.0), &format!("X{}", &full[..125]));
}

#[test]
fn delete_takes_characters_out() {
    check(delete("hello wild world", 5.0, 6.0), "hello world");
    check(delete("hello", 20.0, 2.0), "he");
    check(delete("hello", 1.0, 4.0), "hell");
    check(delete("hello", 1.0, 5.0), "hello");
    check(delete("hello", 1.0, 6.0), "hello");
    check(delete("hello", 0.0, 2.0), "hello");
    check(delete("机器人", 1.0, 1.0), "机人");
    assert_eq!(delete("hello", -1.0, 0.0), NEGATIVE);
    assert_eq!(delete("hello", 1.0, -1.0), NEGATIVE);
    assert_eq!(delete("hello", -1.0, 9.0), NEGATIVE);
}

#[test]
fn replace_puts_text_in_the_place_of_characters() {
    check(replace("hello ? world", "wild", 1.0, 6.0), "hello wild world");
    check(replace("hello", "", 2.0, 1.0), "hlo");
    check(replace("hello", "J", 20.0, 0.0), "J");
    check(replace("hello", "X", 0.0, 2.0), "heXllo");
    check(replace("机器人", "X", 1.0, 1.0), "机X人");
    assert_eq!(replace("hello", "X", -1.0, 0.0), NEGATIVE);
    assert_eq!(replace("hello", "X", 1.0, -1.0), NEGATIVE);
}

#[test]
fn replace_beyond_the_end_changes_nothing() {
    check(replace("hello", "X", 1.0, 4.0), "hellX");
    check(replace("hello", "X", 1.0, 5.0), "helloX");
    check(replace("hello", "X", 1.0, 6.0), "hello");
}

#[test]
fn replace_cuts_the_end() {
    let full = full();
    check(replace(&full, "XY", 2.0, 0.0), &format!("XY{}", &full[2..]));
    check(replace(&full, "XYZ", 2.0, 0.0), &format!("XYZ{}", &full[2..127]));
}

#[test]
fn find_gives_the_first_place() {
    assert_eq!(find("hello wild world", "wild"), 6.0);
    assert_eq!(find("hello", "l"), 2.0);
    assert_eq!(find("hello", "x"), -1.0);
    assert_eq!(find("hello", "Hello"), -1.0);
    assert_eq!(find("hello", "hello "), -1.0);
    assert_eq!(find("机器人", "人"), 2.0);
    assert_eq!([find("hello", ""), find("", ""), find("", "x")], [0.0, 0.0, -1.0]);
    assert_eq!(find(&format!("{}x", &full()[..127]), "x"), 127.0);
}

#[test]
fn len_counts_characters() {
    assert_eq!(len("hello wild world"), 16);
    assert_eq!([len(""), len("机器人"), len("é🤖"), len(&full())], [0, 3, 2, 128]);
}

#[test]
fn wide_characters_take_two_columns() {
    assert_eq!(display_len("hello wild world"), 16);
    assert_eq!([display_len(""), display_len("机器人"), display_len("aé机"), display_len("ＡＢ")], [0, 6, 4, 4]);
    assert_eq!(display_len("e\u{301}"), 1);
    assert_eq!(['a', '机', '\u{301}', '\0', '\u{7f}'].map(columns), [1, 2, 0, 1, 1]);
}

proptest! {
    #[test]
    fn left_and_right_make_the_whole(text in "\\PC{0,60}", at in 0..70_usize) {
        let text = Text::from(text.as_str());
        let rest = len(&text).saturating_sub(at);
        prop_assert_eq!(left(&text, at as f64).unwrap() + &right(&text, rest as f64).unwrap(), text);
    }

    #[test]
    fn an_inserted_text_can_be_deleted(text in "\\PC{0,15}", insertion in "\\PC{0,15}", at in 0..15_usize) {
        let longer = insert(&text, &insertion, at as f64).unwrap();
        let at = at.min(len(&text)) as f64;
        let size = len(&insertion) as f64;
        check(mid(&longer, size, at), &insertion);
        check(delete(&longer, size, at), &text);
        check(replace(&longer, "", size, at), &text);
    }

    #[test]
    fn a_found_text_is_at_its_position(text in "[ab]{0,12}", wanted in "[ab]{0,3}") {
        let place = find(&text, &wanted);
        prop_assert_eq!(place >= 0.0, text.contains(&wanted));
        prop_assert!(place < 0.0 || mid(&text, len(&wanted) as f64, place).unwrap().as_str() == wanted);
    }

    #[test]
    fn chr_and_asc_are_inverse(character in any::<char>()) {
        let code = asc(character.encode_utf8(&mut [0; 4]), 0.0);
        prop_assert_eq!(chr(code).chars().next(), Some(character));
    }

    #[test]
    fn ascii_takes_a_column_a_character(text in "[\\x00-\\x7f]{0,40}") {
        prop_assert_eq!(display_len(&text), len(&text));
    }
}
