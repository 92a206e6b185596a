//! Fixes of faults, by kind. A fault without a line here has no fix.

use val3_analysis::problem::ProblemKind;
use val3_syntax::error::SyntaxErrorKind;

use super::{Site, rename};
use crate::conversion;
use crate::diagnostic::Fix;
use crate::rules::{
    argument_count, assignment_in_expression, comment_after_code, control_character, duplicate_entry, father_missing,
    foreign_spelling, missing_attribute, missing_begin_end, missing_break, namespace, no_effect, path_separator,
    program_name_mismatch, unclosed_block, unclosed_bracket, unknown_instruction, unknown_program, unmatched_block_end,
    unmatched_bracket, unresolved_path, xml_text,
};

/// Fix of a syntax fault.
pub(crate) fn of_syntax(kind: &SyntaxErrorKind, site: &Site<'_>) -> Option<Fix> {
    use SyntaxErrorKind as Kind;
    match kind {
        Kind::UnknownEntity { text } => xml_text::fix(site, text),
        Kind::UnclosedBracket { missing } => unclosed_bracket::fix(site, *missing),
        Kind::UnmatchedBracket { bracket } => unmatched_bracket::fix(site, *bracket),
        Kind::UnclosedBlock { missing, .. } => unclosed_block::fix(site, missing),
        Kind::DoWhile => unclosed_block::end_with_until(site),
        Kind::MissingBegin => missing_begin_end::fix(site, "begin"),
        Kind::MissingEnd => missing_begin_end::fix(site, "end"),
        Kind::MissingBeginAndEnd => missing_begin_end::fix_both(site),
        Kind::CrossedBlocks { early, late, .. } => unclosed_block::swap(site, early, late),
        Kind::UnmatchedBlockEnd { found, .. } => unmatched_block_end::fix(site, found),
        Kind::MissingBreak => missing_break::fix(site),
        Kind::AssignmentInExpression => assignment_in_expression::fix(site),
        Kind::CommentAfterCode => comment_after_code::fix(site),
        Kind::ControlCharacter { .. } => control_character::fix(site),
        Kind::ForeignSpelling { instead, .. } => foreign_spelling::fix(site, instead),
        _ => None,
    }
}

/// Fix of a fault that the analysis found.
pub(crate) fn of_problem(kind: &ProblemKind, site: &Site<'_>) -> Option<Fix> {
    use ProblemKind as Kind;
    match kind {
        Kind::UnknownName { name, near } => rename(site, name, near.as_deref()),
        Kind::UnknownProgram { name, near, is } => unknown_program::fix(site, name, near.as_deref(), *is),
        Kind::UnknownInstruction { name, near, is } => unknown_instruction::fix(site, name, near.as_deref(), *is),
        Kind::UnknownLibrary { alias, near } => rename(site, alias, near.as_deref()),
        Kind::UnknownType { name, near } => rename(site, name, near.as_deref()),
        Kind::UnknownField { field, near, .. } => rename(site, field, near.as_deref()),
        Kind::AssignmentType { target, value } => conversion::fix(site, value, target),
        Kind::ArgumentType { expected, found, .. } => {
            expected.iter().find_map(|wanted| conversion::fix(site, found, wanted))
        }
        Kind::ArgumentCount { expected, found, forms, .. } => argument_count::fix(site, expected, *found, forms),
        Kind::ConditionType { found, .. } => conversion::fix(site, found, "bool"),
        Kind::NoEffect => no_effect::fix(site),
        Kind::MissingAttribute { attribute, written, .. } => {
            missing_attribute::fix(site, attribute, written.as_deref())
        }
        Kind::UnknownAttribute { attribute, near, .. } => rename(site, attribute, near.as_deref()),
        Kind::Namespace { expected, .. } => namespace::fix(site, expected),
        Kind::PathSeparator { path } => path_separator::fix(site, path),
        Kind::UnresolvedPath { root, near, .. } => unresolved_path::fix(site, root, near.as_deref()),
        Kind::DuplicateEntry { what, .. } => duplicate_entry::fix(site, *what),
        Kind::ProgramNameMismatch { program, file } => program_name_mismatch::fix(site, program, file),
        Kind::UnknownValueAttribute { attribute, near, .. } => rename(site, attribute, near.as_deref()),
        Kind::UnknownUserField { field, near, .. } => rename(site, field, near.as_deref()),
        Kind::FatherMissing { father, near } => father_missing::fix(site, father, near.as_deref()),
        Kind::IoLinkUnknown { link, near } => rename(site, link, near.as_deref()),
        Kind::LibraryItemUnknown { item, near, .. } => rename(site, item, near.as_deref()),
        _ => None,
    }
}
