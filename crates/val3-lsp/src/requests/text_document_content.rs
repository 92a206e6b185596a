//! `workspace/textDocumentContent` (3.18): the code of a program without XML, for any client.
//!
//! The URI is that of the program's file with the scheme `val-text`. The document is read-only: other requests use the
//! URI of the file. When the code changes, the client is notified by `workspace/textDocumentContent/refresh`.

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::Url;
use tower_lsp::lsp_types::request::Request;

use crate::display_cache::Fingerprint;
use crate::snapshot::{Refusal, Snapshot};

/// URI scheme of code without XML.
pub(crate) const SCHEME: &str = "val-text";

/// The request, which lsp-types does not define yet.
pub(crate) enum TextDocumentContent {}

impl Request for TextDocumentContent {
    type Params = TextDocumentContentParams;
    type Result = DocumentContent;
    const METHOD: &'static str = "workspace/textDocumentContent";
}

/// Server request after which the client requests the content again.
pub(crate) enum TextDocumentContentRefresh {}

impl Request for TextDocumentContentRefresh {
    type Params = TextDocumentContentParams;
    type Result = ();
    const METHOD: &'static str = "workspace/textDocumentContent/refresh";
}

/// URI of the document.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct TextDocumentContentParams {
    pub(crate) uri: Url,
}

/// Content of the document.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct DocumentContent {
    text: String,
}

pub(crate) fn text_document_content(
    snapshot: &Snapshot,
    params: &TextDocumentContentParams,
) -> Result<DocumentContent, Refusal> {
    let text = text(snapshot, &params.uri)?;
    snapshot.documents.display_cache().keep_text(params.uri.clone(), Fingerprint::of(&text));
    Ok(DocumentContent { text })
}

/// Fingerprint of the current content; `None` if it no longer exists.
pub(crate) fn current_text(snapshot: &Snapshot, uri: &Url) -> Option<Fingerprint> {
    text(snapshot, uri).ok().map(|text| Fingerprint::of(&text))
}

fn text(snapshot: &Snapshot, uri: &Url) -> Result<String, Refusal> {
    let because = |reason: &str| Refusal::Because(format!("{uri}: {reason}"));
    let rest = uri.as_str().strip_prefix(SCHEME).filter(|rest| rest.starts_with("://"));
    let rest = rest.ok_or_else(|| because(&format!("the scheme of code without XML is `{SCHEME}`")))?;
    let file = Url::parse(&format!("file{rest}")).map_err(|error| because(&error.to_string()))?;
    let file = snapshot.file(&file).map_err(|_| because("no file of the workspace has this path"))?;
    val3_ide::code_text(snapshot.db(), file).ok_or_else(|| because("the file has no element `<Code>`"))
}
