//! `val3/data`, `val3/editData` and `val3/dataPoses`: data files for editors that show them as tables.

mod changes;
mod convert;
mod edits;
mod messages;

pub(crate) use changes::KeptTables;
use messages::*;
use rustc_hash::FxHashSet;
use tower_lsp::lsp_types::request::Request;
use val3_analysis::db::File;
use val3_check::diagnostic::Diagnostic;
use val3_ide::SourceChange;

use crate::convert::workspace_edit;
use crate::snapshot::{Refusal, Snapshot};

/// Request for the tables of a data file, or for the changes since an earlier response.
pub(crate) enum DataRequest {}

impl Request for DataRequest {
    type Params = DataParams;
    type Result = Option<DataResult>;
    const METHOD: &'static str = "val3/data";
}

/// Request for the text edits that implement edits of the tables.
pub(crate) enum EditData {}

impl Request for EditData {
    type Params = EditDataParams;
    type Result = EditDataResult;
    const METHOD: &'static str = "val3/editData";
}

/// Request for the poses of points, frames and tools.
pub(crate) enum DataPoses {}

impl Request for DataPoses {
    type Params = DataPosesParams;
    type Result = Vec<DataPose>;
    const METHOD: &'static str = "val3/dataPoses";
}

pub(crate) fn data(snapshot: &Snapshot, params: &DataParams) -> Result<Option<DataResult>, Refusal> {
    let file = snapshot.file(&params.uri)?;
    let owner = val3_ide::owner(snapshot.db(), file);
    let Some(tables) = owner.and_then(|project| val3_ide::data_outline(snapshot.db(), project, file)) else {
        return Ok(None);
    };
    let mut present = KeptTables::new(&snapshot.lines(file), &tables);
    let before = snapshot.documents.kept_tables(&params.uri);
    let before = before
        .filter(|before| params.previous_result_id.as_ref() == Some(&before.id()) && before.types == present.types);
    let result = match before {
        Some(before) => DataResult::Changes(changes(snapshot, file, params, &tables, &before, &mut present)),
        None => DataResult::Tables(whole(snapshot, file, tables, &mut present)),
    };
    snapshot.documents.keep_tables(&params.uri, present);
    Ok(Some(result))
}

fn whole(snapshot: &Snapshot, file: File, tables: val3_ide::DataOutline, present: &mut KeptTables) -> DataTables {
    let lines = snapshot.lines(file);
    let findings = cell_findings(snapshot, file);
    present.set_findings(&findings);
    let rows = val3_ide::data_rows(snapshot.db(), file, &tables.types, 0..tables.data.len());
    let data = convert::data(&lines, rows);
    present.set_rows(&data);
    DataTables {
        result_id: present.id(),
        version: snapshot.version(file),
        dialect: convert::dialect(tables.dialect),
        problem: tables.problem.map(|problem| convert::in_words(&lines, &problem)),
        types: convert::data_types(tables.types),
        data,
        findings,
    }
}

fn changes(
    snapshot: &Snapshot,
    file: File,
    params: &DataParams,
    tables: &val3_ide::DataOutline,
    before: &KeptTables,
    present: &mut KeptTables,
) -> DataChanges {
    let lines = snapshot.lines(file);
    let (difference, line_shift) = present.changed_data(before);
    let rows = val3_ide::data_rows(snapshot.db(), file, &tables.types, difference.new.clone());
    let mut data = convert::data(&lines, rows);
    let values = present.change_rows(before, &difference, &mut data);
    let findings = if params.without_findings {
        present.keep_findings(before);
        None
    } else {
        let mut findings = cell_findings(snapshot, file);
        present.set_findings(&findings);
        let difference = present.changed_findings(before);
        findings.truncate(difference.new.end);
        Some(difference.replace_with(findings.split_off(difference.new.start)))
    };
    DataChanges {
        result_id: present.id(),
        version: snapshot.version(file),
        problem: tables.problem.as_ref().map(|problem| convert::in_words(&lines, problem)),
        data: difference.replace_with(data),
        values,
        line_shift,
        findings,
    }
}

/// Findings of a file, by table cell.
fn cell_findings(snapshot: &Snapshot, file: File) -> Vec<DataFinding> {
    convert::findings(snapshot, val3_ide::data_findings(snapshot.db(), file, findings(snapshot, file)))
}

/// Findings in a file. Findings reported by several projects that share the file are returned once.
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

/// Findings that a change adds to a file.
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
