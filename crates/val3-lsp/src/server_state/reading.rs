//! Reads changed files again before anything else is computed.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use salsa::{Durability, Setter as _};
use tower_lsp::lsp_types::request::WorkspaceDiagnosticRefresh;
use val3_analysis::db::path_key;
use val3_analysis::load::Workspace;
use val3_analysis::paths::normalise;
use val3_check::settings::WorkspaceSettings;
use val3_config::ConfigError;
use val3_ide::CheckSettings;

use super::ServerState;
use crate::convert;
use crate::detached;
use crate::overlay;
use crate::panics::contained;
use crate::parent::project_above;
use crate::published::{FindingSource, ProjectFindings};

/// The files that have to be read again.
pub(super) enum Stale {
    /// Path keys of files, and of folders with everything in them.
    Paths(FxHashSet<String>),
    Everything,
}

impl ServerState {
    /// A file, or everything in a folder, has to be read again.
    pub(crate) fn is_stale(&mut self, path: &Utf8Path) {
        let key = path_key(normalise(path).as_str());
        match &mut self.stale {
            Some(Stale::Everything) => {}
            Some(Stale::Paths(paths)) => drop(paths.insert(key)),
            None => self.stale = Some(Stale::Paths(FxHashSet::from_iter([key]))),
        }
    }

    /// Everything has to be read again.
    pub(crate) fn all_is_stale(&mut self) {
        self.stale = Some(Stale::Everything);
    }

    /// The user changed the settings.
    pub(crate) fn settings_are_stale(&mut self) {
        self.stale.get_or_insert_with(|| Stale::Paths(FxHashSet::default()));
    }

    /// Reads what has to be read again.
    pub(crate) fn bring_up_to_date(&mut self) {
        let Some(stale) = self.stale.take() else { return };
        let is_stale = |key: &str| match &stale {
            Stale::Paths(paths) => Utf8Path::new(key).ancestors().any(|path| paths.contains(path.as_str())),
            Stale::Everything => true,
        };
        match contained(|| self.read_again(&is_stale)) {
            Ok(faults) => self.take_faults(faults),
            Err(reason) => {
                self.forget_everything();
                self.complain("reading the workspace", &reason);
            }
        }
        self.checks.all();
    }

    fn read_again(&mut self, is_stale: &dyn Fn(&str) -> bool) -> Vec<ConfigError> {
        let mut errors = self.refresh(is_stale);
        let detached = detached::documents(&self.documents, &self.workspace.db, &self.detached);
        if detached != self.detached {
            self.detached = detached;
            errors = self.refresh(is_stale);
        }
        self.projects = Arc::new(self.workspace.projects.clone());
        errors.extend(self.configure());
        errors
    }

    /// A database that was left half changed cannot be asked. The next change begins with a new one.
    fn forget_everything(&mut self) {
        self.workspace = Workspace::empty();
        self.projects = Arc::default();
        self.settings = None;
        self.detached.clear();
        self.checks.forget();
    }

    fn refresh(&mut self, is_stale: &dyn Fn(&str) -> bool) -> Vec<ConfigError> {
        let overlay = overlay::files(&self.documents, &self.detached);
        let folders = &self.session.folders;
        let above = self.documents.iter().filter_map(|document| project_above(&overlay, document, folders));
        let given = self.detached.iter().map(|path| detached::manifest_path(path));
        let asked: Vec<Utf8PathBuf> = folders.iter().cloned().chain(above).chain(given).collect();
        self.workspace.refresh(&overlay, &asked, is_stale)
    }

    /// The settings of the configurations and of the client. A faulty configuration keeps its earlier settings.
    fn configure(&mut self) -> Vec<ConfigError> {
        let db = &mut self.workspace.db;
        let found = WorkspaceSettings::new(db, &self.projects, &self.session.options.selection());
        let (settings, errors) = match found {
            Ok(settings) => (settings, Vec::new()),
            Err(errors) if self.settings.is_some() => return errors,
            Err(errors) => (WorkspaceSettings::default(), errors),
        };
        match self.settings {
            None => self.settings = Some(CheckSettings::builder(settings).durability(Durability::MEDIUM).new(db)),
            Some(known) if *known.settings(db) != settings => _ = known.set_settings(db).to(settings),
            Some(_) => {}
        }
        errors
    }

    fn take_faults(&mut self, faults: Vec<ConfigError>) {
        if *self.faults == faults {
            return;
        }
        self.faults = Arc::new(faults);
        if self.asks_for_configurations && self.session.client.pulls_again {
            self.outbox.ask::<WorkspaceDiagnosticRefresh>((), |_, _| {});
        }
    }

    /// Sends that projects which are gone have no findings.
    pub(crate) fn publish_gone_projects(&mut self) {
        self.published.keep(&self.projects, &self.documents, &self.outbox);
    }

    /// Sends the faults of configurations, unless the client asks for them. Many clients that ask for findings do so
    /// for the documents that are open, and a configuration seldom is.
    pub(crate) fn publish_configurations(&mut self) {
        let is_asked = self.asks_for_configurations && self.session.is_asked_for_findings();
        let files = if is_asked { Vec::new() } else { convert::configuration_faults(&self.snapshot()) };
        let found = ProjectFindings { finder: FindingSource::Configuration, files };
        self.published.project(found, &self.documents, &self.outbox);
    }

    /// The client asks for the faults of configurations.
    pub(crate) fn configurations_are_asked_for(&mut self) {
        if !std::mem::replace(&mut self.asks_for_configurations, true) {
            self.publish_configurations();
        }
    }
}
