//! Open blocks at the cursor, determined only from keywords. A line with a syntax error, or a missing end further
//! below, therefore has no effect on the lines above.

use rowan::NodeOrToken;
use val3_analysis::items::program;
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::TextSize;
use val3_syntax::view::View;

/// An open block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Block {
    /// `if` and `elseIf`
    If,
    /// `else`
    Else,
    /// `while`
    While,
    /// `do`
    Do,
    /// `for`
    For,
    /// `switch`
    Switch,
    /// `case` and `default`
    Case,
}

impl Block {
    /// Keyword that closes the block.
    pub(crate) fn closing(self) -> &'static str {
        match self {
            Self::If | Self::Else => "endIf",
            Self::While => "endWhile",
            Self::Do => "until",
            Self::For => "endFor",
            Self::Switch => "endSwitch",
            Self::Case => "break",
        }
    }

    fn opened_by(keyword: SyntaxKind) -> Option<Self> {
        Some(match keyword {
            IF_KW => Self::If,
            WHILE_KW => Self::While,
            DO_KW => Self::Do,
            FOR_KW => Self::For,
            SWITCH_KW => Self::Switch,
            CASE_KW | DEFAULT_KW => Self::Case,
            _ => return None,
        })
    }
}

/// Open blocks before `offset`, from the outermost to the innermost.
pub(crate) fn open_blocks(root: View<'_>, offset: TextSize) -> Vec<Block> {
    let mut scan = Scan { offset, line_starts: true, open: Vec::new() };
    scan.walk(root);
    scan.open
}

/// Part of a program's code that contains a position, determined only from the keywords `begin` and `end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CodePart {
    /// Before the first word of a program without `begin`.
    Empty {
        /// Whether `end` exists after the position.
        has_end: bool,
    },
    /// Among the statements of a program with `end`, or with code after the position.
    Statements,
    /// After the last statement of a program without `end`.
    Unended,
}

/// Part of the code that contains the word starting at `offset`.
pub(crate) fn code_part(root: View<'_>, offset: TextSize) -> CodePart {
    let mut words = Words { offset, ..Words::default() };
    let code = program::code(root);
    code.iter().for_each(|code| words.walk(*code));
    let Words { before, after, has_other_after, .. } = words;
    if !before.has_any && !after.has_begin {
        CodePart::Empty { has_end: after.has_end }
    } else if before.has_begin && !before.has_end && !has_other_after {
        CodePart::Unended
    } else {
        CodePart::Statements
    }
}

/// Words of a program's code before and after a position.
#[derive(Default)]
struct Words {
    offset: TextSize,
    before: WordKinds,
    after: WordKinds,
    /// Whether another word starts after the position.
    has_other_after: bool,
}

#[derive(Default)]
struct WordKinds {
    has_any: bool,
    has_begin: bool,
    has_end: bool,
}

impl Words {
    fn walk(&mut self, node: View<'_>) {
        for child in node.children_with_tokens() {
            match child {
                NodeOrToken::Node(child) => self.walk(child),
                NodeOrToken::Token(token) => self.token(token.kind(), token.range().start()),
            }
        }
    }

    fn token(&mut self, kind: SyntaxKind, start: TextSize) {
        if kind.is_trivia() || kind == NEWLINE {
            return;
        }
        let kinds = if start < self.offset { &mut self.before } else { &mut self.after };
        kinds.has_any = true;
        kinds.has_begin |= kind == BEGIN_KW;
        kinds.has_end |= kind == END_KW;
        self.has_other_after |= start > self.offset || start == self.offset && kind == END_KW;
    }
}

struct Scan {
    offset: TextSize,
    /// Whether no token of the line has been read yet.
    line_starts: bool,
    open: Vec<Block>,
}

impl Scan {
    fn walk(&mut self, node: View<'_>) {
        for child in node.children_with_tokens() {
            match child {
                NodeOrToken::Node(child) if child.range().start() < self.offset => self.walk(child),
                NodeOrToken::Token(token) if token.range().end() < self.offset => self.token(token.kind()),
                _ => return,
            }
        }
    }

    fn token(&mut self, kind: SyntaxKind) {
        if kind == NEWLINE || kind == BEGIN_KW {
            self.line_starts = true;
        } else if !kind.is_trivia() {
            if self.line_starts {
                self.keyword(kind);
            }
            self.line_starts = false;
        }
    }

    fn keyword(&mut self, kind: SyntaxKind) {
        match kind {
            CASE_KW | DEFAULT_KW => self.pop_if(&[Block::Case]),
            ELSE_KW | ELSE_IF_KW => {
                self.pop_if(&[Block::If]);
                self.open.push(if kind == ELSE_KW { Block::Else } else { Block::If });
            }
            BREAK_KW => self.pop_if(&[Block::Case]),
            END_IF_KW => self.pop_to(&[Block::If, Block::Else]),
            END_WHILE_KW => self.pop_to(&[Block::While]),
            UNTIL_KW => self.pop_to(&[Block::Do]),
            END_FOR_KW => self.pop_to(&[Block::For]),
            END_SWITCH_KW => self.pop_to(&[Block::Switch]),
            _ => {}
        }
        self.open.extend(Block::opened_by(kind));
    }

    /// Closes the innermost block if it is one of these.
    fn pop_if(&mut self, blocks: &[Block]) {
        if self.open.last().is_some_and(|last| blocks.contains(last)) {
            self.open.pop();
        }
    }

    /// Closes the innermost of these blocks and all blocks inside it; without such a block, does nothing.
    fn pop_to(&mut self, blocks: &[Block]) {
        if let Some(at) = self.open.iter().rposition(|block| blocks.contains(block)) {
            self.open.truncate(at);
        }
    }
}
