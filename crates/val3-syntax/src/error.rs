//! The faults that the parser reports. Their wording is part of the rules of `val3-check`.

use rowan::TextRange;

/// One fault of the text. The tree is complete nevertheless.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SyntaxError {
    /// The kind of the fault.
    pub kind: SyntaxErrorKind,
    /// Where a person would correct it.
    pub range: TextRange,
    /// The other side of the fault: the opening keyword, bracket or tag.
    pub related: Option<TextRange>,
}

/// The kinds of faults.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SyntaxErrorKind {
    // ---- XML ----
    /// The element `name`, whose start tag this is, has no end tag (related: where it belongs).
    UnclosedElement {
        /// Name of the element.
        name: String,
    },
    /// An end tag that closes nothing, or has another name than its start tag (related).
    UnmatchedEndTag {
        /// Name in the end tag.
        name: String,
    },
    /// A comment, CDATA section, processing instruction, tag or attribute value runs to the end of the file or tag
    /// (related: where it starts).
    Unterminated(XmlPart),
    /// An attribute without `=` or without a quoted value.
    MalformedAttribute {
        /// Name of the attribute.
        name: String,
    },
    /// The same attribute twice in one tag.
    DuplicateAttribute {
        /// Name of the attribute.
        name: String,
    },
    /// `&name;` that XML does not define, or a bare `&`.
    UnknownEntity {
        /// The text from `&` on.
        text: String,
    },
    /// A `<` that starts no tag, or text where only elements are allowed.
    UnexpectedText,
    /// `]]>` inside a line of code: it ends the section, and what follows is read as XML.
    EarlySectionEnd,
    /// No element at all, or more than one at the top.
    RootElement,
    /// A document type declaration; its entities are never expanded.
    Doctype,
    /// A line of a merge conflict (`<<<<<<<`, `=======`, `>>>>>>>`).
    ConflictMarker,
    /// Characters that no XML file may contain, from this one on.
    ControlCharacter {
        /// The first character.
        character: char,
    },
    // ---- code ----
    /// Something else was expected here.
    Expected {
        /// The expected part.
        expected: Expected,
        /// The text found; empty at the end of a line.
        found: String,
    },
    /// A character that no VAL 3 line contains.
    InvalidCharacter {
        /// The character.
        character: char,
    },
    /// `(`, `[` or `{` is not closed on its line (related: the bracket).
    UnclosedBracket {
        /// The closing bracket that is missing.
        missing: char,
    },
    /// `)`, `]` or `}` without its opening bracket.
    UnmatchedBracket {
        /// The closing bracket.
        bracket: char,
    },
    /// A string without its closing quote.
    UnterminatedString,
    /// A block whose end is missing (related: the keyword that opens it). The range is where the end belongs.
    UnclosedBlock {
        /// `if`, `while`, `for`, `do`, `switch`.
        block: &'static str,
        /// `endIf`, `endWhile`, `endFor`, `until`, `endSwitch`.
        missing: &'static str,
    },
    /// A block ends before another one inside it does, as in `while`, `if`, `endWhile`, `endIf` (related: the end that
    /// comes too late).
    CrossedBlocks {
        /// The inner block: `if`.
        inner: &'static str,
        /// The end that comes too early: `endWhile`.
        early: &'static str,
        /// The end of the inner block: `endIf`.
        late: &'static str,
    },
    /// `while` where the `until` of a `do` block belongs (related: the `do`).
    DoWhile,
    /// The end of a block that was never opened (`endIf`, `else`, `elseIf`, `until` …).
    UnmatchedBlockEnd {
        /// The keyword found, canonical spelling.
        found: &'static str,
        /// The keyword that would open the block.
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
    /// `=` inside an expression, where `==` is meant.
    AssignmentInExpression,
    /// `//` after code on the same line.
    CommentAfterCode,
    /// A keyword where a name belongs.
    ReservedWord {
        /// The keyword.
        word: String,
    },
    /// An operator or keyword of another language.
    ForeignSpelling {
        /// The word that was written (`&&`, `<>`, `then`, `not`).
        found: String,
        /// The VAL 3 spelling; empty if the word is to be removed.
        instead: &'static str,
    },
    /// Text after a complete instruction.
    TrailingText {
        /// The text found.
        found: String,
    },
    /// `return` with a value: programs yield none.
    ReturnValue,
    /// The code has no `begin`.
    MissingBegin,
    /// The code has no `end`.
    MissingEnd,
    /// The code has neither `begin` nor `end` (related: where `end` belongs).
    MissingBeginAndEnd,
    /// Code before `begin` or after `end`.
    CodeOutsideBody,
    /// No code at all.
    NoCode,
    /// Expressions, blocks or elements nest deeper than the limit, or an expression has too many operators in sequence.
    NestingTooDeep,
}

/// Parts of XML that have an end mark.
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

/// The parts that the parser can expect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expected {
    /// An expression.
    Expression,
    /// A name.
    Name,
    /// The name of a field after `.`.
    Field,
    /// The name of a program after `call`, or a library's item after `:`.
    Program,
    /// An instruction, assignment or control structure.
    Statement,
    /// `=` in `for`.
    ForAssign,
    /// `to` in `for`.
    ForTo,
    /// A value after `step`.
    ForStep,
    /// `(` of an argument list.
    OpenParen,
    /// `,` between parts.
    Comma,
    /// `=` of an assignment or `(` of a call after a name.
    AssignmentOrCall,
    /// A value after `case`.
    CaseValue,
}

impl SyntaxErrorKind {
    /// A block that is not closed or not opened. The indentation may show which.
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

    /// A fault of the code that does not affect the XML around it.
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

    /// A fault of a line that means nothing to other lines.
    pub(crate) fn is_local_to_line(&self) -> bool {
        self.is_local_to_code() && !self.is_about_blocks() && !matches!(self, Self::MissingBegin | Self::NoCode)
    }

    /// Which element holds which is not certain.
    pub fn breaks_structure(&self) -> bool {
        matches!(
            self,
            Self::UnclosedElement { .. } | Self::UnmatchedEndTag { .. } | Self::Unterminated(_) | Self::EarlySectionEnd
        )
    }

    /// Whether the fault makes its line unreadable. A block without its end does not affect the lines in it.
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
