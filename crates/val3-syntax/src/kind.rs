//! Kinds of tokens and nodes in the tree.

mod keyword;
mod language;

pub use keyword::KEYWORDS;
pub use language::{SyntaxElement, SyntaxNode, SyntaxToken, Val3};

macro_rules! syntax_kinds {
    ($($(#[doc = $doc:literal])* $kind:ident,)*) => {
        /// Kind of a token or node.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u16)]
        #[allow(non_camel_case_types, reason = "the spelling of rowan trees everywhere")]
        pub enum SyntaxKind {
            $($(#[doc = $doc])* $kind,)*
        }

        const ALL: &[SyntaxKind] = &[$(SyntaxKind::$kind,)*];
    };
}

syntax_kinds! {
    // ---- trivia: tokens that the grammar ignores ----
    /// Blanks and tabs; in XML also line ends.
    WHITESPACE,
    /// A line end in code, with the blank lines and the indentation that follow.
    NEWLINE,
    /// U+FEFF at the start of the file.
    BYTE_ORDER_MARK,
    /// A line of a merge conflict.
    CONFLICT_MARKER,
    /// `// …`
    COMMENT,
    /// `<!-- … -->`
    XML_COMMENT,
    /// `<? … ?>`
    XML_INSTRUCTION,
    /// `<!DOCTYPE … >`
    XML_DOCTYPE,
    /// `<![CDATA[`
    CDATA_OPEN,
    /// `]]>`
    CDATA_CLOSE,

    // ---- XML tokens ----
    /// A token that is neither valid XML nor valid code.
    ERROR_TOKEN,
    /// `<` of a tag.
    L_ANGLE,
    /// `</`
    L_ANGLE_SLASH,
    /// `>` of a tag.
    R_ANGLE,
    /// `/>`
    SLASH_R_ANGLE,
    /// A name with its prefix (`xsi:type`).
    XML_NAME,
    /// `=` between an attribute's name and value.
    XML_EQ,
    /// An attribute's value with its quotes.
    XML_STRING,
    /// Character data.
    XML_TEXT,
    /// `&…;` in character data.
    ENTITY_REF,

    // ---- code tokens ----
    /// A name; add-on instructions start with `$`.
    IDENT,
    /// `12`, `.5`, `1e-3`
    NUMBER,
    /// `"…"`, or `&quot;…&quot;` in escaped code.
    STRING,
    /// `(`
    L_PAREN,
    /// `)`
    R_PAREN,
    /// `[`
    L_BRACK,
    /// `]`
    R_BRACK,
    /// `{`
    L_CURLY,
    /// `}`
    R_CURLY,
    /// `,`
    COMMA,
    /// `.`
    DOT,
    /// `:`
    COLON,
    /// `?`
    QUESTION,
    /// `=`
    EQ,
    /// `==`
    EQ2,
    /// `!=`
    NEQ,
    /// `!`
    BANG,
    /// `<`, or `&lt;` in escaped code.
    LT,
    /// `<=`
    LE,
    /// `>`, or `&gt;` in escaped code.
    GT,
    /// `>=`
    GE,
    /// `+`
    PLUS,
    /// `-`
    MINUS,
    /// `*`
    STAR,
    /// `/`
    SLASH,
    /// `%`
    PERCENT,

    // ---- keywords ----
    /// `begin`
    BEGIN_KW,
    /// `end`
    END_KW,
    /// `call`
    CALL_KW,
    /// `return`
    RETURN_KW,
    /// `if`
    IF_KW,
    /// `elseIf`
    ELSE_IF_KW,
    /// `else`
    ELSE_KW,
    /// `endIf`
    END_IF_KW,
    /// `while`
    WHILE_KW,
    /// `endWhile`
    END_WHILE_KW,
    /// `do`
    DO_KW,
    /// `until`
    UNTIL_KW,
    /// `for`
    FOR_KW,
    /// `to`
    TO_KW,
    /// `step`
    STEP_KW,
    /// `endFor`
    END_FOR_KW,
    /// `switch`
    SWITCH_KW,
    /// `case`
    CASE_KW,
    /// `break`
    BREAK_KW,
    /// `default`
    DEFAULT_KW,
    /// `endSwitch`
    END_SWITCH_KW,
    /// `and`
    AND_KW,
    /// `or`
    OR_KW,
    /// `xor`
    XOR_KW,
    /// `true`
    TRUE_KW,
    /// `false`
    FALSE_KW,
    /// `taskCreate`
    TASK_CREATE_KW,
    /// `taskCreateSync`
    TASK_CREATE_SYNC_KW,

    /// End of the token list; never in a tree.
    EOF,

    // ---- nodes: `?` marks an optional part, `*` a repeated part ----
    // ---- XML nodes ----
    /// The root: a whole file. `Element*`
    XML_FILE,
    /// An element with its tags and content. `StartTag Element* Code? EndTag?`
    ELEMENT,
    /// `<name attributes>` or `<name attributes />`
    START_TAG,
    /// `</name>`
    END_TAG,
    /// `name="value"`
    ATTRIBUTE,
    /// The content of `<Code>`: `begin Block end`.
    CODE,

    // ---- code nodes ----
    /// A sequence of statements. `Stmt*`
    BLOCK,
    /// `if Expr Block ElseIfClause* ElseClause? endIf`
    IF_STMT,
    /// `elseIf Expr Block`
    ELSE_IF_CLAUSE,
    /// `else Block`
    ELSE_CLAUSE,
    /// `while Expr Block endWhile`
    WHILE_STMT,
    /// `do Block until Expr`
    DO_STMT,
    /// `for Expr = Expr to Expr (step Expr)? Block endFor`
    FOR_STMT,
    /// `switch Expr (CaseClause | DefaultClause | Stmt)* endSwitch`; a statement after a `break` is never executed.
    SWITCH_STMT,
    /// `case Expr (, Expr)* Block break`
    CASE_CLAUSE,
    /// `default Block break`
    DEFAULT_CLAUSE,
    /// `return`
    RETURN_STMT,
    /// `call CallExpr`
    CALL_STMT,
    /// `taskCreate Expr (, Expr)*`, also `taskCreateSync`.
    TASK_CREATE_STMT,
    /// `? Expr`
    PRINT_STMT,
    /// `Expr = Expr`; the right side may be an `AssignExpr`: `a = b = c`.
    ASSIGN_STMT,
    /// An expression as a statement.
    EXPR_STMT,
    /// A number, string, `true` or `false`.
    LITERAL,
    /// A name.
    NAME_REF,
    /// `library:item`
    LIBRARY_PATH,
    /// `( … )`
    PAREN_EXPR,
    /// `-x`, `!x`
    PREFIX_EXPR,
    /// `a + b`
    BIN_EXPR,
    /// `a = b` as the right side of a chained assignment, or by mistake inside an expression.
    ASSIGN_EXPR,
    /// `a[i, j]`
    INDEX_EXPR,
    /// `a.field`
    FIELD_EXPR,
    /// `Expr ArgList`
    CALL_EXPR,
    /// `(a, b)`
    ARG_LIST,
    /// `{a, b, , c}`
    STRUCT_LITERAL,
    /// Tokens that match no rule of the grammar.
    ERROR,
}

impl SyntaxKind {
    /// Returns the kind with this raw number in the green tree.
    pub fn from_raw(raw: rowan::SyntaxKind) -> Self {
        ALL.get(usize::from(raw.0)).copied().unwrap_or(Self::ERROR_TOKEN)
    }

    /// Whether it is the kind of a node; all other kinds are tokens.
    pub fn is_node(self) -> bool {
        self > Self::EOF
    }

    /// Whether it is a kind of trivia: blanks, line ends, comments and marks around code, which the grammar ignores.
    pub fn is_trivia(self) -> bool {
        self <= Self::CDATA_CLOSE
    }
}

impl From<SyntaxKind> for rowan::SyntaxKind {
    fn from(kind: SyntaxKind) -> Self {
        Self(kind as u16)
    }
}
