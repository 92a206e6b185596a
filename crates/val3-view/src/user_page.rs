//! User page that the pendant displays.

use serde_json::{Value, json};
use val3_machine::controller::Controller;
use val3_machine::screen::{self, ScreenCell};

use crate::wire::{HtmlClick, HtmlPage, HtmlValue, ModeRun, PageMessage};

/// Returns the name of the screen, its title and its 14 lines.
#[must_use]
pub fn user_page(controller: &Controller) -> Value {
    let pendant = &controller.devices.state.pendant;
    let page = pendant.page(pendant.shown());
    json!({
        "screen": pendant.name(pendant.shown()),
        "title": page.map(|page| page.title()),
        "lines": page.map(|page| page.lines().collect::<Vec<_>>()).unwrap_or_default(),
    })
}

/// Message `page` at a time in seconds.
pub(crate) fn message(t: f64, controller: &Controller) -> PageMessage {
    let pendant = &controller.devices.state.pendant;
    let page = pendant.page(pendant.shown());
    PageMessage {
        t,
        screen: pendant.name(pendant.shown()).to_owned(),
        title: page.map(|page| page.title().to_owned()),
        lines: page.map(|page| page.lines().collect()).unwrap_or_default(),
        modes: page.map(|page| page.cells().map(modes).collect()).unwrap_or_default(),
        cursor: page.map(|page| [page.cursor().column, page.cursor().row]),
        pop_up: pendant.pop_up().map(|pop_up| pop_up.text.clone()),
        html: pendant.shown_html().map(|page| html(page, controller)),
    }
}

/// Bindings of the HTML page: element values and click actions.
fn html(page: &screen::HtmlPage, controller: &Controller) -> HtmlPage {
    let values = page.values.iter().map(|bound| HtmlValue {
        id: bound.element.clone(),
        attribute: bound.attribute.clone(),
        value: controller.shown_value(&bound.path),
    });
    let clicks = page.callbacks.iter().filter(|callback| callback.event == "click");
    let clicks = clicks.map(|callback| HtmlClick { id: callback.element.clone(), program: callback.program.clone() });
    HtmlPage { name: page.name.clone(), values: values.collect(), clicks: clicks.collect() }
}

/// Runs of equal text modes, each with its number of columns.
fn modes(cells: &[ScreenCell]) -> Vec<ModeRun> {
    let mut runs: Vec<ModeRun> = Vec::new();
    for cell in cells {
        let mode = cell.mode.number();
        match runs.last_mut() {
            Some((columns, last)) if *last == mode => *columns += 1,
            _ => runs.push((1, mode)),
        }
    }
    runs
}
