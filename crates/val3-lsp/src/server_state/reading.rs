//! Reads changed files before anything else is computed.

use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::{Durability, Setter as _};
use tower_lsp::lsp_types::request::WorkspaceDiagnosticRefresh;
use val3_analysis::load::Workspace;
use val3_check::settings::WorkspaceSettings;
use val3_config::ConfigError;
use val3_ide::CheckSettings;

use super::ServerState;
use crate::detached;
use crate::overlay;
use crate::panics::contained;
use crate::parent::project_above;

impl ServerState {
    /// Reads the stale files.
    pub(super) fn bring_up_to_date(&mut self) {
        let Some(stale) = self.stale.take() else { return };
        match contained(|| self.read_again(&|key| stale.contains(key))) {
            Ok(faults) => self.take_faults(faults),
            Err(reason) => {
                self.forget_everything();
                self.complain("reading the workspace", &reason);
            }
        }
        self.checks.all();
    }

    fn read_again(&mut self, mark_stale: &dyn Fn(&str) -> bool) -> Vec<ConfigError> {
        let mut errors = self.refresh(mark_stale);
        let detached = detached::documents(&self.documents, &self.workspace.db, &self.detached);
        if detached != self.detached {
            self.detached = detached;
            errors = self.refresh(mark_stale);
        }
        self.projects = Arc::new(self.workspace.projects.clone());
        errors.extend(self.configure());
        errors
    }

    /// Discards a database that was left in an inconsistent state. The next change creates a new one.
    fn forget_everything(&mut self) {
        self.workspace = Workspace::empty();
        self.projects = Arc::default();
        self.settings = None;
        self.detached.clear();
        self.checks.forget();
    }

    fn refresh(&mut self, mark_stale: &dyn Fn(&str) -> bool) -> Vec<ConfigError> {
        let overlay = overlay::files(&self.documents, &self.detached);
        let folders = &self.session.folders;
        let above = self.documents.iter().filter_map(|document| project_above(&overlay, document, folders));
        let given = self.detached.iter().map(|path| detached::manifest_path(path));
        let asked: Vec<Utf8PathBuf> = folders.iter().cloned().chain(above).chain(given).collect();
        let errors = self.workspace.refresh(&overlay, &asked, mark_stale);
        for (path, reason) in self.workspace.unreadable.clone() {
            self.warn(&format!("cannot read `{path}`: {reason}"));
        }
        errors
    }

    /// Combines the settings of the configurations and the client. While a configuration is faulty, the earlier
    /// settings stay in effect.
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
            self.outbox.request::<WorkspaceDiagnosticRefresh>(());
        }
    }
}
