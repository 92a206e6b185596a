//! Log point messages: text with expressions in braces.

use val3_debug::{CompiledExpression, LogMessage, LogPart};

use super::evaluation::EvaluationError;

/// Parses a message and compiles its expressions.
pub(super) fn message(
    text: &str,
    mut compile: impl FnMut(&str) -> Result<CompiledExpression, EvaluationError>,
) -> Result<LogMessage, EvaluationError> {
    let (mut parts, mut plain, mut rest) = (Vec::new(), String::new(), text);
    while let Some(at) = rest.find(['{', '}']) {
        let (before, from) = rest.split_at(at);
        plain += before;
        if let Some(after) = from.strip_prefix("{{") {
            plain.push('{');
            rest = after;
        } else if let Some(after) = from.strip_prefix("}}") {
            plain.push('}');
            rest = after;
        } else if let Some(inner) = from.strip_prefix('{') {
            let (code, after) = expression(inner).ok_or("write `}` after the expression, or `{{` for a brace")?;
            parts.extend((!plain.is_empty()).then(|| LogPart::Text(std::mem::take(&mut plain))));
            parts.push(LogPart::Value(compile(code.trim())?));
            rest = after;
        } else {
            return Err("write `}}` for a brace".into());
        }
    }
    plain += rest;
    parts.extend((!plain.is_empty()).then_some(LogPart::Text(plain)));
    Ok(LogMessage { parts })
}

/// Expression up to its closing brace, and the remaining text. Braces of structures and in strings belong to the
/// expression.
fn expression(text: &str) -> Option<(&str, &str)> {
    let (mut depth, mut is_string) = (0_u32, false);
    for (at, character) in text.char_indices() {
        match character {
            '"' => is_string = !is_string,
            '{' if !is_string => depth += 1,
            '}' if !is_string && depth == 0 => return Some((text.get(..at)?, text.get(at + 1..)?)),
            '}' if !is_string => depth -= 1,
            _ => {}
        }
    }
    None
}
