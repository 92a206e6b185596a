//! Walks the keywords of a program for the rule on their spelling.

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::{parse, program};
use val3_syntax::SyntaxKind;
use val3_syntax::view::{TokenView, View};

use crate::diagnostic::{Diagnostic, Span};
use crate::rules::keyword_spelling;

/// Keywords that are not written in their usual letter case.
pub(crate) fn spelling(db: &dyn Db, project: Project, file: File) -> Vec<Diagnostic> {
    let parse = parse(db, file);
    let mut odd = Vec::new();
    collect(View::root(parse.green()), &mut odd);
    odd.into_iter().map(|(token, canonical)| finding(db, project, file, token, canonical)).collect()
}

fn collect<'g>(node: View<'g>, odd: &mut Vec<(TokenView<'g>, &'static str)>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(node) => collect(node, odd),
            NodeOrToken::Token(token) if token.kind().is_keyword() => {
                let canonical = token.kind().keyword_text().unwrap_or("");
                if token.text() != canonical {
                    odd.push((token, canonical));
                }
            }
            NodeOrToken::Token(_) => {}
        }
    }
}

fn finding(db: &dyn Db, project: Project, file: File, token: TokenView<'_>, canonical: &'static str) -> Diagnostic {
    debug_assert!(token.kind() != SyntaxKind::EOF);
    let wording = keyword_spelling::word(token.text(), canonical);
    Diagnostic {
        rule: &keyword_spelling::RULE,
        severity: keyword_spelling::RULE.severity,
        message: wording.message,
        place: Span { file, range: token.range() },
        label: wording.label,
        related: Vec::new(),
        help: wording.help,
        program: Some(program::header(db, file).name.to_string()),
        application: Some(project.manifest(db)),
        fixable: false,
    }
}
