//! `switch` with its cases.

use super::blocks::{BlockKind, Blocks, Ending};
use super::control::{LastBranch, close, condition, inner};
use super::expressions::value;
use super::rest_of_line::line_end;
use super::statements::{statement, stray_keyword};
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Parses `switch`; after a missing `switch`, the rest from `case` or `default` on.
pub(super) fn switch_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    let headless = !p.at(SWITCH_KW);
    blocks.push(p, BlockKind::Switch, headless);
    if !headless {
        condition(p);
    }
    let own = Cases { headless, ..Cases::default() }.read(p, blocks);
    close(p, blocks, own);
    m.complete(p, SWITCH_STMT);
}

/// State of parsing the cases of a `switch`.
#[derive(Default)]
struct Cases {
    default: LastBranch,
    any: bool,
    /// Whether the `switch` is missing, which was already reported.
    headless: bool,
}

impl Cases {
    /// Parses all cases. Returns whether `endSwitch` follows.
    fn read(&mut self, p: &mut Parser<'_>, blocks: &mut Blocks) -> bool {
        while !p.at_code_end() {
            p.start_statement();
            match blocks.ending(p) {
                Ending::Over if !blocks.take_own(p) => return false,
                Ending::Over if p.at(END_SWITCH_KW) => return true,
                Ending::Over => self.case(p, blocks),
                Ending::Stray => stray_keyword(p, blocks),
                Ending::None => self.statement(p, blocks),
            }
        }
        false
    }

    /// Parses a `case` or `default` up to its `break`.
    fn case(&mut self, p: &mut Parser<'_>, blocks: &mut Blocks) {
        let keyword = p.range(p.position());
        let is_case = p.at(CASE_KW);
        if is_case {
            self.default.check(p, SyntaxErrorKind::CaseAfterDefault);
        } else {
            self.default.check(p, SyntaxErrorKind::SecondDefault);
            self.default.found(keyword);
        }
        self.any = true;
        blocks.note_layout(p);
        let m = p.start();
        blocks.push(p, BlockKind::Case, self.headless);
        p.bump();
        if is_case {
            case_values(p);
        }
        line_end(p);
        let own = inner(p, blocks);
        close(p, blocks, own);
        m.complete(p, if is_case { CASE_CLAUSE } else { DEFAULT_CLAUSE });
    }

    /// Parses a line outside of all cases. After a `break` the controller accepts it, but never executes it.
    fn statement(&mut self, p: &mut Parser<'_>, blocks: &mut Blocks) {
        if self.any {
            blocks.note_layout(p);
            return statement(p, blocks);
        }
        p.error(SyntaxErrorKind::StatementBeforeCase);
        self.any = true;
        // Statements up to a `break` belong to the same mistake.
        let m = p.start();
        blocks.push(p, BlockKind::Case, true);
        let own = inner(p, blocks);
        close(p, blocks, own);
        m.complete(p, CASE_CLAUSE);
    }
}

fn case_values(p: &mut Parser<'_>) {
    loop {
        if p.at_line_end() {
            return p.expected(Expected::CaseValue);
        }
        value(p);
        if p.here() != COMMA {
            return;
        }
        p.bump();
    }
}
