//! Hostile texts, which must neither overflow the stack nor take more than linear time.

use val3_syntax::parse;

use crate::show::{body, line, parsed, program};

/// Stack size of a worker thread in bytes.
const STACK: usize = 2 << 20;

/// Parses, walks and drops a tree in a thread with a small stack. Returns the first errors.
fn survive(text: String) -> Vec<String> {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || {
        let parse = parsed(&text);
        assert_eq!(parse.root().descendants().count(), parse.clone().root().descendants().count());
        assert!(height(&parse.root()) < 1000);
        parse.errors().iter().take(5).map(|error| line(&text, error)).collect()
    });
    thread.unwrap().join().unwrap()
}

fn height(node: &val3_syntax::SyntaxNode) -> usize {
    1 + node.children().map(|child| height(&child)).max().unwrap_or(0)
}

#[track_caller]
fn is_too_deep(text: String) {
    let faults = survive(text);
    assert!(faults.len() == 1 && faults[0].contains("NestingTooDeep"), "{faults:#?}");
}

const MANY: usize = 10_000;

#[test]
fn nested_brackets() {
    for (open, close) in
        [("(", ")"), ("a[", "]"), ("{", "}"), ("f(", ")"), ("f(a[{(", ")}])"), ("a+(", ")"), ("(-", ")")]
    {
        is_too_deep(body(&format!("x={}1{}", open.repeat(MANY), close.repeat(MANY))));
        is_too_deep(body(&format!("x={}", open.repeat(MANY))));
        is_too_deep(body(&format!("x={}\ny=1", open.repeat(MANY))));
    }
}

#[test]
fn many_closing_brackets() {
    assert_eq!(survive(body(&format!("x={}", ")".repeat(MANY)))).len(), 1);
    assert_eq!(survive(body(&format!("x={}{}", "f(a b ".repeat(150), "g[1 ".repeat(MANY)))).len(), 1);
}

#[test]
fn signs_in_a_row() {
    assert_eq!(survive(body(&format!("x={}1", "-".repeat(MANY)))).len(), 1);
    assert_eq!(survive(body(&format!("x={}1", "!-".repeat(MANY)))).len(), 1);
}

#[test]
fn long_chains_are_parsed() {
    let many = 100_000;
    for link in ["+a", " and b", "*1", ".a", "[0]", "+a*b-c", "[0].b"] {
        is_too_deep(body(&format!("x=a{}", link.repeat(many))));
    }
    is_too_deep(body(&format!("{}1", "x=".repeat(many))));
    is_too_deep(body(&format!("x={}1", "(a+".repeat(150) + &"b+".repeat(many))));
}

#[test]
fn left_and_right_nesting_is_limited() {
    let links = format!("){}", "+a".repeat(150)).repeat(90);
    is_too_deep(body(&format!("x={}1{links}", "(".repeat(90))));
}

#[test]
fn nested_blocks() {
    for (open, close) in [
        ("if a\n", "endIf\n"),
        ("while a\n", "endWhile\n"),
        ("for i=0 to 1\n", "endFor\n"),
        ("do\n", "until a\n"),
        ("switch n\ncase 1\n", "break\nendSwitch\n"),
        ("if a\nelse\n", "endIf\n"),
    ] {
        is_too_deep(body(&format!("{}{}", open.repeat(MANY), close.repeat(MANY))));
        is_too_deep(body(&open.repeat(MANY)));
    }
}

#[test]
fn stray_keywords() {
    survive(body(&"else\n".repeat(MANY)));
    survive(body(&"case 1\n".repeat(MANY)));
    survive(body(&"endIf\nendWhile\nbreak\n".repeat(MANY)));
    survive(body(&"if a\nwhile b\nendIf\n".repeat(MANY)));
    survive(program(&"begin\n".repeat(MANY)));
    survive(program(&"end\n".repeat(MANY)));
}

#[test]
fn many_branches_are_not_deep() {
    let branches = "elseIf b\nx=1\n".repeat(MANY);
    assert!(survive(body(&format!("if a\n{branches}endIf"))).is_empty());
    let cases = "case 1\nx=1\nbreak\n".repeat(MANY);
    assert!(survive(body(&format!("switch a\n{cases}endSwitch"))).is_empty());
}

#[test]
fn nested_elements() {
    is_too_deep(format!("{}{}", "<a>".repeat(MANY), "</a>".repeat(MANY)));
    is_too_deep("<a>".repeat(MANY));
    assert_eq!(survive("</a>".repeat(MANY)).len(), 5);
    survive("<a ".repeat(MANY));
    survive("<a b=\"".repeat(MANY));
    survive(format!("<a {}/>", "b=\"\" ".repeat(MANY)));
}

#[test]
fn unterminated_parts_are_parsed() {
    for part in
        ["<!-- ", "<![CDATA[ ", "<? ", "<!DOCTYPE ", "<a b=\"", "<a b='", "</", "<", "&", "&lt", "<![CDATA[ </x "]
    {
        survive(part.repeat(MANY));
        survive(format!("<Code>{}", part.repeat(MANY)));
        survive(format!("<Code>begin\n{}end</Code>", part.repeat(MANY)));
    }
    survive(body(&"s=\"\n".repeat(MANY)));
    survive(program(&"\"".repeat(MANY)));
}

#[test]
fn zero_bytes_and_other_control_characters() {
    survive("\0".repeat(MANY));
    survive(body(&"\0".repeat(MANY)));
    survive(body("\u{1}\u{b}\u{c}\u{7f}\u{85}\u{a0}\u{2028}\u{feff}"));
    survive(format!("<Code>{}</Code>", "\0\r\n\0".repeat(MANY)));
}

#[test]
fn a_line_of_20_megabytes() {
    let text = body(&format!("s=\"{}\"", "x".repeat(20 << 20)));
    assert!(parse(&text).errors().is_empty());
    let text = body(&format!("// {}", "x ".repeat(10 << 20)));
    assert!(parse(&text).errors().is_empty());
    let text = body(&format!("f({})", "a,".repeat(1 << 20)));
    assert_eq!(parse(&text).errors().len(), 1);
    let text = body(&"f(".repeat(1 << 20));
    assert_eq!(parse(&text).errors().len(), 1);
}

#[test]
fn entities_are_never_expanded() {
    let bomb = "<!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;&b;&b;\">]>\n<a>&c;</a>";
    assert_eq!(survive(bomb.to_owned())[0], "0:1 \"<!\" Doctype\n");
}
