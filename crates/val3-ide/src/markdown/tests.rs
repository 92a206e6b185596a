use proptest::prelude::*;
use pulldown_cmark::{Event, Options, Parser, Tag};

use super::*;

/// Rendered text, and all parts that are more than text.
fn rendered(markdown: &str) -> (String, Vec<String>) {
    // No typographic quotes, because editors do not use them in hovers.
    let options = Options::all() - Options::ENABLE_SMART_PUNCTUATION;
    let (mut text, mut others) = (String::new(), Vec::new());
    for event in Parser::new_ext(markdown, options) {
        match event {
            Event::Text(part) | Event::Code(part) => text.push_str(&part),
            Event::Start(Tag::Paragraph | Tag::CodeBlock(_)) | Event::End(_) => {}
            other => others.push(format!("{other:?}")),
        }
    }
    (text, others)
}

/// Text with Markdown and HTML markup.
fn hostile() -> impl Strategy<Value = String> {
    let pieces = [
        "![t](https://host/x.png)",
        "[a](command:x)",
        "<img src=x>",
        "<script>",
        "&lt;",
        "&#96;",
        "```",
        "``",
        "`",
        "~~~",
        "***",
        "__",
        "- ",
        "+ ",
        "1. ",
        "23) ",
        "# ",
        "> ",
        "| a | b |",
        "---",
        "===",
        "\n",
        "\n\n",
        "\r",
        "    ",
        "\t",
        "\\",
        "\\\n",
        "www.host.com",
        "https://host",
        "a@b.c",
        "<https://host>",
        "[x]: y",
        "[^1]",
        "$a$",
        "$(zap)",
        "~a~",
        "^b^",
        "{#id}",
        ":::",
        "- [ ] ",
        "a",
        "é",
        "x_n",
        " ",
        "!",
        "(",
        ")",
        "{",
        "}",
        ":",
        "+++",
        "[!NOTE]",
    ];
    prop::collection::vec(
        prop_oneof![4 => prop::sample::select(pieces.to_vec()).prop_map(str::to_owned), 1 => ".{0,4}"],
        0..12,
    )
    .prop_map(|parts| parts.concat())
}

/// Text as a single line.
fn in_words(text: &str) -> String {
    one_line(text).replace('\0', "\u{fffd}").trim().to_owned()
}

proptest! {
    #[test]
    fn plain_text_is_shown_to_the_letter(text in hostile()) {
        prop_assert_eq!(rendered(&plain(&text)), (in_words(&text), vec![]));
    }

    #[test]
    fn code_is_shown_to_the_letter(text in hostile()) {
        let (shown, others) = rendered(&format!("a {}", code(&text)));
        prop_assert_eq!(others, Vec::<String>::new());
        let expected = format!("a {}", one_line(&text));
        prop_assert_eq!(shown.trim_end(), expected.trim_end());
    }

    #[test]
    fn no_line_ends_a_block(text in hostile()) {
        let (shown, others) = rendered(&fenced(&text));
        prop_assert_eq!(others, Vec::<String>::new());
        let normal = |text: &str| text.replace("\r\n", "\n").replace('\r', "\n").replace('\0', "\u{fffd}");
        prop_assert_eq!(shown.replace('\0', "\u{fffd}"), normal(&text) + "\n");
    }
}

#[test]
fn ordinary_comments_have_no_marks() {
    for text in [
        "Closes the gripper, if it is open: see 10.3.",
        "Speed (0 to 100 %) - in mm/s; \"slow\" = 10",
        "arrêt à l'origine!",
    ] {
        assert_eq!(plain(text), text);
    }
    assert_eq!(code("nSpeed"), "`nSpeed`");
    assert_eq!(fenced("num nA"), "```val3\nnum nA\n```\n");
}

#[test]
fn marks_are_escaped() {
    assert_eq!(plain("![t](https://host/x.png)"), r"!\[t](https\://host/x.png)");
    assert_eq!(plain("- <value> of x_n * _2"), r"\- \<value> of x_n \* \_2");
    assert_eq!(plain("1. www.host.com"), r"1\. www\.host.com");
    assert_eq!(code("a`b"), "``a`b``");
    assert_eq!(fenced("```"), "````val3\n```\n````\n");
}
