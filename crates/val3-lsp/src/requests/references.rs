//! `textDocument/references`

use tower_lsp::lsp_types::{Location, ReferenceParams};
use val3_analysis::db::FileRange;

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn references(snapshot: &Snapshot, params: &ReferenceParams) -> Result<Option<Vec<Location>>, Refusal> {
    let at = snapshot.position(&params.text_document_position)?;
    let found = val3_ide::references(snapshot.db(), at, params.context.include_declaration);
    let of_one_file = found.chunk_by(|one, other| one.file == other.file);
    Ok(Some(of_one_file.flat_map(|places| locations(snapshot, places)).collect()))
}

/// Protocol locations of ranges in one file.
fn locations(snapshot: &Snapshot, places: &[FileRange]) -> Vec<Location> {
    let file = places.first().map(|place| place.file).filter(|file| snapshot.is_shown(*file));
    let Some(file) = file else { return Vec::new() };
    let (uri, lines) = (snapshot.uri(file), snapshot.lines(file));
    places.iter().map(|place| Location { uri: uri.clone(), range: lines.range(place.range) }).collect()
}
