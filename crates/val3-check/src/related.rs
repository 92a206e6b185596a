//! Notes on the other locations of a fault.

use val3_analysis::problem::RelatedRole;
use val3_syntax::error::SyntaxErrorKind;

use crate::phrase::{opening_bracket, xml_part};

/// Note on another location of a fault that the analysis found.
pub(crate) fn role(role: RelatedRole) -> String {
    match role {
        RelatedRole::Declared => "declared here",
        RelatedRole::Parameter => "the parameter that receives it",
        RelatedRole::First => "the first one is here",
        RelatedRole::Interface => "the interface declares this",
        RelatedRole::Implementation => "the library has this instead",
        RelatedRole::Entry => "the project names it here",
        RelatedRole::List => "not in this list",
        RelatedRole::Use => "used here",
    }
    .to_owned()
}

/// Note on the related range of a syntax fault.
pub(crate) fn other_side(kind: &SyntaxErrorKind) -> String {
    use SyntaxErrorKind as Kind;
    match kind {
        Kind::UnclosedElement { name } => format!("`</{name}>` belongs here"),
        Kind::Unterminated(part) => format!("{} starts here", xml_part(*part)),
        Kind::UnclosedBracket { missing } => format!("`{}` opens here", opening_bracket(*missing)),
        Kind::UnclosedBlock { block, .. } => format!("`{block}` opens here"),
        Kind::DoWhile => "`do` opens here".to_owned(),
        Kind::CrossedBlocks { inner, .. } => format!("the `{inner}` ends here"),
        Kind::MissingBeginAndEnd => "`end` belongs here".to_owned(),
        Kind::MissingBreak => "the branch starts here".to_owned(),
        Kind::CaseAfterDefault | Kind::SecondDefault => "the first `default` is here".to_owned(),
        Kind::ElseAfterElse => "the first `else` is here".to_owned(),
        Kind::DuplicateAttribute { name } => format!("the first `{name}` is here"),
        Kind::TrailingText { .. } => "inside this bracket".to_owned(),
        _ => "it belongs to this".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_names_its_opening_keyword() {
        let kind = SyntaxErrorKind::UnclosedBlock { block: "while", missing: "endWhile" };
        assert_eq!(other_side(&kind), "`while` opens here");
    }

    #[test]
    fn a_bracket_names_its_opening_sign() {
        assert_eq!(other_side(&SyntaxErrorKind::UnclosedBracket { missing: ']' }), "`[` opens here");
    }

    #[test]
    fn a_finding_refers_to_the_declaration() {
        assert_eq!(role(RelatedRole::Declared), "declared here");
    }
}
