//! Typed views of nodes whose parts are needed outside of the analysis. `kind.rs` lists all nodes with their grammar.

use rowan::NodeOrToken;

use crate::kind::{SyntaxKind, SyntaxNode, SyntaxToken};

/// A typed view of a node.
pub trait AstNode: Sized {
    /// Returns the typed view of `syntax`, if its kind matches.
    fn cast(syntax: SyntaxNode) -> Option<Self>;
    /// Returns the untyped node.
    fn syntax(&self) -> &SyntaxNode;
}

macro_rules! nodes {
    ($($(#[doc = $doc:literal])* $name:ident = $($kind:ident)|+;)*) => {$(
        $(#[doc = $doc])*
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        pub struct $name(SyntaxNode);

        impl AstNode for $name {
            fn cast(syntax: SyntaxNode) -> Option<Self> {
                matches!(syntax.kind(), $(SyntaxKind::$kind)|+).then_some(Self(syntax))
            }
            fn syntax(&self) -> &SyntaxNode {
                &self.0
            }
        }
    )*};
}

nodes! {
    /// An element with its tags and content.
    Element = ELEMENT;
    /// A start tag.
    StartTag = START_TAG;
    /// An end tag.
    EndTag = END_TAG;
    /// The content of `<Code>`.
    Code = CODE;
    /// A sequence of statements.
    Block = BLOCK;
    /// A statement of any kind.
    Stmt = IF_STMT | WHILE_STMT | DO_STMT | FOR_STMT | SWITCH_STMT | RETURN_STMT | CALL_STMT | TASK_CREATE_STMT
        | PRINT_STMT | ASSIGN_STMT | EXPR_STMT;
    /// An `if` with all its branches.
    IfStmt = IF_STMT;
    /// One `elseIf` branch.
    ElseIfClause = ELSE_IF_CLAUSE;
    /// The `else` branch.
    ElseClause = ELSE_CLAUSE;
    /// A `switch` with all its cases.
    SwitchStmt = SWITCH_STMT;
    /// One `case` of a `switch`.
    CaseClause = CASE_CLAUSE;
    /// The `default` of a `switch`.
    DefaultClause = DEFAULT_CLAUSE;
    /// A `call`.
    CallStmt = CALL_STMT;
    /// An expression of any kind.
    Expr = LITERAL | NAME_REF | LIBRARY_PATH | PAREN_EXPR | PREFIX_EXPR | BIN_EXPR | ASSIGN_EXPR | INDEX_EXPR
        | FIELD_EXPR | CALL_EXPR | STRUCT_LITERAL;
    /// A number, a string, `true` or `false`.
    Literal = LITERAL;
}

impl Element {
    /// Returns the start tag.
    pub fn start_tag(&self) -> Option<StartTag> {
        child(&self.0)
    }
    /// Returns the end tag; `None` for `<name />`.
    pub fn end_tag(&self) -> Option<EndTag> {
        child(&self.0)
    }
}

impl StartTag {
    /// Returns the element name.
    pub fn name(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::XML_NAME)
    }
}

impl EndTag {
    /// Returns the element name.
    pub fn name(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::XML_NAME)
    }
}

impl Code {
    /// Returns the statements between `begin` and `end`.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl Block {
    /// Returns the statements, without nested ones.
    pub fn stmts(&self) -> impl Iterator<Item = Stmt> + use<> {
        children(&self.0)
    }
}

impl IfStmt {
    /// Returns the condition after `if`.
    pub fn condition(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Returns the statements after `if`.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// Returns the `elseIf` branches.
    pub fn else_if_clauses(&self) -> impl Iterator<Item = ElseIfClause> + use<> {
        children(&self.0)
    }
    /// Returns the `else` branch.
    pub fn else_clause(&self) -> Option<ElseClause> {
        child(&self.0)
    }
    /// Returns the keyword `endIf`.
    pub fn end_if(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::END_IF_KW)
    }
}

impl ElseIfClause {
    /// Returns the condition after `elseIf`.
    pub fn condition(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Returns the statements of the branch.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl ElseClause {
    /// Returns the statements of the branch.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl SwitchStmt {
    /// Returns the value that is compared with the cases.
    pub fn selector(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Returns the cases.
    pub fn case_clauses(&self) -> impl Iterator<Item = CaseClause> + use<> {
        children(&self.0)
    }
    /// Returns the `default` clauses; a correct `switch` has at most one.
    pub fn default_clauses(&self) -> impl Iterator<Item = DefaultClause> + use<> {
        children(&self.0)
    }
    /// Returns the statements after a `break`, which are accepted but never executed.
    pub fn stmts(&self) -> impl Iterator<Item = Stmt> + use<> {
        children(&self.0)
    }
    /// Returns the keyword `endSwitch`.
    pub fn end_switch(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::END_SWITCH_KW)
    }
}

impl CaseClause {
    /// Returns the values after `case`.
    pub fn values(&self) -> impl Iterator<Item = Expr> + use<> {
        children(&self.0)
    }
    /// Returns the statements of the clause.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// Returns the keyword `break`.
    pub fn break_keyword(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::BREAK_KW)
    }
}

impl DefaultClause {
    /// Returns the statements of the clause.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// Returns the keyword `break`.
    pub fn break_keyword(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::BREAK_KW)
    }
}

impl CallStmt {
    /// Returns the program with its arguments.
    pub fn call_expr(&self) -> Option<Expr> {
        child(&self.0)
    }
}

impl Expr {
    /// Returns the expression inside parentheses or after a prefix operator.
    pub fn inner(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Returns the left side, operator and right side of a complete binary expression.
    pub fn binary(&self) -> Option<(Expr, SyntaxKind, Expr)> {
        if self.0.kind() != SyntaxKind::BIN_EXPR {
            return None;
        }
        let mut sides = children::<Expr>(&self.0);
        let (left, right) = (sides.next()?, sides.next()?);
        let operator = tokens(&self.0).find(|token| !token.kind().is_trivia())?;
        Some((left, operator.kind(), right))
    }
}

/// Returns the first child of type `N`.
fn child<N: AstNode>(parent: &SyntaxNode) -> Option<N> {
    children(parent).next()
}

/// Returns the children of type `N`.
fn children<N: AstNode>(parent: &SyntaxNode) -> impl Iterator<Item = N> + use<N> {
    parent.children().filter_map(N::cast)
}

/// Returns the first token of `kind` directly below `parent`.
fn token(parent: &SyntaxNode, kind: SyntaxKind) -> Option<SyntaxToken> {
    tokens(parent).find(|token| token.kind() == kind)
}

fn tokens(parent: &SyntaxNode) -> impl Iterator<Item = SyntaxToken> + use<> {
    parent.children_with_tokens().filter_map(NodeOrToken::into_token)
}
