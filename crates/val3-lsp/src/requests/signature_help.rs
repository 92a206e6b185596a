//! `textDocument/signatureHelp`

use tower_lsp::lsp_types::*;
use val3_ide::CallForm;

use crate::convert::documentation;
use crate::session::TextFormat;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn signature_help(
    snapshot: &Snapshot,
    params: &SignatureHelpParams,
) -> Result<Option<SignatureHelp>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    let Some(help) = val3_ide::signature_help(snapshot.db(), at) else { return Ok(None) };
    let active_parameter = u32::try_from(help.active_parameter).ok();
    let format = snapshot.session.client.formats.signatures;
    let signatures = help.forms.iter().map(|form| signature(form, active_parameter, format)).collect();
    Ok(Some(SignatureHelp { signatures, active_signature: u32::try_from(help.active_form).ok(), active_parameter }))
}

fn signature(form: &CallForm, active_parameter: Option<u32>, format: TextFormat) -> SignatureInformation {
    let parameters = form.parameters.iter().map(|(from, to)| ParameterInformation {
        label: ParameterLabel::LabelOffsets([utf16(&form.line, *from), utf16(&form.line, *to)]),
        documentation: None,
    });
    SignatureInformation {
        label: form.line.clone(),
        documentation: (!form.documentation.is_empty()).then(|| documentation(format, form.documentation.clone())),
        parameters: Some(parameters.collect()),
        active_parameter,
    }
}

/// Converts a byte offset in a label to UTF-16 units, which labels use independently of the position encoding.
fn utf16(line: &str, bytes: u32) -> u32 {
    let before = usize::try_from(bytes).ok().and_then(|bytes| line.get(..bytes)).unwrap_or(line);
    u32::try_from(before.encode_utf16().count()).unwrap_or(bytes)
}
