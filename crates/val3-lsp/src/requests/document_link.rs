//! `textDocument/documentLink`

use tower_lsp::lsp_types::{DocumentLink, DocumentLinkParams};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn document_link(
    snapshot: &Snapshot,
    params: &DocumentLinkParams,
) -> Result<Option<Vec<DocumentLink>>, Refusal> {
    let file = snapshot.file(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let links = val3_ide::document_links(snapshot.db(), file).into_iter().map(|found| DocumentLink {
        range: lines.range(found.range),
        target: Some(snapshot.uri(found.target)),
        tooltip: None,
        data: None,
    });
    Ok(Some(links.collect()))
}
