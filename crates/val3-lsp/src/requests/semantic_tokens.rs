//! `textDocument/semanticTokens/full`, `full/delta` and `range`

use std::hash::{Hash as _, Hasher as _};

use rustc_hash::FxHasher;
use tower_lsp::lsp_types::*;
use val3_analysis::db::File;
use val3_syntax::{TextRange, TextSlice};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn full(
    snapshot: &Snapshot,
    params: &SemanticTokensParams,
) -> Result<Option<SemanticTokensResult>, Refusal> {
    let tokens = whole(snapshot, &params.text_document.uri)?;
    snapshot.documents.keep_tokens(&params.text_document.uri, &tokens);
    Ok(Some(SemanticTokensResult::Tokens(tokens)))
}

pub(crate) fn delta(
    snapshot: &Snapshot,
    params: &SemanticTokensDeltaParams,
) -> Result<Option<SemanticTokensFullDeltaResult>, Refusal> {
    let uri = &params.text_document.uri;
    let tokens = whole(snapshot, uri)?;
    let before = snapshot.documents.kept_tokens(uri);
    snapshot.documents.keep_tokens(uri, &tokens);
    let known = before.filter(|before| before.result_id.as_ref() == Some(&params.previous_result_id));
    Ok(Some(match known {
        Some(before) => SemanticTokensFullDeltaResult::TokensDelta(SemanticTokensDelta {
            result_id: tokens.result_id,
            edits: difference(&before.data, &tokens.data),
        }),
        None => SemanticTokensFullDeltaResult::Tokens(tokens),
    }))
}

pub(crate) fn range(
    snapshot: &Snapshot,
    params: &SemanticTokensRangeParams,
) -> Result<Option<SemanticTokensRangeResult>, Refusal> {
    let file = snapshot.file(&params.text_document.uri)?;
    let within = snapshot.lines(file).text_range(params.range);
    let data = encoded(snapshot, file, Some(within));
    Ok(Some(SemanticTokensRangeResult::Tokens(SemanticTokens { result_id: None, data })))
}

fn whole(snapshot: &Snapshot, uri: &Url) -> Result<SemanticTokens, Refusal> {
    let data = encoded(snapshot, snapshot.file(uri)?, None);
    let mut hasher = FxHasher::default();
    for token in &data {
        [token.delta_line, token.delta_start, token.length, token.token_type, token.token_modifiers_bitset]
            .hash(&mut hasher);
    }
    Ok(SemanticTokens { result_id: Some(format!("{:x}", hasher.finish())), data })
}

/// Tokens encoded relative to their predecessors.
fn encoded(snapshot: &Snapshot, file: File, within: Option<TextRange>) -> Vec<SemanticToken> {
    let lines = snapshot.lines(file);
    let mut before = Position::default();
    let tokens = val3_ide::semantic_tokens(snapshot.db(), file, within);
    let relative = tokens.iter().map(|token| {
        let start = lines.position(token.range.start());
        let delta_line = start.line.saturating_sub(before.line);
        let from = if delta_line == 0 { before.character } else { 0 };
        let delta_start = start.character.saturating_sub(from);
        before = start;
        SemanticToken {
            delta_line,
            delta_start,
            length: lines.width(token.range),
            token_type: token.kind as u32,
            token_modifiers_bitset: token.modifiers,
        }
    });
    relative.collect()
}

/// One edit that replaces everything between the common prefix and suffix. Its positions count integers, five for each
/// token.
fn difference(before: &[SemanticToken], after: &[SemanticToken]) -> Vec<SemanticTokensEdit> {
    const NUMBERS: usize = 5;
    let same = |(a, b): &(&SemanticToken, &SemanticToken)| a == b;
    let start = before.iter().zip(after).take_while(same).count();
    if start == before.len() && start == after.len() {
        return Vec::new();
    }
    let (rest_before, rest_after) = (before.part(start..), after.part(start..));
    let end = rest_before.iter().rev().zip(rest_after.iter().rev()).take_while(same).count();
    let number = |tokens: usize| u32::try_from(tokens * NUMBERS).unwrap_or(u32::MAX);
    let data = rest_after.part(..rest_after.len() - end).to_vec();
    vec![SemanticTokensEdit { start: number(start), delete_count: number(rest_before.len() - end), data: Some(data) }]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(lines: &[u32]) -> Vec<SemanticToken> {
        let tokens = lines.iter().map(|line| SemanticToken {
            delta_line: *line,
            delta_start: 0,
            length: 1,
            token_type: 0,
            token_modifiers_bitset: 0,
        });
        tokens.collect()
    }

    fn applied(before: &[u32], after: &[u32]) -> Vec<u32> {
        let mut lines = before.to_vec();
        for edit in difference(&tokens(before), &tokens(after)) {
            let start = edit.start as usize / 5;
            let new: Vec<u32> = edit.data.unwrap().iter().map(|token| token.delta_line).collect();
            lines.splice(start..start + edit.delete_count as usize / 5, new);
        }
        lines
    }

    #[test]
    fn a_difference_turns_old_tokens_into_new_ones() {
        let cases: [(&[u32], &[u32]); 6] = [
            (&[1, 2, 3], &[1, 2, 3]),
            (&[1, 2, 3], &[1, 3]),
            (&[], &[1]),
            (&[1, 1], &[1]),
            (&[1], &[2, 1, 1]),
            (&[1, 2], &[]),
        ];
        for (before, after) in cases {
            assert_eq!(applied(before, after), after);
        }
    }
}
