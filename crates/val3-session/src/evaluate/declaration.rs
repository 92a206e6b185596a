//! Variable declarations in evaluated code: `num nA`, `num nB=2`, `point pA[3]`, `num nC=1, nD`.

use val3_syntax::TextSlice;

use super::variable::ScratchVariable;

/// A declared variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Declaration {
    pub(super) variable: ScratchVariable,
    /// Assignment of the value, preceded by spaces that preserve its position in the code.
    pub(super) assignment: Option<String>,
}

/// Variables that the code declares; `None` if it does not begin with a type.
///
/// # Errors
/// A message about an invalid declaration.
pub(super) fn declarations(text: &str, is_type: impl Fn(&str) -> bool) -> Option<Result<Vec<Declaration>, String>> {
    let start = text.len() - text.trim_start().len();
    let code = text.get(start..)?;
    let (ty, rest) = code.split_once([' ', '\t'])?;
    let begins = rest.trim_start().starts_with(|first: char| first.is_ascii_alphabetic() || first == '_');
    if !begins || !is_type(ty) || text.trim().contains('\n') {
        return None;
    }
    let pieces = pieces(text, start + ty.len());
    Some(pieces.into_iter().map(|(from, piece)| declaration(ty, text, from, piece)).collect())
}

fn declaration(ty: &str, text: &str, from: usize, piece: &str) -> Result<Declaration, String> {
    let (declared, value) = piece.split_once('=').map_or((piece, None), |(declared, value)| (declared, Some(value)));
    let variable = ScratchVariable::parse(&format!("{ty} {}", declared.trim()))?;
    if value.is_some() && variable.is_container() {
        let name = variable.name();
        return Err(format!("`{name}` has several values: declare it, then assign to its elements"));
    }
    let before = text.part(..from).chars().count();
    let assignment = value.map(|_| format!("{}{}", " ".repeat(before), piece.trim_end()));
    Ok(Declaration { variable, assignment })
}

/// Parts of the text after `from`, separated by commas outside brackets and strings, with their offsets.
fn pieces(text: &str, from: usize) -> Vec<(usize, &str)> {
    let (mut pieces, mut start, mut depth, mut in_string) = (Vec::new(), from, 0_u32, false);
    for (at, character) in text.char_indices().skip_while(|(at, _)| *at < from) {
        match character {
            '"' => in_string = !in_string,
            '(' | '[' | '{' if !in_string => depth += 1,
            ')' | ']' | '}' if !in_string => depth = depth.saturating_sub(1),
            ',' if !in_string && depth == 0 => {
                pieces.extend(text.get(start..at).map(|piece| (start, piece)));
                start = at + 1;
            }
            _ => {}
        }
    }
    pieces.extend(text.get(start..).map(|piece| (start, piece)));
    pieces
}

#[cfg(test)]
mod tests {
    use super::{Declaration, declarations};

    fn declared(text: &str) -> Option<String> {
        let found = declarations(text, |ty| ["num", "string", "Slot"].contains(&ty))?;
        Some(match found {
            Ok(found) => found.iter().map(shown).collect::<Vec<_>>().join("|"),
            Err(error) => error,
        })
    }

    fn shown(declaration: &Declaration) -> String {
        let name = declaration.variable.name();
        declaration.assignment.as_ref().map_or(name.to_owned(), |assignment| format!("{name}:{assignment}"))
    }

    #[test]
    fn declarations_have_a_type_and_names() {
        assert_eq!(declared("num nA").as_deref(), Some("nA"));
        assert_eq!(declared("  Slot\t sA").as_deref(), Some("sA"));
        assert_eq!(declared("num nA=max(1,2), nB[2,3]").as_deref(), Some("nA:    nA=max(1,2)|nB"));
        assert_eq!(declared("string s = \"a,=[\"").as_deref(), Some("s:       s = \"a,=[\""));
    }

    #[test]
    fn other_texts_declare_nothing() {
        for text in ["num", "num(1)", "nA=2", "call num()", "num =2", "num nA\nnA=2", "? num", "numb nA"] {
            assert_eq!(declared(text), None, "{text}");
        }
    }

    #[test]
    fn wrong_declarations_are_explained() {
        assert!(declared("num nA b").unwrap().contains("is not a declaration"));
        assert!(declared("num nA[2]=1").unwrap().contains("several values"));
    }
}
