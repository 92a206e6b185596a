//! HTML pages without scripts or other files. They are light or dark according to the reader's system.

mod index;
mod program;

use std::collections::BTreeSet;

use crate::coverage::Coverage;
use crate::program::ProgramCoverage;
use crate::share::Share;

const STYLE: &str = include_str!("html/style.css");

/// A page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HtmlReport {
    /// File name.
    pub name: String,
    /// Content of the page.
    pub text: String,
}

/// Returns `index.html` with a table of all programs, and a page for each program with its code.
#[must_use]
pub fn pages(coverage: &Coverage) -> Vec<HtmlReport> {
    let names = names(coverage);
    let index = HtmlReport { name: "index.html".to_owned(), text: index::page(coverage, &names) };
    let programs = coverage.programs().zip(&names);
    let programs =
        programs.map(|((file, program), name)| HtmlReport { name: name.clone(), text: program::page(file, program) });
    std::iter::once(index).chain(programs).collect()
}

/// Returns file names for the programs' pages, which are unique in any letter case.
fn names(coverage: &Coverage) -> Vec<String> {
    let mut taken = BTreeSet::from(["index.html".to_owned()]);
    coverage.programs().map(|(_, program)| name(program, &mut taken)).collect()
}

/// Returns the file name of a program's page, and adds it to the names in use.
fn name(program: &ProgramCoverage, taken: &mut BTreeSet<String>) -> String {
    let plain = |text: &str| text.replace(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_', "-");
    let stem = format!("{}.{}", plain(&program.project), plain(&program.program));
    let numbered = (2..).map(|number| format!("{stem}.{number}.html"));
    let mut candidates = std::iter::once(format!("{stem}.html")).chain(numbered);
    candidates.find(|name| taken.insert(name.to_lowercase())).unwrap_or_default()
}

fn document(title: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        title = escaped(title)
    )
}

/// Formats the percentage with a bar, and the counts, as two table cells.
fn cells(share: Share) -> String {
    if share.total == 0 {
        return "<td class=\"number\">–</td><td></td>".to_owned();
    }
    format!(
        "<td class=\"number\"><span class=\"bar\" aria-hidden=\"true\"><span style=\"width:{:.1}%\"></span></span>\
         <span class=\"percent\">{share}</span></td><td class=\"number\">{}/{}</td>",
        share.percent(),
        share.hit,
        share.total
    )
}

/// Escapes text for HTML and replaces control characters.
fn escaped(text: &str) -> String {
    let visible = text.replace(|letter: char| letter.is_control() && letter != '\t', "\u{fffd}");
    visible.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::example::example;
    use crate::program::ProgramCoverage;

    /// Returns a page without its style.
    fn body(name: &str) -> String {
        let page = pages(&example()).into_iter().find(|page| page.name == name).unwrap();
        let (head, body) = page.text.split_once("<body>").unwrap();
        assert!(head.contains("<title>") && !page.text.contains("<script") && !page.text.contains("http"));
        body.to_owned()
    }

    #[test]
    fn the_index_has_a_row_for_each_program() {
        expect![[r#"

            <h1>Coverage</h1>
            <table class="index">
            <thead><tr><th scope="col">program</th><th scope="colgroup" colspan="2" class="number">lines</th><th scope="colgroup" colspan="2" class="number">branches</th></tr></thead>
            <tbody>
            <tr class="project"><th scope="row">feeder</th><td class="number"><span class="bar" aria-hidden="true"><span style="width:0.0%"></span></span><span class="percent">0.0 %</span></td><td class="number">0/2</td><td class="number">–</td><td></td></tr>
            <tr class="program"><th scope="row"><a href="feeder.feed.html">feed</a></th><td class="number"><span class="bar" aria-hidden="true"><span style="width:0.0%"></span></span><span class="percent">0.0 %</span></td><td class="number">0/2</td><td class="number">–</td><td></td></tr>
            </tbody>
            <tbody>
            <tr class="project"><th scope="row">pal</th><td class="number"><span class="bar" aria-hidden="true"><span style="width:62.5%"></span></span><span class="percent">62.5 %</span></td><td class="number">5/8</td><td class="number"><span class="bar" aria-hidden="true"><span style="width:50.0%"></span></span><span class="percent">50.0 %</span></td><td class="number">4/8</td></tr>
            <tr class="program"><th scope="row"><a href="pal.start.html">start</a></th><td class="number"><span class="bar" aria-hidden="true"><span style="width:57.1%"></span></span><span class="percent">57.1 %</span></td><td class="number">4/7</td><td class="number"><span class="bar" aria-hidden="true"><span style="width:50.0%"></span></span><span class="percent">50.0 %</span></td><td class="number">4/8</td></tr>
            <tr class="program"><th scope="row"><a href="pal.stop.html">stop</a></th><td class="number"><span class="bar" aria-hidden="true"><span style="width:100.0%"></span></span><span class="percent">100.0 %</span></td><td class="number">1/1</td><td class="number">–</td><td></td></tr>
            </tbody>
            <tfoot>
            <tr class="total"><th scope="row">total</th><td class="number"><span class="bar" aria-hidden="true"><span style="width:50.0%"></span></span><span class="percent">50.0 %</span></td><td class="number">5/10</td><td class="number"><span class="bar" aria-hidden="true"><span style="width:50.0%"></span></span><span class="percent">50.0 %</span></td><td class="number">4/8</td></tr>
            </tfoot>
            </table>
            </body>
            </html>
        "#]].assert_eq(&body("index.html"));
    }

    #[test]
    fn code_is_marked_and_missing_sides_are_named() {
        expect![[r#"

            <p><a href="index.html">Coverage</a></p>
            <h1>pal:start</h1>
            <p><code>usrapp/pal/start.pgx</code><br>lines 57.1 % (4/7), branches 50.0 % (4/8)</p>
            <table class="code">
            <thead><tr><th scope="col">line</th><th scope="col">executed</th><th scope="col">code</th></tr></thead>
            <tbody>
            <tr id="L9"><td class="number">9</td><td class="number"></td><td><pre>begin</pre></td></tr>
            <tr id="L10" class="partial"><td class="number">10</td><td class="number">3</td><td><pre>  if a&lt;b &amp; &quot;c&quot;</pre> <span class="sides"><b>never: false</b>; true 3</span></td></tr>
            <tr id="L11" class="hit"><td class="number">11</td><td class="number">3</td><td><pre>    x=1</pre></td></tr>
            <tr id="L12"><td class="number">12</td><td class="number"></td><td><pre>  endIf</pre></td></tr>
            <tr id="L13" class="partial"><td class="number">13</td><td class="number">7</td><td><pre>  switch n</pre> <span class="sides"><b>never: case &quot;a&quot;</b>; no case 7</span></td></tr>
            <tr id="L14"><td class="number">14</td><td class="number"></td><td><pre>    case &quot;a&quot;</pre></td></tr>
            </tbody>
            </table>
            </body>
            </html>
        "#]].assert_eq(&body("pal.start.html"));
    }

    #[test]
    fn pages_have_different_names_in_any_letter_case() {
        let mut coverage = Coverage::default();
        for (file, project, program) in [("a/x.pgx", "lib", "x"), ("b/x.pgx", "lib", "X"), ("c/../x.pgx", "l/b", "é")]
        {
            let program = ProgramCoverage { project: project.into(), program: program.into(), ..Default::default() };
            coverage.add(file.to_owned(), program);
        }
        assert_eq!(names(&coverage), ["lib.x.html", "lib.X.2.html", "l-b.-.html"]);
    }
}
