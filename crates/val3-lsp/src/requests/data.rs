//! `val3/data`, `val3/editData` and `val3/dataPoses`: data files for editors that show them as tables.

mod convert;
mod edits;
mod messages;

use messages::{DataFinding, DataParams, DataPose, DataPosesParams, DataTables, EditDataParams, EditDataResult};
use rustc_hash::FxHashSet;
use tower_lsp::lsp_types::request::Request;
use val3_analysis::db::File;
use val3_check::diagnostic::Diagnostic;
use val3_ide::SourceChange;

use crate::convert::workspace_edit;
use crate::snapshot::{Refusal, Snapshot};

/// The tables of a data file.
pub(crate) enum Data {}

impl Request for Data {
    type Params = DataParams;
    type Result = Option<DataTables>;
    const METHOD: &'static str = "val3/data";
}

/// The edits of a data file that a change of its tables means.
pub(crate) enum EditData {}

impl Request for EditData {
    type Params = EditDataParams;
    type Result = EditDataResult;
    const METHOD: &'static str = "val3/editData";
}

/// The places of points, frames and tools.
pub(crate) enum DataPoses {}

impl Request for DataPoses {
    type Params = DataPosesParams;
    type Result = Vec<DataPose>;
    const METHOD: &'static str = "val3/dataPoses";
}

pub(crate) fn data(snapshot: &Snapshot, params: &DataParams) -> Result<Option<DataTables>, Refusal> {
    let file = snapshot.file(&params.uri)?;
    let db = snapshot.db();
    let owner = val3_ide::owner(db, file);
    let Some(tables) = owner.and_then(|project| val3_ide::data_tables(db, project, file)) else { return Ok(None) };
    let mut tables = convert::tables(snapshot, file, tables);
    tables.findings = convert::findings(snapshot, val3_ide::data_findings(db, file, findings(snapshot, file)));
    Ok(Some(tables))
}

/// The findings in a file. Projects that share it have most of them in common.
fn findings(snapshot: &Snapshot, file: File) -> Vec<Diagnostic> {
    let mut known = FxHashSet::default();
    let found = snapshot.findings(file).flatten().filter(|found| found.place.file == file);
    found.filter(|found| known.insert((found.place.range, found.message.clone()))).collect()
}

pub(crate) fn edit_data(snapshot: &Snapshot, params: &EditDataParams) -> Result<EditDataResult, Refusal> {
    let file = snapshot.file(&params.uri)?;
    if snapshot.version(file) != params.version {
        return Err(Refusal::Outdated);
    }
    let db = snapshot.db();
    let owner = val3_ide::owner(db, file).ok_or(Refusal::Unknown)?;
    let wanted: Vec<val3_ide::DataEdit> = params.edits.iter().map(edits::edit).collect();
    match val3_ide::data_edits(db, owner, file, &wanted) {
        Err(problem) => {
            let refused = Some(convert::in_words(&snapshot.lines(file), &problem));
            Ok(EditDataResult { refused, ..EditDataResult::default() })
        }
        Ok(change) if change.is_empty() => Ok(EditDataResult::default()),
        Ok(change) => {
            let findings = if params.check { added(snapshot, file, &change) } else { Vec::new() };
            Ok(EditDataResult { edit: Some(workspace_edit(snapshot, &change)?), refused: None, findings })
        }
    }
}

/// The findings that a change adds to a file.
fn added(snapshot: &Snapshot, file: File, change: &SourceChange) -> Vec<DataFinding> {
    let before = val3_ide::data_findings(snapshot.db(), file, findings(snapshot, file));
    let added = snapshot.with_fixes(|context| val3_ide::added_data_findings(context, file, change, &before));
    convert::findings(snapshot, added)
}

pub(crate) fn data_poses(snapshot: &Snapshot, params: &DataPosesParams) -> Result<Vec<DataPose>, Refusal> {
    let file = snapshot.file(&params.uri)?;
    let owner = val3_ide::owner(snapshot.db(), file).ok_or(Refusal::Unknown)?;
    let found = val3_ide::data_poses(snapshot.db(), owner, file, &params.names);
    Ok(found.into_iter().map(convert::pose).collect())
}
