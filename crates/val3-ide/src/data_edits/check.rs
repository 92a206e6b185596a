//! Findings that an edit of a data file would add.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use val3_analysis::db::File;
use val3_check::fix::TrialWorkspace as _;
use val3_syntax::TextEdit;

use crate::assists::FixContext;
use crate::data_tables::{DataFinding, DataPlace, data_findings};
use crate::edit::SourceChange;
use crate::owner::projects_of;
use crate::trial::TrialProjects;

/// Findings of a data file after `change` that are not in `before`. Findings in other files are omitted.
pub fn added_data_findings(
    context: FixContext<'_>,
    file: File,
    change: &SourceChange,
    before: &[DataFinding],
) -> Vec<DataFinding> {
    let db = context.db;
    let edits = change.edits.iter().map(|edit| TextEdit { range: edit.range, text: edit.text.clone() });
    let text: Arc<str> = TextEdit::apply_all(file.text(db), &edits.collect::<Vec<_>>()).into();
    let projects = projects_of(db, file).iter().copied();
    let mut trial = TrialProjects::of(db, context.system, projects, context.check_cancelled);
    trial.set_texts([(file.path(db).as_path(), &text)].into_iter());
    let Some((changed, found)) = trial.data_findings(file.path(db)) else { return Vec::new() };
    let mut known: FxHashMap<Identity, usize> = FxHashMap::default();
    for finding in before {
        *known.entry(identity(finding)).or_default() += 1;
    }
    let mut added = data_findings(trial.db(), changed, found);
    added.retain(|finding| match known.get_mut(&identity(finding)) {
        Some(count) if *count > 0 => {
            *count -= 1;
            false
        }
        _ => true,
    });
    // The files of the trial database do not exist for the caller.
    for finding in &mut added {
        finding.diagnostic.place.file = file;
        finding.diagnostic.related.clear();
        finding.diagnostic.fix = None;
        finding.diagnostic.application = None;
    }
    added
}

/// Identity of a finding across texts: place, column, rule and message.
type Identity = (DataPlace, Option<String>, &'static str, String);

fn identity(finding: &DataFinding) -> Identity {
    let DataFinding { place, column, diagnostic } = finding;
    (place.clone(), column.clone(), diagnostic.rule.code, diagnostic.message.clone())
}
