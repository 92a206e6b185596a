//! User page of the pendant, for requests and events `val3/…`.

use schemars::JsonSchema;
use serde::Serialize;
use val3_machine::controller::Controller;

/// Shown user page.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct ShownUserPage {
    /// Name of the page.
    screen: String,
    /// Title of the page.
    title: Option<String>,
    /// The 14 lines.
    lines: Vec<String>,
}

impl ShownUserPage {
    /// Returns the present page.
    pub(crate) fn new(controller: &Controller) -> Self {
        let pendant = &controller.devices.state.pendant;
        let page = pendant.page(pendant.shown());
        Self {
            screen: pendant.name(pendant.shown()).to_owned(),
            title: page.map(|page| page.title().to_owned()),
            lines: page.map(|page| page.lines().collect()).unwrap_or_default(),
        }
    }
}
