//! The page with the table of all programs.

use std::fmt::Write as _;

use super::{cells, document, escaped};
use crate::coverage::Coverage;
use crate::program::ProgramCoverage;
use crate::share::Share;

/// The page. `names` are the files of the programs' pages.
pub(super) fn page(coverage: &Coverage, names: &[String]) -> String {
    let pages: Vec<(&str, &String)> = coverage.programs().map(|(file, _)| file).zip(names).collect();
    let page_of = |file: &str| pages.iter().find(|(known, _)| *known == file).map_or("", |(_, page)| page.as_str());
    let mut body = "<h1>Coverage</h1>\n<table class=\"index\">\n<thead><tr><th scope=\"col\">program</th>\
                    <th scope=\"colgroup\" colspan=\"2\" class=\"number\">lines</th>\
                    <th scope=\"colgroup\" colspan=\"2\" class=\"number\">branches</th></tr></thead>\n"
        .to_owned();
    for programs in coverage.projects() {
        body.push_str("<tbody>\n");
        project(&programs, &mut body);
        for (file, program) in programs {
            let name = format!("<a href=\"{}\">{}</a>", page_of(file), escaped(&program.program));
            row("program", &name, (program.line_share(), program.branch_share()), &mut body);
        }
        body.push_str("</tbody>\n");
    }
    body.push_str("<tfoot>\n");
    row("total", "total", (coverage.line_share(), coverage.branch_share()), &mut body);
    document("Coverage", &(body + "</tfoot>\n</table>\n"))
}

/// The row of an application or library.
fn project(programs: &[(&str, &ProgramCoverage)], body: &mut String) {
    let sum = |share: fn(&ProgramCoverage) -> Share| programs.iter().map(|(_, program)| share(program)).sum();
    let name = programs.first().map(|(_, program)| escaped(&program.project)).unwrap_or_default();
    row("project", &name, (sum(ProgramCoverage::line_share), sum(ProgramCoverage::branch_share)), body);
}

fn row(class: &str, name: &str, (lines, branches): (Share, Share), body: &mut String) {
    let _ =
        writeln!(body, "<tr class=\"{class}\"><th scope=\"row\">{name}</th>{}{}</tr>", cells(lines), cells(branches));
}
