//! `textDocument/hover`

use tower_lsp::lsp_types::{Hover, HoverContents, HoverParams};

use crate::convert::markup;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn hover(snapshot: &Snapshot, params: &HoverParams) -> Result<Option<Hover>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    let format = snapshot.session.client.formats.hovers;
    Ok(val3_ide::hover(snapshot.db(), at).map(|hover| Hover {
        contents: HoverContents::Markup(markup(format, hover.markdown)),
        range: Some(snapshot.range(at.file, hover.range)),
    }))
}
