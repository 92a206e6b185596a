//! Index page with the table of all programs.

use super::{cells, document, escaped};
use crate::coverage::Coverage;
use crate::share::Share;

/// Returns the page. `names` are the file names of the programs' pages.
pub(super) fn page(coverage: &Coverage, names: &[String]) -> String {
    let pages: Vec<(&str, &String)> = coverage.programs().map(|(file, _)| file).zip(names).collect();
    let page_of = |file: &str| pages.iter().find(|(known, _)| *known == file).map_or("", |(_, page)| page.as_str());
    let mut body = "<h1>Coverage</h1>\n<table class=\"index\">\n<thead><tr><th scope=\"col\">program</th>\
                    <th scope=\"colgroup\" colspan=\"2\" class=\"number\">lines</th>\
                    <th scope=\"colgroup\" colspan=\"2\" class=\"number\">branches</th></tr></thead>\n"
        .to_owned();
    for project in coverage.projects() {
        body.push_str("<tbody>\n");
        body += &row("project", &escaped(&project.name), project.line_share(), project.branch_share());
        for (file, program) in project.programs {
            let name = format!("<a href=\"{}\">{}</a>", page_of(file), escaped(&program.program));
            body += &row("program", &name, program.line_share(), program.branch_share());
        }
        body.push_str("</tbody>\n");
    }
    body.push_str("<tfoot>\n");
    body += &row("total", "total", coverage.line_share(), coverage.branch_share());
    document("Coverage", &(body + "</tfoot>\n</table>\n"))
}

fn row(class: &str, name: &str, lines: Share, branches: Share) -> String {
    format!("<tr class=\"{class}\"><th scope=\"row\">{name}</th>{}{}</tr>\n", cells(lines), cells(branches))
}
