//! `val3/variables`: the parameters and locals of a program, for a table.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Range, Url};
use val3_analysis::db::File;
use val3_ide::{ProgramVariable, Variables};
use val3_lang::types::Container;

use crate::schema::protocol;
use crate::snapshot::{Refusal, Snapshot};

/// The request.
pub(crate) enum VariablesOfProgram {}

impl Request for VariablesOfProgram {
    type Params = VariablesParams;
    type Result = Option<VariablesResult>;
    const METHOD: &'static str = "val3/variables";
}

/// Program of the request.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct VariablesParams {
    /// URI of the program's file.
    #[schemars(with = "String")]
    uri: Url,
    /// Program name; may be omitted if the file contains only one program.
    program: Option<String>,
}

/// Parameters and locals.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct VariablesResult {
    /// URI of the program's file.
    #[schemars(with = "String")]
    uri: Url,
    /// Document version on which they are based; `null` for a file that is not open.
    version: Option<i32>,
    /// Program name.
    program: String,
    /// Parameters in order.
    parameters: Vec<Parameter>,
    /// Local variables in order.
    locals: Vec<Local>,
    /// Names of the types that variables may have.
    types: Vec<String>,
    /// Whether the file has the dialect of s5 and s6.
    is_old: bool,
    /// Reason why the parameters cannot be changed; `null` if they can.
    fixed: Option<String>,
}

/// Parameter of a program.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
struct Parameter {
    name: String,
    r#type: String,
    container: ContainerKind,
    /// Number of array dimensions; 1 for other containers.
    dimensions: u8,
    passing: Passing,
    /// Range of the name in the declaration.
    #[schemars(with = "protocol::RangeSchema")]
    range: Range,
    /// Number of uses in the code.
    uses: usize,
}

/// Local variable of a program.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
struct Local {
    name: String,
    r#type: String,
    container: ContainerKind,
    /// Sizes of the dimensions; empty for a collection.
    size: Vec<u32>,
    /// Range of the name in the declaration.
    #[schemars(with = "protocol::RangeSchema")]
    range: Range,
    /// Number of uses in the code.
    uses: usize,
}

/// Container kind of a variable.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum ContainerKind {
    Element,
    Array,
    Collection,
}

/// Passing of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum Passing {
    Value,
    Reference,
}

pub(crate) fn variables(snapshot: &Snapshot, params: &VariablesParams) -> Result<Option<VariablesResult>, Refusal> {
    let file = snapshot.file(&params.uri)?;
    let found = val3_ide::variables(snapshot.db(), file);
    let found = found.filter(|found| params.program.as_ref().is_none_or(|program| *program == *found.program));
    Ok(found.map(|found| described(snapshot, file, found)))
}

fn described(snapshot: &Snapshot, file: File, found: Variables) -> VariablesResult {
    let (parameters, locals) = (found.parameters.into_iter(), found.locals.into_iter());
    VariablesResult {
        uri: snapshot.uri(file),
        version: snapshot.version(file),
        program: found.program.to_string(),
        parameters: parameters.map(|it| parameter(it, snapshot, file)).collect(),
        locals: locals.map(|it| local(it, snapshot, file)).collect(),
        types: found.types.iter().map(ToString::to_string).collect(),
        is_old: found.is_old,
        fixed: found.fixed,
    }
}

fn parameter(it: ProgramVariable, snapshot: &Snapshot, file: File) -> Parameter {
    let (container, dimensions) = container(it.container);
    Parameter {
        range: snapshot.range(file, it.range),
        name: it.name.to_string(),
        r#type: it.type_name.to_string(),
        container,
        dimensions,
        passing: if it.by_reference { Passing::Reference } else { Passing::Value },
        uses: it.uses,
    }
}

fn local(it: ProgramVariable, snapshot: &Snapshot, file: File) -> Local {
    Local {
        range: snapshot.range(file, it.range),
        name: it.name.to_string(),
        r#type: it.type_name.to_string(),
        container: container(it.container).0,
        size: it.sizes,
        uses: it.uses,
    }
}

/// Container kind and number of dimensions.
fn container(container: Container) -> (ContainerKind, u8) {
    match container {
        Container::Element => (ContainerKind::Element, 1),
        Container::Array { dims } => (ContainerKind::Array, dims),
        Container::Collection => (ContainerKind::Collection, 1),
    }
}
