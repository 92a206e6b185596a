//! `cell.toml`: things around the arm of an application. Frames and tools that carry them are data.

mod faults;
mod links;
mod loaded;
mod shared_scene;
mod signals;

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_cell::CellFile;
use val3_config::{TableFile, table_strings};
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;
use val3_syntax::{TextRange, TextSize};

use crate::db::{Db, File, Project};
use crate::items::project::{fields, items};
use crate::occurrences::{Occurrence, Symbol, Usage, path_names};
use crate::ty::Base;

pub use self::faults::cell_faults;
pub use self::shared_scene::{SharedScene, scene};
pub use self::signals::signal_paths;

/// Name of the file that is used without a setting.
pub const FILE_NAME: &str = "cell.toml";

/// Keys whose values are data paths: the carrier of a thing, and a tool.
pub const DATA_KEYS: [&str; 2] = ["in", "tool"];

/// A data path in a `cell.toml`, or the name of another carrier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CarrierName {
    /// The path, for example `tSlots[1].fIn`.
    pub text: SmolStr,
    /// Range between the quotes.
    pub range: TextRange,
}

/// Returns the names of carriers and tools in a `cell.toml`, in source order.
#[salsa::tracked]
pub fn carrier_names(db: &dyn Db, file: File) -> Vec<CarrierName> {
    let strings = table_strings(file.text(db)).into_iter();
    let names = strings.filter(|string| DATA_KEYS.contains(&string.key.rsplit('.').next().unwrap_or_default()));
    let size = |at: usize| TextSize::try_from(at).unwrap_or_default();
    names
        .map(|string| CarrierName {
            text: string.text.into(),
            range: TextRange::new(size(string.range.start), size(string.range.end)),
        })
        .collect()
}

/// Returns the paths of the meshes in the text of a `cell.toml`, each once; empty if the text has errors.
pub(crate) fn mesh_names(text: &str) -> Vec<Utf8PathBuf> {
    let table = TableFile::<CellFile>::parse(Utf8Path::new(FILE_NAME), text).ok();
    let names = table.iter().flat_map(|table| table.content.meshes());
    let mut names: Vec<Utf8PathBuf> = names.map(Utf8Path::to_owned).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// Returns the names of an application's data in its `cell.toml`.
pub(crate) fn occurrences(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let paths = carrier_names(db, file).iter();
    let names = paths.flat_map(|path| {
        let names = path_names(db, project, &path.text).into_iter();
        names.map(|(range, symbol)| Occurrence { range: range + path.range.start(), symbol, usage: Usage::Read })
    });
    names.collect()
}

/// Returns the type of the data to which a path leads in a project; `None` if a name of the path is unknown.
pub fn path_type(db: &dyn Db, project: Project, path: &str) -> Option<BaseType> {
    let own_path = DataPath::new(path).split_library().map_or(DataPath::new(path), |(_, item)| item);
    let steps = own_path.steps().count();
    let names = path_names(db, project, path);
    let data = names.iter().filter(|(_, symbol)| matches!(symbol, Symbol::Data(..)));
    let (_, last) = names.last().filter(|_| data.count() == steps)?;
    let Symbol::Data(owner, name) = last else { return None };
    let item = items(db, *owner).data.get(name).or_else(|| fields(db, *owner).get(name))?;
    match item.base {
        Base::Builtin(ty, _) => Some(ty),
        _ => None,
    }
}
