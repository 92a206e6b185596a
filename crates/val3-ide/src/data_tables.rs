//! A data file as tables: the types that it may declare with their columns, its data with their values as texts, and the
//! findings of the file on their cells.

mod findings;
mod place;
mod rows;
mod types;

pub use findings::{DataFinding, data_findings};
pub(crate) use place::place_of_path;
pub use place::{DataPlace, FieldStep};
pub use types::{ColumnKind, DataColumn, DataType, TypeField};

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, FileStatus, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::parse;
use val3_analysis::xml;
use val3_lang::types::Container;
use val3_syntax::TextRange;

/// The form of a data file.
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
    /// The form of the file.
    pub dialect: Dialect,
    /// Why the file cannot be edited as tables. It may still be shown.
    pub problem: Option<DataProblem>,
    /// The types that the file may declare, and those that it declares.
    pub types: Vec<DataType>,
    /// The data, in the order of the file.
    pub data: Vec<Datum>,
}

/// Why something cannot be done with a data file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataProblem {
    /// A sentence for people.
    pub reason: String,
    /// The place in the file that it is about, if it is about one.
    pub range: Option<TextRange>,
}

/// A variable of a data file, or a field of a value of a user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Datum {
    /// The name.
    pub name: SmolStr,
    /// Other projects may use it.
    pub public: bool,
    /// The type, as the file spells it.
    pub type_name: SmolStr,
    /// An array or a collection.
    pub container: Container,
    /// One number for each dimension, `[1]` for a single value, the number of keys of a collection.
    pub sizes: Vec<u32>,
    /// The range of the name, without quotes.
    pub range: TextRange,
    /// The values that the file writes, and all elements of a collection.
    pub values: Vec<DatumValue>,
}

/// One value of a datum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DatumValue {
    /// `0`, `2,1`, or the key of a collection.
    pub key: String,
    /// The texts of the columns of the type; `None` where the file leaves one out, so that its default holds.
    pub texts: Vec<Option<String>>,
    /// The fields of a value of a user type.
    pub fields: Vec<Datum>,
}

/// The tables of a data file, as a part of `project`; `None` if the file is no data file.
pub fn data_tables(db: &dyn Db, project: Project, file: File) -> Option<DataTables> {
    let parse = parse(db, file);
    let dialect = match xml::root(parse.view()).map(|root| root.name()) {
        Some("Database") => Dialect::New,
        Some("dataList") => Dialect::Old,
        _ => return None,
    };
    let data = rows::data(parse.view(), dialect);
    let types = types::types(db, project, dialect, &data);
    let data = rows::with_columns(data, &types);
    Some(DataTables { dialect, problem: problem(db, file), types, data })
}

/// Why the text of a file cannot be edited as tables.
pub(crate) fn problem(db: &dyn Db, file: File) -> Option<DataProblem> {
    if let FileStatus::Unreadable(reason) = file.status(db) {
        return Some(DataProblem { reason: format!("the file cannot be read: {reason}"), range: None });
    }
    let first = text_faults(db, file).errors.first()?;
    let reason = "the file has a syntax error; correct it in the text first".to_owned();
    Some(DataProblem { reason, range: Some(first.range) })
}
