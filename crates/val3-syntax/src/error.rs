//! Syntax errors. The rules of `val3-check` create their messages.

use rowan::TextRange;

/// A syntax error. The tree is complete nevertheless.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SyntaxError {
    /// Kind of the error.
    pub kind: SyntaxErrorKind,
    /// Range where a person would correct the text.
    pub range: TextRange,
    /// Related range: the opening keyword, bracket or tag.
    pub related: Option<TextRange>,
}

/// Kind of syntax error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SyntaxErrorKind {
    // ---- XML ----
    /// The element `name`, whose start tag this is, has no end tag (related: the place for the end tag).
    UnclosedElement {
        /// Name of the element.
        name: String,
    },
    /// An end tag that closes no element, or whose name differs from its start tag (related).
    UnmatchedEndTag {
        /// Name in the end tag.
        name: String,
    },
    /// A comment, CDATA section, processing instruction, tag or attribute value without an end (related: its start).
    Unterminated(XmlPart),
    /// An attribute without `=` or without a quoted value.
    MalformedAttribute {
        /// Name of the attribute.
        name: String,
    },
    /// A repeated attribute in a tag.
    DuplicateAttribute {
        /// Name of the attribute.
        name: String,
    },
    /// An undefined entity reference `&name;`, or a bare `&`.
    UnknownEntity {
        /// Text from `&` on.
        text: String,
    },
    /// A `<` that begins no tag, or text where only elements are allowed.
    UnexpectedText,
    /// `]]>` inside a line of code, which ends the section, so that the following code is parsed as XML.
    EarlySectionEnd,
    /// No root element, or several.
    RootElement,
    /// A document type declaration; its entities are never expanded.
    Doctype,
    /// A line of a merge conflict (`<<<<<<<`, `=======`, `>>>>>>>`).
    ConflictMarker,
    /// Characters that are invalid in XML files, from this one on.
    ControlCharacter {
        /// The first character.
        character: char,
    },
    // ---- code ----
    /// Another token was expected here.
    Expected {
        /// Expected part.
        expected: Expected,
        /// Actual text; empty at the end of a line.
        found: String,
    },
    /// A character that is invalid in VAL 3 code.
    InvalidCharacter {
        /// The character.
        character: char,
    },
    /// A `(`, `[` or `{` that is not closed on its line (related: the bracket).
    UnclosedBracket {
        /// Missing closing bracket.
        missing: char,
    },
    /// `)`, `]` or `}` without its opening bracket.
    UnmatchedBracket {
        /// The closing bracket.
        bracket: char,
    },
    /// A string without its closing quote.
    UnterminatedString,
    /// A number beyond the range of `num`, such as `1e400`.
    NumberTooLarge,
    /// A block without its end (related: the opening keyword). The range is the place for the end.
    UnclosedBlock {
        /// `if`, `while`, `for`, `do`, `switch`.
        block: &'static str,
        /// `endIf`, `endWhile`, `endFor`, `until`, `endSwitch`.
        missing: &'static str,
    },
    /// An outer block that ends before an inner block, as in `while`, `if`, `endWhile`, `endIf` (related: the late
    /// end).
    CrossedBlocks {
        /// Inner block, for example `if`.
        inner: &'static str,
        /// End of the outer block, which is too early, for example `endWhile`.
        early: &'static str,
        /// End of the inner block, for example `endIf`.
        late: &'static str,
    },
    /// `while` instead of `until` at the end of a `do` block (related: the `do`).
    DoWhile,
    /// The end of a block without a beginning (`endIf`, `else`, `elseIf`, `until` …).
    UnmatchedBlockEnd {
        /// Keyword in its canonical spelling.
        found: &'static str,
        /// Keyword that would open the block.
        opener: &'static str,
    },
    /// A `case` or `default` without its closing `break` (related: the `case`).
    MissingBreak,
    /// `break` outside `switch`.
    BreakOutsideSwitch,
    /// `case` or `default` outside `switch`.
    CaseOutsideSwitch,
    /// `case` after `default` (related: the `default`).
    CaseAfterDefault,
    /// A second `default` (related: the first).
    SecondDefault,
    /// A statement between `switch` and its first `case`.
    StatementBeforeCase,
    /// `else` or `elseIf` after `else` (related: the first `else`).
    ElseAfterElse,
    /// Two unary operators in a row.
    DoubleUnary,
    /// `=` inside an expression, instead of `==`.
    AssignmentInExpression,
    /// `//` after code on the same line.
    CommentAfterCode,
    /// A keyword instead of a name.
    ReservedWord {
        /// The keyword.
        word: String,
    },
    /// A foreign operator or keyword.
    ForeignSpelling {
        /// Foreign spelling, for example `&&`, `<>`, `then` or `not`.
        found: String,
        /// VAL 3 spelling; empty if the word must be removed.
        instead: &'static str,
    },
    /// Text after a complete instruction.
    TrailingText {
        /// Text.
        found: String,
    },
    /// `return` with a value, which programs do not have.
    ReturnValue,
    /// The code has no `begin`.
    MissingBegin,
    /// The code has no `end`.
    MissingEnd,
    /// The code has neither `begin` nor `end` (related: the place for `end`).
    MissingBeginAndEnd,
    /// Code before `begin` or after `end`.
    CodeOutsideBody,
    /// The code is empty.
    NoCode,
    /// Expressions, blocks or elements exceed the nesting limit, or an expression has too many operators in sequence.
    NestingTooDeep,
}

/// Parts of XML with an end mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum XmlPart {
    /// `<!-- … -->`
    Comment,
    /// `<![CDATA[ … ]]>`
    CData,
    /// `<? … ?>`
    ProcessingInstruction,
    /// `<name … >`
    Tag,
    /// `"…"` or `'…'`
    AttributeValue,
}

/// Parts that the parser may expect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expected {
    /// An expression.
    Expression,
    /// A name.
    Name,
    /// A field name after `.`.
    Field,
    /// A program name after `call`, or a library item after `:`.
    Program,
    /// An instruction, assignment or control structure.
    Statement,
    /// `=` in `for`.
    ForAssign,
    /// `to` in `for`.
    ForTo,
    /// A value after `step`.
    ForStep,
    /// `(` before arguments.
    OpenParen,
    /// `,` between parts.
    Comma,
    /// `=` or `(` after a name, for an assignment or a call.
    AssignmentOrCall,
    /// A value after `case`.
    CaseValue,
}

impl SyntaxErrorKind {
    /// Whether the error is a block without beginning or end, which the indentation may help to locate.
    pub fn is_about_blocks(&self) -> bool {
        matches!(
            self,
            Self::UnclosedBlock { .. }
                | Self::CrossedBlocks { .. }
                | Self::UnmatchedBlockEnd { .. }
                | Self::MissingBreak
                | Self::BreakOutsideSwitch
                | Self::CaseOutsideSwitch
                | Self::StatementBeforeCase
                | Self::MissingEnd
                | Self::CodeOutsideBody
        )
    }

    /// Whether the error is in code and does not affect the surrounding XML.
    pub(crate) fn is_local_to_code(&self) -> bool {
        !matches!(
            self,
            Self::UnclosedElement { .. }
                | Self::UnmatchedEndTag { .. }
                | Self::Unterminated(_)
                | Self::MalformedAttribute { .. }
                | Self::DuplicateAttribute { .. }
                | Self::UnknownEntity { .. }
                | Self::UnexpectedText
                | Self::EarlySectionEnd
                | Self::RootElement
                | Self::Doctype
                | Self::ConflictMarker
                | Self::ControlCharacter { .. }
                | Self::NestingTooDeep
        )
    }

    /// Whether the error is in a line of code and does not affect other lines.
    pub(crate) fn is_local_to_line(&self) -> bool {
        self.is_local_to_code() && !self.is_about_blocks() && !matches!(self, Self::MissingBegin | Self::NoCode)
    }

    /// Whether the nesting of elements is uncertain because of the error.
    pub fn breaks_structure(&self) -> bool {
        matches!(
            self,
            Self::UnclosedElement { .. } | Self::UnmatchedEndTag { .. } | Self::Unterminated(_) | Self::EarlySectionEnd
        )
    }

    /// Whether the line is unreadable because of the error. A block without an end does not affect the lines in it.
    pub fn breaks_line(&self) -> bool {
        !matches!(
            self,
            Self::UnclosedBlock { .. }
                | Self::CrossedBlocks { .. }
                | Self::MissingBreak
                | Self::MissingEnd
                | Self::MissingBegin
                | Self::MissingBeginAndEnd
                | Self::CommentAfterCode
                | Self::ElseAfterElse
                | Self::CaseAfterDefault
                | Self::SecondDefault
        )
    }
}
