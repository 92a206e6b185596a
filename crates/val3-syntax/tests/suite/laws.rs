//! Properties of parsing that hold for every text.

use proptest::prelude::*;
use proptest::sample::{Index, select};
use val3_syntax::{Parse, SyntaxKind, TextEdit, TextRange, TextSize, parse};

use crate::show::parsed;

/// Pieces of XML and code, complete and broken.
const PIECES: &[&str] = &[
    "<a>",
    "</a>",
    "<a b=\"c\"/>",
    "<Program name=\"p\">",
    "</Program>",
    "<Code>",
    "</Code>",
    "<Code><![CDATA[",
    "]]></Code>",
    "<![CDATA[",
    "]]>",
    "<!-- ",
    " -->",
    "<?x ",
    "?>",
    "<!DOCTYPE a>",
    "<",
    ">",
    "/>",
    "=",
    "\"",
    "'",
    "&lt;",
    "&gt;=",
    "&quot;",
    "&amp;",
    "&#10;",
    "&x;",
    "&",
    "begin\n",
    "\nend",
    "\n",
    "\r\n",
    "\r",
    "  ",
    "\t",
    "if ",
    "elseIf a\n",
    "else\n",
    "endIf\n",
    "while a\n",
    "endWhile\n",
    "do\n",
    "until a\n",
    "for i=0 to 9 step 1\n",
    "endFor\n",
    "switch n\n",
    "case 1, 2\n",
    "default\n",
    "break\n",
    "endSwitch\n",
    "call ",
    "return",
    "taskCreate ",
    "taskCreateSync ",
    "? ",
    "nA",
    "lib:p",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ".",
    ":",
    "==",
    "!=",
    "!",
    "-",
    "+",
    "*",
    "%",
    " and ",
    " or ",
    " xor ",
    "&&",
    "||",
    "<>",
    "not ",
    "then",
    "true",
    "1",
    ".5",
    "1e-3",
    "\"s\"",
    "\"",
    "// c",
    "<<<<<<< a\n",
    "=======\n",
    ">>>>>>> b\n",
    "\u{feff}",
    "é",
    "日",
    "\0",
    ";",
    "$x",
];

fn soup() -> impl Strategy<Value = String> {
    prop::collection::vec(select(PIECES), 0..60).prop_map(|pieces| pieces.concat())
}

fn expression() -> impl Strategy<Value = String> {
    let leaf = select(vec!["a", "b[0]", "c.d", "lib:e", "1", "-2.5", "\"s\"", "true", "f()"]).prop_map(str::to_owned);
    leaf.prop_recursive(3, 8, 3, |inner| {
        prop_oneof![
            (inner.clone(), select(vec!["+", "*", " and ", "==", "<", " or "]), inner.clone())
                .prop_map(|(a, op, b)| format!("{a}{op}{b}")),
            inner.clone().prop_map(|a| format!("({a})")),
            prop::collection::vec(inner, 0..3).prop_map(|all| format!("g({})", all.join(", "))),
        ]
    })
}

/// Generates well-formed lines of a body.
fn lines() -> impl Strategy<Value = String> {
    let simple = prop_oneof![
        expression().prop_map(|value| format!("x={value}\n")),
        expression().prop_map(|value| format!("movej({value}, t, m)\n")),
        Just("// comment <a> & \"\n".to_owned()),
        Just("call lib:p(1)\n".to_owned()),
        Just("\n".to_owned()),
    ];
    simple.prop_recursive(3, 24, 4, |inner| {
        let block = prop::collection::vec(inner, 0..4).prop_map(|lines| lines.concat());
        prop_oneof![
            (expression(), block.clone(), block.clone()).prop_map(|(a, x, y)| format!("if {a}\n{x}else\n{y}endIf\n")),
            (expression(), block.clone()).prop_map(|(a, x)| format!("while {a}\n{x}endWhile\n")),
            block.clone().prop_map(|x| format!("for i=0 to 9\n{x}endFor\n")),
            (block.clone(), block)
                .prop_map(|(x, y)| format!("switch n\ncase 1\n{x}break\ndefault\n{y}break\nendSwitch\n")),
        ]
    })
}

/// Generates a file of either dialect with one or several programs.
fn file() -> impl Strategy<Value = String> {
    let program = (lines(), any::<bool>(), select(vec!["", "\n  "])).prop_map(|(lines, escaped, gap)| {
        let code = format!("begin\n{lines}end");
        let code = if escaped {
            let text = code.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
            format!("<code>{text}</code>")
        } else {
            format!("<Code><![CDATA[{code}]]></Code>")
        };
        format!("{gap}<Program name=\"p\">{gap}<Locals><Local name=\"l\" /></Locals>{gap}{code}</Program>")
    });
    (prop::collection::vec(program, 1..3), any::<bool>()).prop_map(|(programs, bom)| {
        let mark = if bom { "\u{feff}" } else { "" };
        format!("{mark}<?xml version=\"1.0\"?>\n<Programs>{}</Programs>\n", programs.concat())
    })
}

/// Generates a replacement at a random position: a few characters or a piece.
fn edit() -> impl Strategy<Value = (Index, usize, String)> {
    let insert =
        prop_oneof![Just(String::new()), select(PIECES).prop_map(str::to_owned), lines(), "[a-z0-9=()<>&\"/\n ]{0,4}",];
    (any::<Index>(), prop_oneof![Just(0_usize), 1..4_usize, 0..80_usize], insert)
}

/// Applies the edits in turn. Complete and incremental parsing must yield the same tree.
fn check_edits(mut text: String, edits: Vec<(Index, usize, String)>) -> Result<(), TestCaseError> {
    let mut before = parse(&text);
    for (at, len, insert) in edits {
        let size = |offset: usize| TextSize::try_from(offset).unwrap();
        let start = at.index(text.len() + 1);
        let edit = TextEdit { range: TextRange::new(size(start), size(start + len)), text: insert };
        let new_text = edit.apply(&text);
        // The next tree shares nodes with a tree that has its rowan tree.
        before.green();
        let (again, build_green) = (before.reparse(&edit), parse(&new_text));
        prop_assert_eq!(again.errors(), build_green.errors(), "{:?}\n{:?}", &text, &edit);
        prop_assert!(again == build_green, "{:?}\n{:?}", &text, &edit);
        prop_assert!(again.green() == build_green.green(), "{:?}\n{:?}", &text, &edit);
        prop_assert!(before.reparse_as(new_text.as_str().into()) == build_green, "{:?}\n{:?}", &text, &edit);
        (text, before) = (new_text, again);
    }
    Ok(())
}

proptest! {
    #[test]
    fn any_text_is_kept(text in "(?s).{0,200}") {
        parsed(&text);
    }

    #[test]
    fn any_sequence_of_tokens_is_kept(text in soup()) {
        parsed(&text);
    }

    #[test]
    fn any_sequence_of_tokens_in_code_is_kept(code in soup(), escaped: bool) {
        parsed(&if escaped { format!("<code>begin\n{code}end</code>") } else { crate::show::body(&code) });
    }

    #[test]
    fn errors_are_in_order(text in soup()) {
        let parse = parse(&text);
        prop_assert!(parse.errors().is_sorted_by_key(|error| error.range.start()));
    }

    #[test]
    fn whole_files_have_no_faults(text in file()) {
        let parse = parsed(&text);
        prop_assert!(parse.errors().is_empty(), "{:?}", parse.errors());
    }

    #[test]
    fn reparsing_equals_parsing(text in file(), edits in prop::collection::vec(edit(), 1..5)) {
        check_edits(text, edits)?;
    }

    #[test]
    fn reparsing_broken_text_equals_parsing(text in soup(), edits in prop::collection::vec(edit(), 1..5)) {
        check_edits(format!("<a><Code><![CDATA[begin\n{text}\nend]]></Code></a>"), edits)?;
    }
}

#[test]
fn an_edit_of_a_body_keeps_the_rest_of_the_tree() {
    let text = crate::show::body("x=1");
    let before = parse(&text);
    let known = second_tag(&before);
    let at = TextSize::try_from(text.find("x=").unwrap()).unwrap();
    let edit = TextEdit { range: TextRange::empty(at), text: "y=".to_owned() };
    let after = before.reparse(&edit);
    assert_eq!(after, parse(&edit.apply(&text)));
    assert_eq!(second_tag(&after.reparse(&edit)), known);
}

/// Address of the second start tag's node. The first tag is small, so all trees share its node.
fn second_tag(parse: &Parse) -> usize {
    let mut tags = parse.root().descendants().filter(|node| node.kind() == SyntaxKind::START_TAG);
    std::ptr::from_ref(&*tags.nth(1).unwrap().green()).addr()
}

/// Whether `]]>` without a section is an error depends on the start of its own code, not on the code before.
#[test]
fn errors_of_a_code_do_not_depend_on_the_code_before() {
    let other = "<Code>\nend]]></Code></a>";
    for first in ["<", "]]><", "]]></Code><Code>"] {
        let text = format!("<a><Code><![CDATA[begin\n{first}\n]]></Code>{other}");
        let size = TextSize::of("<a><Code><![CDATA[begin\n");
        let edit = TextEdit { range: TextRange::at(size, TextSize::of(first)), text: String::new() };
        assert_eq!(parse(&text).reparse(&edit).errors(), parse(&edit.apply(&text)).errors(), "{first}");
    }
}

/// A section that an edit opens in escaped code ends in the next program.
#[test]
fn an_edit_can_open_a_section_that_ends_in_another_element() {
    let text = "<a><code>begin\nx=&quot;s&quot;\nend</code><Code><![CDATA[begin\nend]]></Code></a>";
    let at = TextSize::try_from(text.find("s&quot;").unwrap()).unwrap();
    for insert in ["<Code><![CDATA[", "<![CDATA[", "<!--", "<?"] {
        let edit = TextEdit { range: TextRange::empty(at), text: insert.to_owned() };
        let (again, whole) = (parse(text).reparse(&edit), parse(&edit.apply(text)));
        assert_eq!(again.errors(), whole.errors(), "{insert}");
        assert_eq!(again, whole, "{insert}");
    }
}

#[test]
fn no_edit_keeps_the_tree() {
    let text = crate::show::body("x=1");
    let before = parse(&text);
    let after = before.reparse_as(text.as_str().into());
    assert_eq!(after, before);
    assert!(std::ptr::eq(&**after.green(), &**before.green()));
}

#[test]
fn edits_outside_of_the_text_are_cut_to_it() {
    let edit = TextEdit { range: TextRange::new(2.into(), 900.into()), text: "!".to_owned() };
    assert_eq!(edit.apply("aé"), "a!");
}
