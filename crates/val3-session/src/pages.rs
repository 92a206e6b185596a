//! HTML user pages (s8): the files in an application's folder `interface`.

use val3_analysis::db::{Database, Project};
use val3_analysis::pages::{self, BINDINGS, Bindings, BoundName, bindings, page_name};
use val3_lang::tasks;
use val3_machine::screen::{HtmlCallback, HtmlPage, HtmlValue};

/// Default priority for the task of a program that a page calls. It is the only value that was observed.
const PRIORITY: u32 = 10;

/// Pages of an application.
pub(crate) fn of(db: &Database, project: Project) -> Vec<HtmlPage> {
    pages::names(db, project).iter().map(|name| page(db, project, name)).collect()
}

/// Returns the page with this name, with the bindings of its file, if there is one.
fn page(db: &Database, project: Project, name: &str) -> HtmlPage {
    let file = pages::binding_files(db, project).find(|file| {
        let own = file.path(db).file_name().and_then(|own| page_name(own, BINDINGS));
        own.is_some_and(|own| own.eq_ignore_ascii_case(name))
    });
    let page = file.map(|file| page_of(bindings(db, file))).unwrap_or_default();
    HtmlPage { name: name.to_owned(), ..page }
}

fn page_of(bindings: &Bindings) -> HtmlPage {
    let text = |name: &Option<BoundName>| name.as_ref().map(|name| name.text.to_string());
    let values = bindings.data.iter().filter_map(|bound| {
        let attribute = bound.attribute.as_ref()?.to_string();
        Some(HtmlValue { element: text(&bound.element)?, attribute, path: text(&bound.path)? })
    });
    let callbacks = bindings.callbacks.iter().filter_map(|callback| {
        let suits = |priority: &u32| tasks::priority().is_some_and(|range| range.takes(f64::from(*priority)));
        Some(HtmlCallback {
            element: text(&callback.element)?,
            event: callback.event.as_ref()?.to_string(),
            program: text(&callback.program)?,
            priority: callback.priority.filter(suits).unwrap_or(PRIORITY),
        })
    });
    HtmlPage { name: String::new(), values: values.collect(), callbacks: callbacks.collect() }
}
