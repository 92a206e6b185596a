//! Publishes configuration faults, and removes the findings of removed projects.

use super::ServerState;
use crate::convert;
use crate::published::{FindingSource, ProjectFindings};

impl ServerState {
    /// Clears the findings of projects that no longer exist.
    pub(crate) fn publish_gone_projects(&mut self) {
        self.published.keep(&self.projects, &self.documents, &self.outbox);
    }

    /// Publishes configuration faults, unless the client pulls them. Many pulling clients pull only for open documents,
    /// and a configuration is seldom open.
    pub(crate) fn publish_configurations(&mut self) {
        let is_asked = self.asks_for_configurations && self.session.is_asked_for_findings();
        let files = if is_asked { Vec::new() } else { convert::configuration_faults(&self.snapshot()) };
        let found = ProjectFindings { finder: FindingSource::Configuration, files };
        self.published.project(found, &self.documents, &self.outbox);
    }

    /// Records that the client pulls configuration faults.
    pub(crate) fn configurations_are_asked_for(&mut self) {
        if !std::mem::replace(&mut self.asks_for_configurations, true) {
            self.publish_configurations();
        }
    }
}
