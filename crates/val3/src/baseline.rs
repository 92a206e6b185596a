//! Known findings: reading, writing and pruning baselines.

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use val3_analysis::db::{Database, File, Project};
use val3_analysis::load::{LoadError, Workspace};
use val3_check::CheckUnit;
use val3_check::baseline::Baseline;
use val3_check::diagnostic::Diagnostic;
use val3_check::fingerprint::Fingerprint;
use val3_check::settings::RuleSelection;
use val3_config::ConfigFile;
use val3_files::{FileClass, Unreadable};
use val3_session::{SessionError, json_fault};

use crate::output::file_kind::OutputFileKind;
use crate::output::to_file;
use crate::paths::{Paths, relative};
use crate::unread::is_unreadable;
use crate::user_error::UserError;

/// Use of baselines in a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Mode {
    /// Omits known findings.
    #[default]
    Use,
    /// Writes all findings to the baselines.
    Write,
    /// As [`Mode::Use`], and removes known findings that no longer occur.
    Prune,
}

/// Effect of the baselines on a check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct BaselineResult {
    /// Number of omitted known findings.
    pub(crate) known: usize,
    /// Number of known findings that no longer occur.
    pub(crate) gone: usize,
    /// Displayed paths of the written files, with their numbers of findings.
    pub(crate) written: Vec<(String, usize)>,
}

/// Comparison of a check's findings with the baselines.
pub(crate) struct KnownFindings<'a> {
    /// All loaded files.
    pub(crate) workspace: &'a Workspace,
    /// The checked units.
    pub(crate) units: &'a [CheckUnit],
    /// Rule selection of the command line.
    pub(crate) selection: &'a RuleSelection,
    /// Path display.
    pub(crate) paths: &'a Paths,
}

impl KnownFindings<'_> {
    /// Removes the known findings from `diagnostics`. A baseline named on the command line (`named`, absolute path)
    /// applies to all applications. Otherwise each `val3.toml` names its application's baseline.
    pub(crate) fn apply(
        &self,
        named: Option<&Utf8Path>,
        mode: Mode,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Result<BaselineResult, UserError> {
        let baselines = self.baselines(named);
        if baselines.is_empty() && mode != Mode::Use {
            let help = "name one with --baseline FILE, or with `baseline` in val3.toml";
            return Err(UserError::new("no baseline file is given").with_help(help));
        }
        let mut outcome = BaselineResult::default();
        for (path, (manifests, named_by)) in baselines {
            let file = BaselineFile { known: self, path, named_by, mode };
            let all = std::mem::take(diagnostics).into_iter();
            let (own, others) = all.partition(|diagnostic| is_about(diagnostic, &manifests));
            *diagnostics = others;
            diagnostics.extend(file.apply(own, &mut outcome)?);
        }
        Ok(outcome)
    }

    fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Baselines, each with the project files to which it applies and the `val3.toml` that names it.
    fn baselines(&self, named: Option<&Utf8Path>) -> BTreeMap<Utf8PathBuf, (FxHashSet<File>, Option<&ConfigFile>)> {
        let mut baselines: BTreeMap<Utf8PathBuf, (FxHashSet<File>, Option<&ConfigFile>)> = BTreeMap::new();
        for project in &self.workspace.projects {
            let configured = || self.configured(*project).map(|(path, file)| (path, Some(file)));
            if let Some((path, file)) = named.map(|path| (path.to_owned(), None)).or_else(configured) {
                let (manifests, by) = baselines.entry(path).or_default();
                manifests.insert(project.manifest(self.db()));
                *by = file;
            }
        }
        baselines
    }

    fn configured(&self, project: Project) -> Option<(Utf8PathBuf, &ConfigFile)> {
        let file = project.configuration(self.db())?.file(self.db());
        file.config.baseline.as_ref().map(|path| (file.folder().join(path), file))
    }
}

/// Whether the finding belongs to an application with one of these project files. Findings about unreadable files are
/// never known.
fn is_about(finding: &Diagnostic, manifests: &FxHashSet<File>) -> bool {
    !is_unreadable(finding) && finding.application.is_some_and(|manifest| manifests.contains(&manifest))
}

/// One baseline file.
struct BaselineFile<'a> {
    known: &'a KnownFindings<'a>,
    path: Utf8PathBuf,
    /// The `val3.toml` that names the baseline.
    named_by: Option<&'a ConfigFile>,
    mode: Mode,
}

impl BaselineFile<'_> {
    /// Returns the new findings.
    fn apply(&self, mut found: Vec<Diagnostic>, outcome: &mut BaselineResult) -> Result<Vec<Diagnostic>, UserError> {
        let mut baseline = self.read()?;
        // A file that two applications share is checked twice.
        let mut seen = FxHashSet::default();
        found.retain(|it| seen.insert((it.place, it.rule.code, it.message.clone())));
        let fingerprints: Vec<Fingerprint> = found.iter().map(|diagnostic| self.fingerprint(diagnostic)).collect();
        let files = self.checked_files();
        let is_gone = |file: &str| !files.contains(file) && self.is_gone(file);
        let mut verdict = baseline.compare(&fingerprints, is_gone);
        verdict.gone.retain(|known| self.was_checked(known, &files));
        if self.mode == Mode::Write {
            verdict.new.fill(false);
        }
        if self.mode == Mode::Use {
            outcome.gone += verdict.gone.count();
        } else {
            baseline.retain(|known| !self.was_checked(known, &files));
            let known = fingerprints.into_iter().zip(&verdict.new).filter(|(_, new)| !**new);
            baseline.extend(known.map(|(fingerprint, _)| fingerprint));
            self.write(&baseline)?;
            outcome.written.push((self.shown(), baseline.count()));
        }
        outcome.known += verdict.new.iter().filter(|new| !**new).count();
        let new = found.into_iter().zip(verdict.new).filter(|(_, new)| *new);
        Ok(new.map(|(diagnostic, _)| diagnostic).collect())
    }

    fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(Utf8Path::new(""))
    }

    fn fingerprint(&self, diagnostic: &Diagnostic) -> Fingerprint {
        let db = self.known.db();
        Fingerprint::new(db, diagnostic, |file| relative(self.folder(), file.path(db)))
    }

    /// Whether this check would have found the known finding again: it has checked the file with the rule.
    fn was_checked(&self, known: &Fingerprint, files: &BTreeSet<String>) -> bool {
        let RuleSelection { only, never, .. } = self.known.selection;
        let code = known.rule.as_str();
        let wanted = only.as_ref().is_none_or(|only| only.contains(code)) && !never.contains(code);
        wanted && (files.contains(&known.file) || self.is_gone(&known.file))
    }

    fn is_gone(&self, file: &str) -> bool {
        // The file may exist in a folder that cannot be read.
        self.folder().join(file).try_exists().is_ok_and(|exists| !exists)
    }

    fn checked_files(&self) -> BTreeSet<String> {
        let db = self.known.db();
        self.known.units.iter().map(|unit| relative(self.folder(), unit.file(db).path(db))).collect()
    }

    fn read(&self) -> Result<Baseline, UserError> {
        let text = match val3_files::read_text(&self.path, FileClass::Record) {
            Ok(text) => text,
            Err(Unreadable::Missing) if self.mode == Mode::Write => {
                return Ok(Baseline::default());
            }
            Err(reason) => {
                let message = format!("cannot read the baseline `{}`: {reason}", self.shown());
                return Err(self.refused(message, "`val3 check --write-baseline` writes it"));
            }
        };
        serde_json::from_str(&text).map_err(|error| {
            let reason = json_fault(&error, error.line());
            let message = format!("the baseline `{}` cannot be read: {reason}", self.shown());
            self.refused(message, "remove the file, and write a new one with `val3 check --write-baseline`")
        })
    }

    /// Error for a baseline that cannot be read, with the line that names it.
    fn refused(&self, message: String, help: &str) -> UserError {
        match self.named_by {
            Some(file) => {
                let fault = file.fault("baseline", message, help.to_owned());
                SessionError::Load(LoadError::Configuration(vec![fault])).into()
            }
            None => UserError::new(message).with_help(help),
        }
    }

    fn write(&self, baseline: &Baseline) -> Result<(), UserError> {
        to_file(&self.path, OutputFileKind::Json, |out| {
            serde_json::to_writer_pretty(&mut *out, baseline)?;
            writeln!(out)
        })
    }

    fn shown(&self) -> String {
        self.known.paths.shown(&self.path)
    }
}
