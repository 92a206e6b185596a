use expect_test::{Expect, expect};

use super::*;

#[expect(clippy::needless_pass_by_value, reason = "expect![] is a value")]
fn check(page: &PageContent, expected: Expect) {
    let lines: Vec<String> = page.lines().map(|line| format!("|{line}\n")).collect();
    expected.assert_eq(lines.concat().trim_end_matches("|\n"));
}

fn position(column: usize, row: usize) -> CursorCell {
    CursorCell { column, row }
}

#[test]
fn put_leaves_the_cursor_after_the_text() {
    let mut page = PageContent::default();
    page.put("parts: ");
    page.put("12");
    assert_eq!(page.cursor(), position(9, 0));
    page.end_line();
    assert_eq!(page.put("next"), position(0, 1));
    check(
        &page,
        expect![[r#"
        |parts: 12
        |next
    "#]],
    );
}

#[test]
fn a_full_line_continues_in_the_next() {
    let mut page = PageContent::default();
    page.put(&"x".repeat(38));
    page.put("abcd");
    assert_eq!(page.cursor(), position(2, 1));
    check(
        &page,
        expect![[r#"
        |xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxab
        |cd
    "#]],
    );
}

#[test]
fn a_full_page_scrolls() {
    let mut page = PageContent::default();
    for line in 0..14 {
        page.put(&line.to_string());
        page.end_line();
    }
    assert_eq!(page.cursor(), position(0, 13));
    let lines: Vec<String> = page.lines().collect();
    assert_eq!((lines[0].as_str(), lines[12].as_str(), lines[13].as_str()), ("1", "13", ""));
}

#[test]
fn a_menu_fills_the_last_line_without_scrolling() {
    let mut page = PageContent::default();
    page.put("top");
    page.go_to(0.0, 13.0);
    page.put(&"m".repeat(40));
    let lines: Vec<String> = page.lines().collect();
    assert_eq!((lines[0].as_str(), lines[13].len()), ("top", 40));
    assert_eq!(page.put("z"), position(0, 13));
    let lines: Vec<String> = page.lines().collect();
    assert_eq!((lines[0].as_str(), lines[12].len(), lines[13].as_str()), ("", 40, "z"));
}

#[test]
fn a_line_of_40_columns_leaves_no_empty_line() {
    let mut page = PageContent::default();
    page.put(&"a".repeat(40));
    assert_eq!(page.cursor(), position(40, 0));
    page.end_line();
    assert_eq!(page.cursor(), position(0, 1));
}

#[test]
fn the_cursor_counts_modulo_the_page() {
    for (x, y, cursor) in [
        (39.0, 13.0, position(39, 13)),
        (40.0, 14.0, position(0, 0)),
        (85.0, 29.0, position(5, 1)),
        (-1.0, -1.0, position(39, 13)),
        (4.4, 4.5, position(4, 5)),
        (39.6, 0.0, position(0, 0)),
    ] {
        let mut page = PageContent::default();
        page.go_to(x, y);
        assert_eq!(page.cursor(), cursor, "{x} {y}");
    }
}

#[test]
fn cls_empties_the_page_and_keeps_the_title() {
    let mut page = PageContent::default();
    page.set_title("Palletiser");
    page.set_mode(TextMode::Inverse);
    page.put("text");
    page.clear();
    check(&page, expect![""]);
    assert_eq!((page.cursor(), page.title(), page.mode()), (position(0, 0), "Palletiser", TextMode::Inverse));
}

#[test]
fn a_title_leaves_the_cursor() {
    let mut page = PageContent::default();
    page.put("ab");
    page.set_title("title");
    assert_eq!(page.cursor(), position(2, 0));
    check(
        &page,
        expect![[r#"
        |ab
    "#]],
    );
}

#[test]
fn a_mode_applies_to_new_text_only() {
    let mut page = PageContent::default();
    page.put("a");
    page.set_mode(TextMode::InverseFlashing);
    page.put("b");
    let row: Vec<_> = page.cells().next().unwrap().iter().take(3).map(|cell| cell.mode).collect();
    assert_eq!(row, [TextMode::Standard, TextMode::InverseFlashing, TextMode::Standard]);
}

#[test]
fn a_wide_character_takes_two_columns() {
    let mut page = PageContent::default();
    page.put(&"x".repeat(39));
    page.put("中a");
    assert_eq!(page.cursor(), position(3, 1));
    page.go_to(1.0, 1.0);
    page.put("b");
    check(
        &page,
        expect![[r#"
        |xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
        | ba
    "#]],
    );
}

#[test]
fn writing_over_the_left_half_of_a_wide_character_blanks_the_right_one() {
    let mut page = PageContent::default();
    page.put("中文");
    page.go_to(1.0, 0.0);
    page.put("国");
    check(
        &page,
        expect![[r#"
        | 国
    "#]],
    );
    page.go_to(1.0, 0.0);
    page.put("b");
    page.go_to(3.0, 0.0);
    page.put("c");
    check(
        &page,
        expect![[r#"
        | b c
    "#]],
    );
}

#[test]
fn marks_join_their_letter_and_control_characters_are_blank() {
    let mut page = PageContent::default();
    page.put("e\u{301}\u{7}b");
    assert_eq!(page.cursor(), position(3, 0));
    assert_eq!(page.lines().next().unwrap(), "e\u{301} b");
}

#[test]
fn text_written_over_the_page_ends_with_it() {
    let mut page = PageContent::default();
    page.put("keep");
    page.write_over(position(38, 13), "abcd");
    assert_eq!(page.cursor(), position(4, 0));
    let lines: Vec<String> = page.lines().collect();
    assert_eq!((lines[0].as_str(), lines[13].trim_start()), ("keep", "ab"));
}

#[test]
fn text_after_a_cut_character_keeps_its_column() {
    let mut page = PageContent::default();
    page.put("中文z");
    page.go_to(2.0, 0.0);
    page.put("a");
    assert_eq!(page.lines().next().unwrap(), "中a z");
}
