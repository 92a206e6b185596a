//! Locations in a program at which a mistake can be seeded.

use std::ops::Range;

use val3_analysis::items::program::code;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, decode_entities, parse};

use super::site::{Escapes, Site, line_at};

use SyntaxKind::{
    AND_KW, ASSIGN_STMT, BIN_EXPR, BLOCK, CALL_STMT, CASE_CLAUSE, CDATA_OPEN, DO_STMT, ELSE_IF_CLAUSE, EQ2, EXPR_STMT,
    FALSE_KW, GE, GT, IF_STMT, LE, LITERAL, LT, MINUS, NEQ, NUMBER, OR_KW, PLUS, PREFIX_EXPR, SLASH, STAR, TRUE_KW,
    WHILE_STMT,
};

/// Replacements for operators and words.
const REPLACEMENTS: [(SyntaxKind, &str); 14] = [
    (EQ2, "!="),
    (NEQ, "=="),
    (LT, "<="),
    (LE, "<"),
    (GT, ">="),
    (GE, ">"),
    (PLUS, "-"),
    (MINUS, "+"),
    (STAR, "/"),
    (SLASH, "*"),
    (AND_KW, "or"),
    (OR_KW, "and"),
    (TRUE_KW, "false"),
    (FALSE_KW, "true"),
];

/// Largest number to which a program can add 1 exactly.
const LARGEST: f64 = 1e15;

/// Finds the mistakes that can be seeded into a program's code, in source order.
pub(super) fn code_sites(text: &str) -> Vec<Site> {
    let parse = parse(text);
    let Some(code) = code(parse.view()) else { return Vec::new() };
    let escapes = if parse.view().count(|kind| kind == CDATA_OPEN) == 0 { Escapes::Text } else { Escapes::None };
    let mut search = SiteCollector { text, escapes, found: Vec::new() };
    search.node(code);
    search.found
}

/// Search for mistakes in a text.
struct SiteCollector<'t> {
    text: &'t str,
    escapes: Escapes,
    found: Vec<Site>,
}

impl SiteCollector<'_> {
    fn node(&mut self, node: View<'_>) {
        match node.kind() {
            CALL_STMT | ASSIGN_STMT | EXPR_STMT => self.replace(solid(node), |_| String::new()),
            IF_STMT | ELSE_IF_CLAUSE | WHILE_STMT | DO_STMT => self.negate(node),
            _ => {}
        }
        let is_operator = node.kind() != PREFIX_EXPR;
        for child in node.children_with_tokens() {
            match (child.as_node(), child.as_token()) {
                (Some(child), _) => self.node(*child),
                (None, Some(token)) if is_operator => self.token(*token, node.kind()),
                _ => {}
            }
        }
    }

    /// Adds the negation of a condition, unless another mistake has the same effect.
    fn negate(&mut self, statement: View<'_>) {
        let mut children = statement.children();
        let Some(condition) = children.find(|node| !matches!(node.kind(), BLOCK | CASE_CLAUSE | ELSE_IF_CLAUSE)) else {
            return;
        };
        let is_equation =
            condition.kind() == BIN_EXPR && condition.tokens().any(|token| matches!(token.kind(), EQ2 | NEQ));
        if condition.kind() != LITERAL && !is_equation {
            self.replace(solid(condition), |found| format!("!({found})"));
        }
    }

    fn token(&mut self, token: TokenView<'_>, parent: SyntaxKind) {
        let range = usize::from(token.range().start())..usize::from(token.range().end());
        match REPLACEMENTS.iter().find(|(kind, _)| *kind == token.kind()) {
            Some((_, replacement)) => self.replace(Some(range), |_| (*replacement).to_owned()),
            None if token.kind() == NUMBER && parent == LITERAL => {
                let number: Option<f64> = token.text().parse().ok().filter(|number: &f64| number.abs() < LARGEST);
                if let Some(number) = number {
                    self.replace(Some(range), |_| (number + 1.0).to_string());
                }
            }
            None => {}
        }
    }

    fn replace(&mut self, range: Option<Range<usize>>, replacement: impl FnOnce(&str) -> String) {
        let Some((range, found)) = range.and_then(|range| Some((range.clone(), self.text.get(range)?))) else { return };
        let found = match self.escapes {
            Escapes::None => found.to_owned(),
            _ => decode_entities(found).into_owned(),
        };
        let replacement = replacement(&found);
        let line = line_at(self.text, range.start);
        self.found.push(Site { path: None, line, found, replacement, range, escapes: self.escapes });
    }
}

/// Range of a node without surrounding blanks and comments.
fn solid(node: View<'_>) -> Option<Range<usize>> {
    let mut parts = node.children_with_tokens().filter_map(|child| match (child.as_node(), child.as_token()) {
        (Some(node), _) => solid(*node),
        (None, Some(token)) if !token.kind().is_trivia() => {
            Some(usize::from(token.range().start())..usize::from(token.range().end()))
        }
        _ => None,
    });
    let first = parts.next()?;
    let end = parts.last().map_or(first.end, |last| last.end);
    Some(first.start..end)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    const PROGRAM: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="p" access="public">
    <Code><![CDATA[begin
  // a+1
  if l_n2<=3 and bOk==true
    call report("a+b")
    // 2
  elseIf !bOk
    n=-n*2.5
  endIf
  while n==1
    movej(jHere,tTool,mDesc)
  endWhile
  do
    n=n-1
  until n>0
end]]></Code>
  </Program>
</Programs>
"#;

    #[test]
    fn mistakes_are_seeded_into_code_alone() {
        assert_eq!(parse(PROGRAM).errors(), []);
        let shown = |site: &Site| format!("{}: {}\n", site.line, site.change());
        let found: String = code_sites(PROGRAM).iter().map(shown).collect();
        expect![[r#"
            6: `l_n2<=3 and bOk==true` becomes `!(l_n2<=3 and bOk==true)`
            6: `<=` becomes `<`
            6: `3` becomes `4`
            6: `and` becomes `or`
            6: `==` becomes `!=`
            6: `true` becomes `false`
            7: `call report("a+b")` is removed
            9: `!bOk` becomes `!(!bOk)`
            10: `n=-n*2.5` is removed
            10: `*` becomes `/`
            10: `2.5` becomes `3.5`
            12: `==` becomes `!=`
            12: `1` becomes `2`
            13: `movej(jHere,tTool,mDesc)` is removed
            17: `n>0` becomes `!(n>0)`
            16: `n=n-1` is removed
            16: `-` becomes `+`
            16: `1` becomes `2`
            17: `>` becomes `>=`
            17: `0` becomes `1`
        "#]]
        .assert_eq(&found);
    }

    #[test]
    fn a_mistake_changes_its_line_alone() {
        let escaped = PROGRAM.replace("<![CDATA[", "").replace("]]>", "").replace("n2<=3", "n2&lt;=3");
        let escaped = escaped.replace("n>0", "n&gt;0");
        for text in [PROGRAM, &escaped] {
            let found = code_sites(text);
            assert_eq!(found.len(), code_sites(PROGRAM).len());
            for site in found {
                let mutant = site.applied(text);
                assert!(parse(&mutant).errors().is_empty(), "{}", site.change());
                let changed: Vec<usize> = (1..)
                    .zip(text.lines().zip(mutant.lines()))
                    .filter(|(_, (a, b))| a != b)
                    .map(|(line, _)| line)
                    .collect();
                assert_eq!(changed, [site.line as usize], "{}", site.change());
                assert_eq!(text.lines().count(), mutant.lines().count());
            }
        }
    }

    #[test]
    fn files_without_code_get_no_mistakes() {
        assert_eq!(code_sites("no XML"), []);
    }
}
