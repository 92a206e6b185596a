//! User page that the pendant shows.

use serde_json::{Value, json};
use val3_machine::controller::Controller;
use val3_machine::screen::{Cell, HtmlCallback, HtmlPage, HtmlValue};

/// Name of the screen, its title and its 14 lines.
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

/// Message `page`, without its time.
pub(crate) fn message(controller: &Controller) -> Value {
    let pendant = &controller.devices.state.pendant;
    let page = pendant.page(pendant.shown());
    json!({
        "kind": "page",
        "screen": pendant.name(pendant.shown()),
        "title": page.map(|page| page.title()),
        "lines": page.map(|page| page.lines().collect::<Vec<_>>()).unwrap_or_default(),
        "modes": page.map(|page| page.cells().map(modes).collect::<Vec<_>>()).unwrap_or_default(),
        "cursor": page.map(|page| [page.cursor().column, page.cursor().row]),
        "popUp": pendant.pop_up().map(|pop_up| pop_up.text.as_str()),
        "html": pendant.shown_html().map(|page| html(page, controller)),
    })
}

/// Bindings of the HTML page: element values and click actions.
fn html(page: &HtmlPage, controller: &Controller) -> Value {
    let value = |bound: &HtmlValue| {
        let value = controller.shown_value(&bound.path);
        json!({ "id": bound.element, "attribute": bound.attribute, "value": value })
    };
    let clicks = page.callbacks.iter().filter(|callback| callback.event == "click");
    let click = |callback: &HtmlCallback| json!({ "id": callback.element, "program": callback.program });
    json!({
        "name": page.name,
        "values": page.values.iter().map(value).collect::<Vec<_>>(),
        "clicks": clicks.map(click).collect::<Vec<_>>(),
    })
}

/// Runs of equal text modes, each with its number of columns.
fn modes(cells: &[Cell]) -> Value {
    let mut runs: Vec<(usize, u8)> = Vec::new();
    for cell in cells {
        let mode = cell.mode.number();
        match runs.last_mut() {
            Some((columns, last)) if *last == mode => *columns += 1,
            _ => runs.push((1, mode)),
        }
    }
    json!(runs)
}
