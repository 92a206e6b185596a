//! `textDocument/hover`

use tower_lsp::lsp_types::{Hover, HoverContents, HoverParams};

use crate::convert::markup;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn hover(snapshot: &Snapshot, params: &HoverParams) -> Result<Option<Hover>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    let is_markdown = snapshot.session.client.reads_markdown.in_hovers;
    Ok(val3_ide::hover(snapshot.db(), at).map(|hover| Hover {
        contents: HoverContents::Markup(markup(is_markdown, hover.markdown)),
        range: Some(snapshot.range(at.file, hover.range)),
    }))
}
