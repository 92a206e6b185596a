//! A data file as tables: the allowed types with their columns, the data with their values as texts, and the findings
//! of the file by cell.

mod findings;
mod place;
mod rows;
mod types;

pub use findings::{DataFinding, data_findings};
pub(crate) use place::place_of_path;
pub use place::{DataPlace, FieldStep};
pub use types::{ColumnKind, DataColumn, DataType, TypeField};

use std::hash::{Hash as _, Hasher as _};
use std::ops::Range;

use rustc_hash::FxHasher;
use smol_str::SmolStr;
use val3_analysis::db::{Db, File, FileStatus, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::parse;
use val3_analysis::xml::{self, XmlElement};
use val3_lang::types::Container;
use val3_syntax::TextRange;

/// Dialect of a data file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dialect {
    /// `<dataList>` of s5 and s6.
    Old,
    /// `<Database>` of s7 and s8.
    New,
}

/// A data file as tables.
#[derive(Debug, Clone, PartialEq)]
pub struct DataTables {
    /// Dialect of the file.
    pub dialect: Dialect,
    /// Reason why the file cannot be edited as tables. It may still be displayed.
    pub problem: Option<DataProblem>,
    /// Types that the file may declare or does declare.
    pub types: Vec<DataType>,
    /// Data, in the order of the file.
    pub data: Vec<TableVariable>,
}

/// A data file as tables, without data rows.
#[derive(Debug, Clone, PartialEq)]
pub struct DataOutline {
    /// Dialect of the file.
    pub dialect: Dialect,
    /// Reason why the file cannot be edited as tables. It may still be displayed.
    pub problem: Option<DataProblem>,
    /// Types that the file may declare or does declare.
    pub types: Vec<DataType>,
    /// Data, in the order of the file.
    pub data: Vec<DatumSource>,
}

/// A variable in the text of a data file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DatumSource {
    /// Range of the name, without quotes.
    pub name: TextRange,
    /// Text hash. With the same types, the same text yields the same rows.
    pub fingerprint: u64,
}

/// Reason why an operation on a data file is impossible.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataProblem {
    /// Reason as a sentence for users.
    pub reason: String,
    /// Range in the file to which it refers, if there is one.
    pub range: Option<TextRange>,
}

/// A variable of a data file, or a field of a user type's value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableVariable {
    /// Name.
    pub name: SmolStr,
    /// Whether other projects may use it.
    pub public: bool,
    /// Type name as spelled in the file.
    pub type_name: SmolStr,
    /// Array or collection.
    pub container: Container,
    /// Sizes by dimension; `[1]` for a single value; the number of keys for a collection.
    pub sizes: Vec<u32>,
    /// Range of the name, without quotes.
    pub range: TextRange,
    /// Values in the file; all elements for a collection.
    pub values: Vec<DatumValue>,
}

/// One value of a datum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DatumValue {
    /// `0`, `2,1`, or the key of a collection.
    pub key: String,
    /// Texts of the type's columns; `None` if the file omits the attribute, so that its default is in effect.
    pub texts: Vec<Option<String>>,
    /// Fields of a user type's value.
    pub fields: Vec<TableVariable>,
}

/// Tables of a data file, as part of `project`; `None` if the file is no data file.
pub fn data_tables(db: &dyn Db, project: Project, file: File) -> Option<DataTables> {
    let DataOutline { dialect, problem, types, data } = data_outline(db, project, file)?;
    let data = data_rows(db, file, &types, 0..data.len());
    Some(DataTables { dialect, problem, types, data })
}

/// Tables of a data file without rows, as part of `project`; `None` if the file is no data file.
pub fn data_outline(db: &dyn Db, project: Project, file: File) -> Option<DataOutline> {
    let parse = parse(db, file);
    let dialect = match xml::root(parse.view()).map(|root| root.name()) {
        Some("Database") => Dialect::New,
        Some("dataList") => Dialect::Old,
        _ => return None,
    };
    let text: &str = file.text(db);
    let names = rows::elements(parse.view()).map(|(element, _)| val3_data::type_name(element));
    let types = types::types(db, project, dialect, names);
    let elements = rows::elements(parse.view());
    let data = elements.map(|(element, name)| DatumSource { name, fingerprint: fingerprint(text, element) }).collect();
    Some(DataOutline { dialect, problem: problem(db, file), types, data })
}

/// Hash of an element's text.
fn fingerprint(text: &str, element: XmlElement<'_>) -> u64 {
    let mut hasher = FxHasher::default();
    text.get(Range::<usize>::from(element.view().range())).hash(&mut hasher);
    hasher.finish()
}

/// Rows of some data in a file, by their index in [`DataOutline::data`].
pub fn data_rows(db: &dyn Db, file: File, types: &[DataType], numbers: Range<usize>) -> Vec<TableVariable> {
    let parse = parse(db, file);
    let elements = rows::elements(parse.view()).skip(numbers.start).take(numbers.len());
    elements.map(|(element, name)| rows::row(element, name, types)).collect()
}

/// Reason why the text of a file cannot be edited as tables; `None` if it can.
pub(crate) fn problem(db: &dyn Db, file: File) -> Option<DataProblem> {
    if let FileStatus::Unreadable(reason) = file.status(db) {
        return Some(DataProblem { reason: format!("the file cannot be read: {reason}"), range: None });
    }
    let first = text_faults(db, file).errors.first()?;
    let reason = "the file has a syntax error; correct it in the text first".to_owned();
    Some(DataProblem { reason, range: Some(first.range) })
}
