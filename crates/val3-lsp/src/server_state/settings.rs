//! Editor settings.

use std::sync::Arc;

use serde_json::json;
use tower_lsp::lsp_types::notification::{DidChangeConfiguration, Notification as _};
use tower_lsp::lsp_types::request::{
    CodeLensRefresh, InlayHintRefreshRequest, RegisterCapability, WorkspaceConfiguration,
};
use tower_lsp::lsp_types::{ConfigurationItem, ConfigurationParams, Registration, RegistrationParams};

use super::ServerState;
use crate::options::{Options, SECTION};

impl ServerState {
    /// Registers for changes of settings, if the client supports registration.
    pub(crate) fn register_for_settings(&self) {
        if self.session.client.reports_settings {
            let registration = Registration {
                id: "settings".to_owned(),
                method: DidChangeConfiguration::METHOD.to_owned(),
                register_options: Some(json!({ "section": SECTION })),
            };
            self.outbox.request::<RegisterCapability>(RegistrationParams { registrations: vec![registration] });
        }
    }

    /// Requests the user's settings, if the client supports it.
    pub(crate) fn ask_for_settings(&mut self) {
        if !self.session.client.has_settings {
            return;
        }
        let item = ConfigurationItem { scope_uri: None, section: Some(SECTION.to_owned()) };
        self.ask_client::<WorkspaceConfiguration>(ConfigurationParams { items: vec![item] }, |server, settings| {
            if let Some(settings) = settings.and_then(|settings| settings.into_iter().next()).filter(|it| !it.is_null())
            {
                let (options, faults) = Options::read(&settings);
                server.set_options(options, &faults);
            }
        });
    }

    /// Applies the editor's settings, and warns about invalid ones, which `faults` describes.
    pub(crate) fn set_options(&mut self, options: Options, faults: &[String]) {
        faults.iter().for_each(|fault| self.warn(fault));
        if options != self.session.options {
            // The delivery of findings was agreed in the handshake.
            let delivery = self.session.options.check.delivery;
            let session = Arc::make_mut(&mut self.session);
            session.options = options;
            session.options.check.delivery = delivery;
            self.settings_are_stale();
            if self.session.client.refreshes_hints {
                self.outbox.request::<InlayHintRefreshRequest>(());
            }
            if self.session.client.refreshes_lenses {
                self.outbox.request::<CodeLensRefresh>(());
            }
        }
    }
}
