//! `write_data`: global data with values, in the format of the data file.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use val3_analysis::db::{Database, File, Project};
use val3_analysis::items::project::{data_files, items};
use val3_analysis::system::Disk;
use val3_ide::{CellEdit, DataEdit, DataPlace, FieldStep, NewDatum, data_edits};
use val3_lang::types::{Arm, BaseType, Container};

use crate::answer::Answer;
use crate::changes::Changes;
use crate::projects;
use crate::refusal::Refusal;
use crate::tool::{Call, Definition, Effect};
use crate::written::changed;

/// The tool.
pub(super) struct WriteData;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Folder of the application, library or user type
    path: String,
    /// Name of the data
    name: String,
    /// Type, such as num, string, point, mdesc, or a user type; required for new data
    #[serde(rename = "type")]
    type_name: Option<String>,
    /// Sizes of an array, such as `[3]` or `[2,4]`. Default: one value
    size: Option<Vec<u32>>,
    /// Whether other projects may use it
    public: Option<bool>,
    /// Values by key ("0", "1,2"): a value, or an object of file attributes, such as {"0": 5} or
    /// `{"0": {"x": 100, "rx": 180, "fatherId": "fPallet[0]"}}`; `"0.pPlace[0]"` for a field of a user type
    #[serde(default)]
    values: BTreeMap<String, Value>,
    /// Only show the effect, and write nothing
    #[serde(default)]
    dry_run: bool,
}

impl Definition for WriteData {
    const NAME: &'static str = "write_data";
    const TITLE: &'static str = "Write global data";
    const DESCRIPTION: &'static str = "Declares global data of a project, or changes size, access and values of \
        existing data, in the format of the data file. Returns the changed lines and the findings that are new.";
    const EFFECT: Effect = Effect::Writes;
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        let workspace = projects::read(&Disk, call.roots, &path)?;
        let db = &workspace.db;
        let project = projects::only(&workspace, call.roots, &path)?;
        let (file, edits) = edits(db, project, &arguments)?;
        let change = data_edits(db, project, file, &edits).map_err(|problem| Refusal(problem.reason))?;
        changed(call, &Changes::of(db, call.roots, &change)?, &path, arguments.dry_run)
    }
}

/// Returns the data file, and the edits of the data's table.
fn edits(db: &Database, project: Project, arguments: &Arguments) -> Result<(File, Vec<DataEdit>), Refusal> {
    let known = items(db, project).data.get(arguments.name.as_str());
    let mut edits = Vec::new();
    let file = match known {
        Some(item) => {
            check_type(db, project, arguments, &item.decl.type_name)?;
            if let Some(sizes) = arguments.size.as_ref().filter(|sizes| **sizes != item.decl.sizes) {
                edits.push(DataEdit::Resize { place: variable(&arguments.name), sizes: sizes.clone() });
            }
            if let Some(public) = arguments.public.filter(|public| *public != item.decl.public) {
                edits.push(DataEdit::Access { names: vec![arguments.name.clone()], public });
            }
            item.file
        }
        None => {
            edits.push(DataEdit::Add(datum(db, project, arguments)?));
            let files = data_files(db, project);
            *files.first().ok_or_else(|| Refusal::new("the project has no data file: add one to its .pjx"))?
        }
    };
    let cells: Vec<CellEdit> = arguments
        .values
        .iter()
        .map(|(key, value)| cells(&arguments.name, key, value))
        .collect::<Result<Vec<_>, _>>()?
        .concat();
    if !cells.is_empty() {
        edits.push(DataEdit::Set(cells));
    }
    Ok((file, edits))
}

fn datum(db: &Database, project: Project, arguments: &Arguments) -> Result<NewDatum, Refusal> {
    let name = arguments.name.clone();
    let type_name = arguments
        .type_name
        .as_ref()
        .ok_or_else(|| Refusal(format!("there is no data `{name}` yet: name its `type`, or use one of `outline`")))?;
    let sizes = arguments.size.clone().unwrap_or_else(|| vec![1]);
    let container = match sizes.as_slice() {
        [] => Container::Collection,
        sizes => Container::Array { dims: u8::try_from(sizes.len()).unwrap_or(u8::MAX) },
    };
    let (public, type_name) = (arguments.public.unwrap_or(false), file_type(db, project, type_name));
    Ok(NewDatum { name, type_name, public, container, sizes, after: None })
}

/// Checks that the arguments name no other type than existing data has.
fn check_type(db: &Database, project: Project, arguments: &Arguments, known: &str) -> Result<(), Refusal> {
    let Arguments { name, type_name, .. } = arguments;
    match type_name {
        Some(wanted) if wanted != known && file_type(db, project, wanted) != known => Err(Refusal(format!(
            "`{name}` has the type `{known}`, which cannot become `{wanted}`: choose another name"
        ))),
        _ => Ok(()),
    }
}

/// Type name in the spelling of data files, in which positions include the kind of arm.
fn file_type(db: &Database, project: Project, type_name: &str) -> String {
    let arm = items(db, project).arm.unwrap_or(Arm::SixAxis);
    match BaseType::from_name(type_name) {
        Some(base) if base.depends_on_arm() => base.file_name(arm),
        _ => type_name.to_owned(),
    }
}

fn variable(name: &str) -> DataPlace {
    DataPlace { name: name.to_owned(), key: None, within: Vec::new() }
}

/// Cells of the value with a key. In the key of a field, the field follows a dot: `0.pPlace[0]`.
fn cells(name: &str, key: &str, value: &Value) -> Result<Vec<CellEdit>, Refusal> {
    let mut steps = key.split('.');
    let first = steps.next().unwrap_or_default();
    let within = steps.map(|step| {
        let (name, key) = step.split_once('[').unwrap_or((step, ""));
        FieldStep { name: name.to_owned(), key: key.trim_end_matches(']').to_owned() }
    });
    let place = DataPlace { name: name.to_owned(), key: Some(first.to_owned()), within: within.collect() };
    let columns: Vec<(&str, &Value)> = match value {
        Value::Object(columns) => columns.iter().map(|(column, value)| (column.as_str(), value)).collect(),
        value => vec![("value", value)],
    };
    let mut cells = Vec::new();
    for (column, value) in columns {
        cells.push(CellEdit { place: place.clone(), column: column.to_owned(), text: cell_text(value)? });
    }
    Ok(cells)
}

/// Text of a cell; `None` for the cell's default.
fn cell_text(value: &Value) -> Result<Option<String>, Refusal> {
    match value {
        Value::Null => Ok(None),
        Value::String(text) => Ok(Some(text.clone())),
        Value::Bool(_) | Value::Number(_) => Ok(Some(value.to_string())),
        _ => Err(Refusal(format!(
            "`values` has the value {value}: write a number, true, false, a string, or one object of attributes"
        ))),
    }
}
