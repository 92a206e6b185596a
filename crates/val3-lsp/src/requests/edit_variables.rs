//! `val3/editVariables`: replaces the parameters and locals of a program, and changes all affected calls and uses.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Url, WorkspaceEdit};
use val3_analysis::items::program::header;
use val3_ide::{NewLocal, NewParameter, NewVariables};
use val3_lang::types::Container;

use super::variables::{ContainerKind, Passing};
use crate::convert::workspace_edit;
use crate::schema::protocol;
use crate::snapshot::{Refusal, Snapshot};

/// The request.
pub(crate) enum EditVariables {}

impl Request for EditVariables {
    type Params = EditVariablesParams;
    type Result = EditVariablesResult;
    const METHOD: &'static str = "val3/editVariables";
}

/// A program with its new variables.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct EditVariablesParams {
    /// URI of the program's file.
    #[schemars(with = "String")]
    uri: Url,
    /// Document version on which the edit is based; `null` for a file that is not open.
    version: Option<i32>,
    /// Program name.
    program: String,
    edits: VariableEdits,
}

/// All parameters and all locals, in order. A missing list is unchanged.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
struct VariableEdits {
    parameters: Option<Vec<ParameterEdit>>,
    locals: Option<Vec<LocalEdit>>,
}

/// Parameter after the edit.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
struct ParameterEdit {
    /// Previous index; missing for a new parameter.
    from: Option<usize>,
    name: String,
    r#type: String,
    container: ContainerKind,
    /// Number of array dimensions, by default 1.
    dimensions: Option<u8>,
    passing: Passing,
    /// Expression that callers pass for a new parameter.
    argument: Option<String>,
}

/// Local variable after the edit.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
struct LocalEdit {
    /// Previous index; missing for a new variable.
    from: Option<usize>,
    name: String,
    r#type: String,
    /// Array size, by dimension; empty for a collection.
    size: Vec<u32>,
}

/// The edits, or the reason why there are none.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct EditVariablesResult {
    /// Edit of the program and its callers; `null` if it is rejected.
    #[schemars(with = "Option<protocol::WorkspaceEditSchema>")]
    edit: Option<WorkspaceEdit>,
    /// Reason as a sentence for users.
    refused: Option<String>,
}

pub(crate) fn edit_variables(
    snapshot: &Snapshot,
    params: &EditVariablesParams,
) -> Result<EditVariablesResult, Refusal> {
    let file = snapshot.file(&params.uri)?;
    if snapshot.version(file) != params.version {
        return Err(Refusal::Outdated);
    }
    let header = header(snapshot.db(), file);
    if header.name != *params.program {
        return Err(Refusal::Because(format!("the file has no program `{}`", params.program)));
    }
    let mut wanted = NewVariables::of(header);
    if let Some(parameters) = &params.edits.parameters {
        wanted.parameters = parameters.iter().cloned().map(parameter).collect();
    }
    if let Some(locals) = &params.edits.locals {
        wanted.locals = locals.iter().cloned().map(local).collect();
    }
    Ok(match snapshot.with_fixes(|context| val3_ide::edit_variables(context, file, &wanted)) {
        Ok(change) => EditVariablesResult { edit: Some(workspace_edit(snapshot, &change)?), refused: None },
        Err(reason) => EditVariablesResult { edit: None, refused: Some(reason.0) },
    })
}

fn parameter(edit: ParameterEdit) -> NewParameter {
    let container = match edit.container {
        ContainerKind::Element => Container::Element,
        ContainerKind::Array => Container::Array { dims: edit.dimensions.unwrap_or(1) },
        ContainerKind::Collection => Container::Collection,
    };
    NewParameter {
        from: edit.from,
        name: edit.name,
        type_name: edit.r#type,
        container,
        by_reference: edit.passing == Passing::Reference,
        argument: edit.argument.unwrap_or_default(),
    }
}

fn local(edit: LocalEdit) -> NewLocal {
    NewLocal { from: edit.from, name: edit.name, type_name: edit.r#type, sizes: edit.size }
}
