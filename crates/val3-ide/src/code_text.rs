//! Program code without the surrounding XML.

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_analysis::items::program::code_element;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, decode_entities};

/// Code of the program in a file: the CDATA contents, or its text with entities decoded. `None` if the file has no code
/// element.
pub fn code_text(db: &dyn Db, file: File) -> Option<String> {
    let parse = parse(db, file);
    let element = code_element(parse.view())?;
    let mut tokens = Vec::new();
    collect(element.view(), &mut tokens);
    let has_sections = tokens.iter().any(|token| token.kind() == SyntaxKind::CDATA_OPEN);
    let (mut text, mut is_inside) = (String::new(), false);
    for token in tokens {
        match token.kind() {
            SyntaxKind::CDATA_OPEN => is_inside = true,
            SyntaxKind::CDATA_CLOSE => is_inside = false,
            SyntaxKind::XML_COMMENT => {}
            _ if is_inside => text.push_str(token.text()),
            _ if has_sections => {}
            _ => text.push_str(&decode_entities(token.text())),
        }
    }
    Some(text)
}

/// Collects the tokens of the element, except its tags.
fn collect<'g>(node: View<'g>, tokens: &mut Vec<TokenView<'g>>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(tag) if matches!(tag.kind(), SyntaxKind::START_TAG | SyntaxKind::END_TAG) => {}
            NodeOrToken::Node(child) => collect(child, tokens),
            NodeOrToken::Token(token) => tokens.push(token),
        }
    }
}

#[cfg(test)]
mod tests {
    use val3_analysis::db::Sources;

    use super::*;
    use crate::testing::MarkedListing;

    fn code_of(program: &str) -> Option<String> {
        let marked = MarkedListing::new(&format!("$0\n=== main/start.pgx\n{program}"));
        let db = marked.db();
        let mut files = Sources::get(db).files(db).values();
        code_text(db, *files.find(|file| file.path(db).ends_with("main/start.pgx")).unwrap())
    }

    #[test]
    fn code_is_what_sections_hold() {
        let program = |code: &str| format!("<Programs><Program name=\"start\">{code}</Program></Programs>");
        let shown = |code: &str| code_of(&program(code)).unwrap_or("nothing".to_owned());
        assert_eq!(
            shown("<Code><![CDATA[begin\n  if a<b and c\n  endIf\nend]]></Code>"),
            "begin\n  if a<b and c\n  endIf\nend"
        );
        // Whitespace around a section is not code, and `]]>` in the code requires two sections.
        let split = "<Code>\n  <![CDATA[begin\n  put(\"]]]]><![CDATA[>\")\nend]]>\n</Code>";
        assert_eq!(shown(split), "begin\n  put(\"]]>\")\nend");
        assert_eq!(shown("<Locals />"), "nothing");
    }

    #[test]
    fn entities_are_replaced_outside_of_sections() {
        let code = "begin\n  if n&lt;1 &amp; s!=&quot;a&quot;<!-- not code -->\nend\n      ";
        let program = format!(
            "<programList><program name=\"start\"><source><code>{code}</code></source></program></programList>"
        );
        assert_eq!(code_of(&program).unwrap(), "begin\n  if n<1 & s!=\"a\"\nend\n      ");
    }
}
