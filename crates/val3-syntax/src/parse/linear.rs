//! The parsing time is linear, measured in token accesses instead of clock time.

use crate::grammar;
use crate::lexer::lex;
use crate::parser::{Input, Parser};

/// Texts for which a naive parser reads the same tokens repeatedly.
const SHAPES: &[(&str, &str, &str)] = &[
    ("begin\nx=", "(", "\nend"),
    ("begin\nx=", "f(a b, g[1 ", "\nend"),
    ("begin\nx=", "(a ]", ")\nend"),
    ("begin\nx=", "{(", ") ) ) ] } }\nend"),
    ("begin\nx=1", "+a*b-c", "\nend"),
    ("begin\nx=", "-", "1\nend"),
    ("begin\n", "x=", "1\nend"),
    ("begin\n", "if a\n", "\nend"),
    ("begin\n", "if a\nwhile b\nendIf\n", "\nend"),
    ("begin\n", "case 1\nelse\nbreak\n", "\nend"),
    ("begin\n", "  endFor\nend\n", "\nend"),
    ("", "begin\n", ""),
    ("", "x=1\n", "end"),
    ("begin\n", "a ", "\nend"),
];

/// Returns the number of token accesses while parsing `text`.
fn looks(text: &str) -> usize {
    let lexed = lex(text);
    let input = Input::new(text, &lexed);
    grammar::file(&mut Parser::new(&input, 0));
    input.looks.get()
}

#[test]
fn looks_grow_with_the_text() {
    for (head, unit, tail) in SHAPES {
        let of = |times: usize| looks(&format!("<Code><![CDATA[{head}{}{tail}]]></Code>", unit.repeat(times)));
        let (once, tenfold) = (of(1_000), of(10_000));
        assert!(tenfold <= 11 * once, "{unit:?}: {once} -> {tenfold}");
        // Some texts need far lookahead, but only a fixed number of times.
        assert!(tenfold < 100 * 10_000 * unit.len().max(4), "{unit:?}: {tenfold}");
    }
}

#[test]
fn looks_at_elements_grow_with_the_text() {
    for unit in ["<a>", "<a b='c' b='c'/>", "</a>", "<a ", "<a></b>", "<a><b></a>", "text &", "<![CDATA["] {
        let of = |times: usize| looks(&unit.repeat(times));
        let (once, tenfold) = (of(1_000), of(10_000));
        assert!(tenfold <= 11 * once, "{unit:?}: {once} -> {tenfold}");
    }
}
