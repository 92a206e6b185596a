//! Properties of the formatter for all programs, complete or malformed.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use proptest::prelude::*;
use val3_fmt::{CodeStyle, format, format_range, on_type};
use val3_syntax::{SyntaxKind, TextEdit, TextRange, TextSize, parse};

/// A program in which `·` marks whitespace of any length.
fn statement(depth: u32) -> BoxedStrategy<Vec<String>> {
    let words = |lines: &'static [&'static str]| prop::sample::select(lines).prop_map(|line| vec![line.to_owned()]);
    let simple = words(&[
        "n·=·n·+·1",
        "put·(·\"a  b\"·)",
        "call p·(·n·,·-·1·)",
        "//  a comment  of its own",
        "?·n",
        "a·[·n·]·.·x·=·-·n·-·-·1",
        "t·=·{·1·,·,·{·2·}·}",
        "taskCreate \"t\"·,·10·,·p·(·)",
        "wait·(·(·a·)·and·(·b·)·or !·c·)",
        "return",
        "",
    ]);
    if depth == 0 {
        return simple.boxed();
    }
    let inner = || block(depth - 1);
    prop_oneof![
        4 => simple,
        1 => enclosed(inner(), "if a·==·\"x\"", "endIf"),
        1 => enclosed(inner(), "while n·<·1", "endWhile"),
        1 => enclosed(inner(), "for n·=·0 to 9 step 2", "endFor"),
        1 => enclosed(inner(), "do", "until n·>=·1"),
        1 => (inner(), inner()).prop_map(|(yes, no)| {
            [vec!["if a".to_owned()], yes, vec!["elseIf b".into(), "else".into()], no, vec!["endIf".into()]].concat()
        }),
        1 => (inner(), inner()).prop_map(|(one, other)| {
            let part = |head: &str, lines| [vec![head.to_owned()], lines, vec!["break".to_owned()]].concat();
            [vec!["switch n".into()], part("case 1·,·2", one), part("default", other), vec!["endSwitch".into()]].concat()
        }),
    ]
    .boxed()
}

/// The lines of a block between two lines.
fn enclosed(
    block: impl Strategy<Value = Vec<String>>,
    open: &'static str,
    close: &'static str,
) -> impl Strategy<Value = Vec<String>> {
    block.prop_map(move |lines| [vec![open.to_owned()], lines, vec![close.to_owned()]].concat())
}

fn block(depth: u32) -> impl Strategy<Value = Vec<String>> {
    prop::collection::vec(statement(depth), 0..4).prop_map(|statements| statements.concat())
}

fn program() -> impl Strategy<Value = Vec<String>> {
    block(3).prop_map(|lines| [vec!["begin".to_owned()], lines, vec!["end".to_owned()]].concat())
}

/// A spelling of a program.
#[derive(Debug, Clone)]
struct Writing {
    /// Widths of the whitespace at the marks and line starts, in order.
    blanks: Vec<u8>,
    line_end: &'static str,
    escaped: bool,
    capitals: bool,
}

fn writing() -> impl Strategy<Value = Writing> {
    let line_end = prop::sample::select(&["\n", "\r\n"][..]);
    (prop::collection::vec(0u8..3, 1..9), line_end, any::<bool>(), any::<bool>())
        .prop_map(|(blanks, line_end, escaped, capitals)| Writing { blanks, line_end, escaped, capitals })
}

impl Writing {
    fn write(&self, lines: &[String]) -> String {
        let mut blanks = self.blanks.iter().cycle();
        let mut code = String::new();
        for (index, line) in lines.iter().enumerate() {
            if index > 0 {
                code += self.line_end;
                code += &" ".repeat(usize::from(*blanks.next().unwrap()));
            }
            for part in line.split_inclusive('·') {
                code += &self.word(part.trim_end_matches('·'));
                if part.ends_with('·') {
                    code += &" ".repeat(usize::from(*blanks.next().unwrap()));
                }
            }
        }
        self.file(&code)
    }

    fn word(&self, part: &str) -> String {
        let keyword = ["begin", "end", "if", "endIf", "else", "until n", "default", "break", "do"].contains(&part);
        if self.capitals && keyword {
            part.to_uppercase().replace('N', "n").replace("BEGIn", "BEGIN")
        } else {
            part.to_owned()
        }
    }

    fn file(&self, code: &str) -> String {
        if self.escaped {
            let code = code.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
            return format!("<program><source><code>{code}</code></source></program>");
        }
        format!("<Programs><Program name=\"a\"><Code><![CDATA[{code}]]></Code></Program></Programs>")
    }
}

fn formatted(text: &str) -> String {
    TextEdit::apply_all(text, &format(text, &parse(text), &CodeStyle::default()))
}

/// Tokens without whitespace, in lower case; comments and strings are unchanged.
fn tokens(text: &str) -> Vec<String> {
    let root = parse(text).root();
    let tokens = root.descendants_with_tokens().filter_map(|element| element.into_token());
    let kept = tokens.filter(|token| !matches!(token.kind(), SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE));
    kept.map(|token| match token.kind().is_keyword() {
        true => token.text().to_lowercase(),
        false => token.text().to_owned(),
    })
    .collect()
}

/// Makes a random edit: removes a part of the code or inserts text.
fn broken(text: &str, at: usize, len: usize, inserted: &str) -> String {
    let mut start = at % text.len();
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = (start + len).min(text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    [&text[..start], inserted, &text[end..]].concat()
}

#[track_caller]
fn assert_laws(text: &str) {
    let once = formatted(text);
    assert_eq!(formatted(&once), once, "formatting twice is not formatting once:\n{text}");
    assert_eq!(tokens(&once), tokens(text), "another program:\n{text}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_layout_depends_on_the_program_alone(lines in program(), one in writing(), other in writing()) {
        // The indentation of a comment before the end of a block is significant, so comments are removed.
        let lines: Vec<String> = lines.into_iter().filter(|line| !line.starts_with("//")).collect();
        let other = Writing { line_end: one.line_end, escaped: one.escaped, ..other };
        prop_assert_eq!(formatted(&one.write(&lines)), formatted(&other.write(&lines)));
    }

    #[test]
    fn formatting_keeps_tokens_and_is_stable(lines in program(), writing in writing()) {
        assert_laws(&writing.write(&lines));
    }

    #[test]
    fn formatting_broken_programs_keeps_tokens(
        lines in program(),
        writing in writing(),
        at in any::<usize>(),
        len in 0usize..12,
        inserted in prop::sample::select(&["", "endIf\n", " if a\n", "\"", "//", "(", "]]>", "<", "=", "\n", "break\n", "é", "\r"][..]),
    ) {
        assert_laws(&broken(&writing.write(&lines), at, len, inserted));
    }

    #[test]
    fn a_range_is_formatted_like_the_file(lines in program(), writing in writing(), at in any::<usize>(), len in 0usize..60) {
        let text = writing.write(&lines);
        let all = format(&text, &parse(&text), &CodeStyle::default());
        let start = at % text.len();
        let range = TextRange::at(TextSize::try_from(start).unwrap(), TextSize::try_from(len.min(text.len() - start)).unwrap());
        let part = format_range(&text, &parse(&text), &CodeStyle::default(), range);
        prop_assert!(part.iter().all(|edit| all.contains(edit)));
        let whole = format_range(&text, &parse(&text), &CodeStyle::default(), TextRange::up_to(TextSize::of(&text)));
        prop_assert_eq!(whole, all);
    }

    #[test]
    fn typing_changes_no_token(lines in program(), writing in writing(), at in any::<usize>(), typed in prop::sample::select(&['\n', 'e', 'f'][..])) {
        let text = writing.write(&lines);
        let text = broken(&text, at, 0, &typed.to_string());
        let offset = TextSize::try_from(at % (text.len() - 1) + 1).unwrap();
        let edits = on_type(&text, &parse(&text), &CodeStyle::default(), offset, typed);
        let after = TextEdit::apply_all(&text, &edits);
        prop_assert_eq!(tokens(&after), tokens(&text));
    }
}
