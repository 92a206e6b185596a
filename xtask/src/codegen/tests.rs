use expect_test::{Expect, expect};

use super::grammar::Source;
use super::model::Model;
use super::{first_difference, generate};

/// The accessors that a grammar gives, with their bodies.
fn check_accessors(grammar: &str, expected: &Expect) {
    let source = generate(grammar).unwrap();
    let lines = source.lines().skip_while(|line| !line.starts_with("impl "));
    let wanted = |line: &&str| {
        let line = line.trim_start();
        line.starts_with("pub fn ") || line.starts_with("support::")
    };
    let found: Vec<_> = lines.filter(wanted).map(str::trim).collect();
    expected.assert_eq(&(found.join("\n") + "\n"));
}

fn check_refusal(grammar: &str, expected: &Expect) {
    let source = Source::parse(grammar);
    let error = source.and_then(|source| Model::of(&source)).unwrap_err();
    expected.assert_eq(&error.to_string());
}

#[test]
fn children_and_tokens() {
    check_accessors(
        "IfStmt = 'if' condition:Expr Block ElseIfClause* 'endIf'\nExpr = '#number'\nBlock = 'begin'\nElseIfClause = 'elseIf'",
        &expect![[r#"
            pub fn if_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::IF_KW)
            pub fn condition(&self) -> Option<Expr> {
            support::child(&self.syntax)
            pub fn block(&self) -> Option<Block> {
            support::child(&self.syntax)
            pub fn else_if_clauses(&self) -> AstChildren<ElseIfClause> {
            support::children(&self.syntax)
            pub fn end_if_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::END_IF_KW)
            pub fn number_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::NUMBER)
            pub fn begin_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::BEGIN_KW)
            pub fn else_if_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::ELSE_IF_KW)
        "#]],
    );
}

#[test]
fn siblings_of_one_kind_are_told_apart_by_tokens() {
    check_accessors(
        "Bin = lhs:Expr op:('+' | '-') rhs:Expr\nIndex = base:Expr '[' indexes:(Expr (',' Expr)*) ']'\n\
         Field = base:Expr '.' field:Name\nExpr = Bin | Name\nName = '#ident'",
        &expect![[r#"
            pub fn lhs(&self) -> Option<Expr> {
            support::child_between(&self.syntax, &[], &[SyntaxKind::PLUS, SyntaxKind::MINUS])
            pub fn op_token(&self) -> Option<SyntaxToken> {
            support::token_of(&self.syntax, &[SyntaxKind::PLUS, SyntaxKind::MINUS])
            pub fn rhs(&self) -> Option<Expr> {
            support::child_between(&self.syntax, &[SyntaxKind::PLUS, SyntaxKind::MINUS], &[])
            pub fn base(&self) -> Option<Expr> {
            support::child_between(&self.syntax, &[], &[SyntaxKind::L_BRACK])
            pub fn l_brack_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::L_BRACK)
            pub fn indexes(&self) -> AstChildren<Expr> {
            support::children_between(&self.syntax, &[SyntaxKind::L_BRACK], &[SyntaxKind::R_BRACK])
            pub fn r_brack_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::R_BRACK)
            pub fn base(&self) -> Option<Expr> {
            support::child_between(&self.syntax, &[], &[SyntaxKind::DOT])
            pub fn dot_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::DOT)
            pub fn field(&self) -> Option<Name> {
            support::child_between(&self.syntax, &[SyntaxKind::DOT], &[])
            pub fn ident_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::IDENT)
        "#]],
    );
}

#[test]
fn lists_are_many() {
    check_accessors(
        "ArgList = '(' (Expr (',' Expr)*)? ')'\nLiteral = '{' Expr? (',' Expr?)* '}'\nExpr = '#number' | 'true'",
        &expect![[r#"
            pub fn l_paren_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::L_PAREN)
            pub fn exprs(&self) -> AstChildren<Expr> {
            support::children(&self.syntax)
            pub fn r_paren_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::R_PAREN)
            pub fn number_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::NUMBER)
            pub fn true_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::TRUE_KW)
            pub fn l_curly_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::L_CURLY)
            pub fn exprs(&self) -> AstChildren<Expr> {
            support::children(&self.syntax)
            pub fn r_curly_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::R_CURLY)
        "#]],
    );
}

#[test]
fn angles_are_other_tokens_in_xml() {
    check_accessors(
        "StartTag = '<' '#xml_name' ('>' | '/>')\nLess = '<'",
        &expect![[r#"
            pub fn l_angle_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::L_ANGLE)
            pub fn xml_name_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::XML_NAME)
            pub fn r_angle_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::R_ANGLE)
            pub fn slash_r_angle_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::SLASH_R_ANGLE)
            pub fn lt_token(&self) -> Option<SyntaxToken> {
            support::token(&self.syntax, SyntaxKind::LT)
        "#]],
    );
}

#[test]
fn a_choice_of_rules_is_an_enum() {
    let source = generate("// Any value.\nExpr =\n  Name\n| Sum\nName = '#ident'\nSum = '+'").unwrap();
    let start = source.find("/// Any value.").unwrap();
    expect![[r#"
        /// Any value.
        ///
        /// ```ungrammar
        /// Expr =
        ///   Name
        /// | Sum
        /// ```
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        pub enum Expr {
            /// [`Name`]
            Name(Name),
            /// [`Sum`]
            Sum(Sum),
        }

        impl AstNode for Expr {
            fn can_cast(kind: SyntaxKind) -> bool {
                matches!(kind, SyntaxKind::NAME | SyntaxKind::SUM)
            }
            fn cast(syntax: SyntaxNode) -> Option<Self> {
                match syntax.kind() {
                    SyntaxKind::NAME => Name::cast(syntax).map(Self::Name),
                    SyntaxKind::SUM => Sum::cast(syntax).map(Self::Sum),
                    _ => None,
                }
            }
            fn syntax(&self) -> &SyntaxNode {
                match self {
                    Self::Name(it) => it.syntax(),
                    Self::Sum(it) => it.syntax(),
                }
            }
        }

        impl From<Name> for Expr {
            fn from(node: Name) -> Self {
                Self::Name(node)
            }
        }

        impl From<Sum> for Expr {
            fn from(node: Sum) -> Self {
                Self::Sum(node)
            }
        }
    "#]]
    .assert_eq(&source[start..]);
}

#[test]
fn faults_of_the_grammar() {
    check_refusal(
        "Pair = left:Name right:Name\nName = '#ident'",
        &expect!["rule Pair: two parts of the same kind need a token between them"],
    );
    check_refusal("At = '@'", &expect!["codegen/tokens.rs has no kind for the token '@'"]);
}

#[test]
fn the_first_difference() {
    assert_eq!(first_difference("a\nb\n", "a\nb\n"), None);
    assert_eq!(first_difference("a\nb\n", "a\nc\n"), Some(1));
    assert_eq!(first_difference("a\n", "a\nb\n"), Some(1));
}
