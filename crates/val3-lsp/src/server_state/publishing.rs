//! Sends findings whose origin is gone, and the faults of configurations.

use super::ServerState;
use crate::convert;
use crate::published::{FindingSource, ProjectFindings};

impl ServerState {
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
