use proptest::prelude::*;

use super::*;

const TEXT: &str = "aé€😀b\r\nx\n";
const UNITS: [ColumnUnit; 3] = [ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::Utf32];

fn shown(unit: ColumnUnit) -> ColumnCounting {
    ColumnCounting { unit, count_mark: false }
}

fn at(line: u32, column: u32) -> LineColumn {
    LineColumn { line, column }
}

fn columns(unit: ColumnUnit) -> Vec<(u32, u32)> {
    let index = LineIndex::new(TEXT);
    let positions = TEXT.char_indices().map(|(offset, _)| index.line_column(offset, shown(unit)));
    positions.map(|at| (at.line, at.column)).collect()
}

#[test]
fn columns_count_units() {
    let end = |columns: [u32; 4]| columns.map(|column| (0, column));
    assert_eq!(columns(ColumnUnit::Utf8)[..4], end([0, 1, 3, 6]));
    assert_eq!(columns(ColumnUnit::Utf8)[4..], [(0, 10), (0, 11), (0, 12), (1, 0), (1, 1)]);
    assert_eq!(columns(ColumnUnit::Utf16)[..4], end([0, 1, 2, 3]));
    assert_eq!(columns(ColumnUnit::Utf16)[4..], [(0, 5), (0, 6), (0, 7), (1, 0), (1, 1)]);
    assert_eq!(columns(ColumnUnit::Utf32)[4..], [(0, 4), (0, 5), (0, 6), (1, 0), (1, 1)]);
}

#[test]
fn half_of_a_surrogate_pair_is_the_start_of_its_character() {
    let index = LineIndex::new(TEXT);
    let start = TEXT.find('😀').unwrap();
    assert_eq!(index.offset(at(0, 4), shown(ColumnUnit::Utf16)), start);
    assert_eq!(index.offset(at(0, 5), shown(ColumnUnit::Utf16)), start + 4);
    assert_eq!(index.offset(at(0, 8), shown(ColumnUnit::Utf8)), start);
}

#[test]
fn positions_after_the_end() {
    let index = LineIndex::new(TEXT);
    for unit in UNITS {
        assert_eq!(index.offset(at(0, 99), shown(unit)), TEXT.find('\r').unwrap());
        assert_eq!(index.offset(at(0, u32::MAX), shown(unit)), TEXT.find('\r').unwrap());
        assert_eq!(index.offset(at(2, 5), shown(unit)), TEXT.len());
        assert_eq!(index.offset(at(9, 0), shown(unit)), TEXT.len());
        assert_eq!(index.line_column(999, shown(unit)), at(2, 0));
        assert_eq!(index.line_column(usize::MAX, shown(unit)), at(2, 0));
    }
}

#[test]
fn lines_have_no_line_end() {
    let index = LineIndex::new("ab\r\n\r\r\ncd\r");
    assert_eq!(index.line_range(0), Some(0..2));
    assert_eq!(index.line_range(1), Some(4..4));
    assert_eq!(index.line_range(2), Some(7..9));
    assert_eq!(index.line_range(3), None);
}

#[test]
fn a_carriage_return_alone_ends_no_line() {
    let index = LineIndex::new("ab\rcd\ne");
    assert_eq!(index.line_column(4, shown(ColumnUnit::Utf16)), at(0, 4));
    assert_eq!(index.line_range(0), Some(0..5));
    assert_eq!(index.line(6), 1);
}

#[test]
fn a_carriage_return_ends_a_line_of_the_protocol() {
    let index = LineIndex::for_protocol("ab\rcd\r\n\re\r\r\nf\r");
    let lines: Vec<_> = (0..8).map_while(|line| index.line_range(line)).collect();
    assert_eq!(lines, [0..2, 3..5, 7..7, 8..9, 10..10, 12..13, 14..14]);
    assert_eq!(index.line_column(4, shown(ColumnUnit::Utf16)), at(1, 1));
    assert_eq!(range_between("ab\rcd\r\ne", at(1, 0), at(2, 1), ColumnUnit::Utf16), 3..8);
}

#[test]
fn an_empty_text_has_one_line() {
    let index = LineIndex::new("");
    assert_eq!(index.line_column(0, shown(ColumnUnit::Utf8)), at(0, 0));
    assert_eq!(index.line_range(0), Some(0..0));
    assert_eq!(index.line_range(1), None);
}

#[test]
fn editors_do_not_show_the_byte_order_mark() {
    let index = LineIndex::new("\u{feff}<a>\n<b>");
    for unit in UNITS {
        assert_eq!(index.line_column(0, shown(unit)), at(0, 0));
        assert_eq!(index.line_column(3, shown(unit)), at(0, 0));
        assert_eq!(index.line_column(8, shown(unit)), at(1, 1));
        assert_eq!(index.offset(at(0, 1), shown(unit)), 4);
    }
    let counted = |unit| index.line_column(3, ColumnCounting { unit, count_mark: true }).column;
    assert_eq!(UNITS.map(counted), [3, 1, 1]);
    assert_eq!(index.characters(4), 2);
}

#[test]
fn ranges_of_a_text_without_an_index() {
    let range = |one, other| range_between("a\r\n😀b\nc", one, other, ColumnUnit::Utf16);
    assert_eq!(range(at(1, 2), at(1, 3)), 7..8);
    assert_eq!(range(at(2, 0), at(0, 9)), 1..9, "in any order");
    assert_eq!(range(at(7, 0), at(9, 9)), 10..10, "after the end");
    assert_eq!(range(at(0, 0), at(u32::MAX, 0)), 0..10);
}

proptest! {
    #[test]
    fn a_position_leads_back(
        text in "[a\r\né€😀\u{feff}]{0,30}",
        unit in 0_usize..3,
        count_mark: bool,
        of_protocol: bool,
    ) {
        let columns = ColumnCounting { unit: UNITS[unit], count_mark };
        let index = if of_protocol { LineIndex::for_protocol(&text) } else { LineIndex::new(&text) };
        for (offset, _) in text.char_indices() {
            let position = index.line_column(offset, columns);
            let line = index.line_range(position.line as usize).unwrap();
            let hidden = !count_mark && offset == 0 && text.starts_with('\u{feff}');
            if !hidden && offset <= line.end {
                prop_assert_eq!(index.offset(position, columns), offset);
            }
        }
    }

    #[test]
    fn a_line_is_found_with_and_without_an_index(
        text in "[a\r\né😀]{0,30}",
        one in (0_u32..5, 0_u32..9),
        other in (0_u32..5, 0_u32..9),
        unit in 0_usize..3,
    ) {
        let columns = ColumnCounting { unit: UNITS[unit], count_mark: true };
        let index = LineIndex::for_protocol(&text);
        let (one, other) = (at(one.0, one.1), at(other.0, other.1));
        let mut ends = [one, other].map(|position| index.offset(position, columns));
        ends.sort_unstable();
        prop_assert_eq!(range_between(&text, one, other, columns.unit), ends[0]..ends[1]);
        prop_assert!(ends.iter().all(|end| text.is_char_boundary(*end)));
    }
}
