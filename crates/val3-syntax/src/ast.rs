//! Typed views of the nodes whose parts are needed outside the analysis. `kind.rs` lists all nodes with their grammar.

use rowan::NodeOrToken;

use crate::kind::{SyntaxKind, SyntaxNode, SyntaxToken};

/// A typed view of a node.
pub trait AstNode: Sized {
    /// The typed view of `syntax`, if its kind fits.
    fn cast(syntax: SyntaxNode) -> Option<Self>;
    /// The node itself.
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
    /// Its start tag.
    pub fn start_tag(&self) -> Option<StartTag> {
        child(&self.0)
    }
    /// Its end tag; absent for `<name />`.
    pub fn end_tag(&self) -> Option<EndTag> {
        child(&self.0)
    }
}

impl StartTag {
    /// The name of the element.
    pub fn name(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::XML_NAME)
    }
}

impl EndTag {
    /// The name of the element.
    pub fn name(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::XML_NAME)
    }
}

impl Code {
    /// The statements between `begin` and `end`.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl Block {
    /// Its statements, without those nested in them.
    pub fn stmts(&self) -> impl Iterator<Item = Stmt> + use<> {
        children(&self.0)
    }
}

impl IfStmt {
    /// The condition of `if`.
    pub fn condition(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// The statements after `if`.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// The `elseIf` branches.
    pub fn else_if_clauses(&self) -> impl Iterator<Item = ElseIfClause> + use<> {
        children(&self.0)
    }
    /// The `else` branch.
    pub fn else_clause(&self) -> Option<ElseClause> {
        child(&self.0)
    }
    /// The keyword `endIf`.
    pub fn end_if(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::END_IF_KW)
    }
}

impl ElseIfClause {
    /// The condition of `elseIf`.
    pub fn condition(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Its statements.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl ElseClause {
    /// Its statements.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
}

impl SwitchStmt {
    /// The value that the cases are compared with.
    pub fn selector(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// The cases.
    pub fn case_clauses(&self) -> impl Iterator<Item = CaseClause> + use<> {
        children(&self.0)
    }
    /// The `default` clauses; a correct `switch` has at most one.
    pub fn default_clauses(&self) -> impl Iterator<Item = DefaultClause> + use<> {
        children(&self.0)
    }
    /// The statements after a `break`. They are accepted, but never executed.
    pub fn stmts(&self) -> impl Iterator<Item = Stmt> + use<> {
        children(&self.0)
    }
    /// The keyword `endSwitch`.
    pub fn end_switch(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::END_SWITCH_KW)
    }
}

impl CaseClause {
    /// The values after `case`.
    pub fn values(&self) -> impl Iterator<Item = Expr> + use<> {
        children(&self.0)
    }
    /// Its statements.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// The keyword `break`.
    pub fn break_keyword(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::BREAK_KW)
    }
}

impl DefaultClause {
    /// Its statements.
    pub fn block(&self) -> Option<Block> {
        child(&self.0)
    }
    /// The keyword `break`.
    pub fn break_keyword(&self) -> Option<SyntaxToken> {
        token(&self.0, SyntaxKind::BREAK_KW)
    }
}

impl CallStmt {
    /// The program with its arguments.
    pub fn call_expr(&self) -> Option<Expr> {
        child(&self.0)
    }
}

impl Expr {
    /// The expression inside parentheses or after a prefix operator.
    pub fn inner(&self) -> Option<Expr> {
        child(&self.0)
    }
    /// Left side, operator and right side of a complete binary expression.
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

/// The first child that is an `N`.
fn child<N: AstNode>(parent: &SyntaxNode) -> Option<N> {
    children(parent).next()
}

/// The children that are an `N`.
fn children<N: AstNode>(parent: &SyntaxNode) -> impl Iterator<Item = N> + use<N> {
    parent.children().filter_map(N::cast)
}

/// The first token of `kind` directly below `parent`.
fn token(parent: &SyntaxNode, kind: SyntaxKind) -> Option<SyntaxToken> {
    tokens(parent).find(|token| token.kind() == kind)
}

fn tokens(parent: &SyntaxNode) -> impl Iterator<Item = SyntaxToken> + use<> {
    parent.children_with_tokens().filter_map(NodeOrToken::into_token)
}
