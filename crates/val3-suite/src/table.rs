//! Tables of tests: a test with the parameter `num x_nCase` is executed once for each row.
//!
//! The table of a test consists of the global arrays that it reads with the index `x_nCase`, such as `nInput[x_nCase]`
//! or `tCases[x_nCase].nSum`.

use std::collections::BTreeMap;

use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::items::project::items;
use val3_bytecode::{Image, Program, ProgramParam, Storage};
use val3_lang::memory::ContainerShape;
use val3_lang::types::{BaseType, Container};
use val3_session::Application;

/// Parameter that receives the row number, from 0.
const ROW: &str = "x_nCase";

/// Table of a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseTable {
    pub(crate) rows: u32,
    /// Column names, in order.
    pub(crate) columns: Vec<String>,
}

/// Returns the table that a test reads; `None` for a test without parameters.
///
/// # Errors
/// The test has other parameters, or its table has no rows or columns of different lengths.
pub(crate) fn table(application: &Application, image: &Image, program: &Program) -> Result<Option<CaseTable>, String> {
    match program.params.as_slice() {
        [] => return Ok(None),
        [param] if param.name == ROW && is_number(param) => {}
        _ => {
            return Err(format!(
                "`{}` has parameters: a test has none, or only `num {ROW}`, the number of a row",
                program.name
            ));
        }
    }
    let (db, project) = (application.db(), application.project());
    let file = items(db, project).programs.get(program.name.as_str()).copied();
    let names = file.map(|file| columns(body(db, file))).unwrap_or_default();
    let global = names.into_iter().filter(|name| !program.variables.iter().any(|variable| variable.name == *name));
    let lengths: BTreeMap<&str, u32> = global.filter_map(|name| Some((name, length(image, name)?))).collect();
    let mut distinct: Vec<u32> = lengths.values().copied().collect();
    distinct.sort_unstable();
    distinct.dedup();
    match distinct.as_slice() {
        [] => Err(format!("`{}` reads no global array by `{ROW}`, so that it has no rows", program.name)),
        [rows] => Ok(Some(CaseTable { rows: *rows, columns: lengths.into_keys().map(str::to_owned).collect() })),
        _ => {
            let listed: Vec<String> = lengths.iter().map(|(name, length)| format!("`{name}` {length}")).collect();
            Err(format!("the columns of its table have different numbers of rows: {}", listed.join(", ")))
        }
    }
}

fn is_number(param: &ProgramParam) -> bool {
    let is_value = matches!(param.storage, Storage::Value(_));
    is_value && param.container == Container::Element && param.kind.base_type() == Some(BaseType::Num)
}

/// Variables that are read with the row number as index.
fn columns(body: &Body) -> Vec<&str> {
    let columns = body.exprs().filter_map(|(_, expr, _)| {
        let Expr::Index(base, indexes) = expr else { return None };
        is_row(body, *indexes.first()?).then(|| name(body, *base))?
    });
    columns.collect()
}

fn is_row(body: &Body, id: ExprId) -> bool {
    name(body, body.without_parentheses(id)) == Some(ROW)
}

fn name(body: &Body, id: ExprId) -> Option<&str> {
    match body.expr(id) {
        Expr::Name(name) => Some(name),
        _ => None,
    }
}

/// Size of a global array's first dimension.
fn length(image: &Image, name: &str) -> Option<u32> {
    let data = image.data.get(usize::from(image.data(name)?))?;
    match data.init.shape {
        ContainerShape::Array { sizes: [length, ..], .. } => Some(length),
        ContainerShape::Collection(_) => None,
    }
}
