//! Texts on the user page.

use toml::Spanned;
use val3_machine::controller::Controller;
use val3_machine::event::shown_seconds;
use val3_machine::screen::PageContent;

use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Page that the pendant shows.
pub(crate) fn shown(controller: &Controller) -> Option<&PageContent> {
    let pendant = &controller.devices.state.pendant;
    pendant.page(pendant.shown())
}

/// Whether the title or a line of the page contains the text.
pub(super) fn shows(page: &PageContent, text: &str) -> bool {
    page.title().contains(text) || page.lines().any(|line| line.contains(text))
}

/// Formats the title and the lines of a page, without trailing empty lines. Line ends in a text do not start a new
/// line.
pub(super) fn picture(page: &PageContent) -> String {
    let one_line = |text: &str| text.replace(['\n', '\r'], "␊");
    let mut lines: Vec<String> = page.lines().map(|line| one_line(&line)).collect();
    let written = lines.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1);
    lines.truncate(written);
    let shown = lines.iter().map(|line| format!("\n| {line}").trim_end().to_owned());
    format!("{}{}", format!("+ {}", one_line(page.title())).trim_end(), shown.collect::<String>())
}

/// Title and lines of the displayed page, without trailing blanks and empty lines.
pub(super) fn lines(controller: &Controller) -> Vec<String> {
    let Some(page) = shown(controller) else { return Vec::new() };
    let texts = [page.title().to_owned()].into_iter().chain(page.lines());
    let mut lines: Vec<String> = texts.map(|line| line.replace(['\n', '\r'], "␊").trim_end().to_owned()).collect();
    let written = lines.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1);
    lines.truncate(written);
    lines
}

/// Displayed page, unless it is empty, a failure already shows it, or there is no failure.
pub(crate) fn written_page(controller: &Controller, failures: &[Failure]) -> Option<String> {
    let page = shown(controller).filter(|page| page.lines().any(|line| !line.trim().is_empty()))?;
    let picture = picture(page);
    let is_new = !failures.is_empty() && failures.iter().all(|failure| !failure.message.contains(&picture));
    is_new.then_some(picture)
}

/// Failures of texts that the displayed page should contain.
pub(super) fn failures(
    texts: &[Spanned<String>],
    key: &str,
    controller: &Controller,
    source: &ExpectationSource,
) -> Vec<Failure> {
    let Some(page) = shown(controller) else { return Vec::new() };
    let now = shown_seconds(controller.now());
    let missing = texts.iter().filter(|text| !shows(page, text.get_ref()));
    let failures = missing.map(|text| Failure {
        message: format!("the screen does not show {:?} at {now} s\n{}", text.get_ref(), picture(page)),
        places: vec![source.place(key, text.span())],
    });
    failures.collect()
}
