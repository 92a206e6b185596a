//! Cobertura XML, version 04: an application or library is a package, a program is a class.

use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use crate::coverage::{Coverage, ProjectCoverage};
use crate::program::ProgramCoverage;
use crate::share::Share;

type Xml<'w> = Writer<&'w mut dyn Write>;

/// Document type of the element `coverage`.
const DOCTYPE: &str = "coverage SYSTEM \"http://cobertura.sourceforge.net/xml/coverage-04.dtd\"";

/// Writes the document. `root` is the folder to which paths are relative. The time stamp is 0, so that equal results
/// yield equal files.
///
/// # Errors
/// If writing to `out` fails.
pub fn write(coverage: &Coverage, root: &str, out: &mut dyn Write) -> io::Result<()> {
    let mut xml = Writer::new_with_indent(out, b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.write_event(Event::DocType(BytesText::from_escaped(DOCTYPE)))?;
    let (lines, branches) = (coverage.line_share(), coverage.branch_share());
    let element = xml.create_element("coverage").with_attributes([
        ("line-rate", rate(lines).as_str()),
        ("branch-rate", rate(branches).as_str()),
        ("lines-covered", lines.hit.to_string().as_str()),
        ("lines-valid", lines.total.to_string().as_str()),
        ("branches-covered", branches.hit.to_string().as_str()),
        ("branches-valid", branches.total.to_string().as_str()),
        ("complexity", "0"),
        ("version", concat!("val3 ", env!("CARGO_PKG_VERSION"))),
        ("timestamp", "0"),
    ]);
    element.write_inner_content(|xml| {
        let sources = xml.create_element("sources");
        sources.write_inner_content(|xml| {
            xml.create_element("source").write_text_content(BytesText::new(root)).map(drop)
        })?;
        let packages = xml.create_element("packages");
        packages
            .write_inner_content(|xml| coverage.projects().iter().try_for_each(|project| package(project, xml)))
            .map(drop)
    })?;
    writeln!(xml.get_mut())
}

fn rate(share: Share) -> String {
    format!("{:.4}", share.rate())
}

fn package(project: &ProjectCoverage<'_>, xml: &mut Xml<'_>) -> io::Result<()> {
    let element = xml.create_element("package").with_attributes([
        ("name", project.name.as_str()),
        ("line-rate", rate(project.line_share()).as_str()),
        ("branch-rate", rate(project.branch_share()).as_str()),
        ("complexity", "0"),
    ]);
    let classes = |xml: &mut Xml<'_>| project.programs.iter().try_for_each(|(file, program)| class(file, program, xml));
    element.write_inner_content(|xml| xml.create_element("classes").write_inner_content(classes).map(drop)).map(drop)
}

fn class(file: &str, program: &ProgramCoverage, xml: &mut Xml<'_>) -> io::Result<()> {
    let element = xml.create_element("class").with_attributes([
        ("name", program.program.as_str()),
        ("filename", file),
        ("line-rate", rate(program.line_share()).as_str()),
        ("branch-rate", rate(program.branch_share()).as_str()),
        ("complexity", "0"),
    ]);
    element
        .write_inner_content(|xml| {
            xml.create_element("methods").write_empty()?;
            xml.create_element("lines").write_inner_content(|xml| lines(program, xml)).map(drop)
        })
        .map(drop)
}

fn lines(program: &ProgramCoverage, xml: &mut Xml<'_>) -> io::Result<()> {
    program.lines.iter().try_for_each(|(number, hits)| line(program, *number, *hits, xml))
}

fn line(program: &ProgramCoverage, number: u32, hits: u64, xml: &mut Xml<'_>) -> io::Result<()> {
    let shares: Vec<Share> =
        program.branches_at(number).map(|branch| Share::of(branch.sides.iter().map(|side| side.hits))).collect();
    let element = xml
        .create_element("line")
        .with_attributes([("number", number.to_string().as_str()), ("hits", hits.to_string().as_str())]);
    if shares.is_empty() {
        return element.with_attribute(("branch", "false")).write_empty().map(drop);
    }
    let condition = condition_coverage(shares.iter().copied().sum());
    let element = element.with_attributes([("branch", "true"), ("condition-coverage", condition.as_str())]);
    element
        .write_inner_content(|xml| {
            xml.create_element("conditions").write_inner_content(|xml| conditions(&shares, xml)).map(drop)
        })
        .map(drop)
}

fn conditions(shares: &[Share], xml: &mut Xml<'_>) -> io::Result<()> {
    shares.iter().enumerate().try_for_each(|(number, share)| {
        let (number, coverage) = (number.to_string(), whole_percent(*share));
        let attributes = [("number", number.as_str()), ("type", "jump"), ("coverage", coverage.as_str())];
        xml.create_element("condition").with_attributes(attributes).write_empty().map(drop)
    })
}

/// Formats `50% (1/2)`.
fn condition_coverage(share: Share) -> String {
    format!("{} ({}/{})", whole_percent(share), share.hit, share.total)
}

fn whole_percent(share: Share) -> String {
    format!("{:.0}%", share.percent().floor())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::example::{example, text};

    #[test]
    fn a_program_is_a_class_of_its_application() {
        expect![[r#"
            <?xml version="1.0" encoding="UTF-8"?>
            <!DOCTYPE coverage SYSTEM "http://cobertura.sourceforge.net/xml/coverage-04.dtd">
            <coverage line-rate="0.5000" branch-rate="0.5000" lines-covered="5" lines-valid="10" branches-covered="4" branches-valid="8" complexity="0" version="val3 VERSION" timestamp="0">
              <sources>
                <source>/cell &amp; more</source>
              </sources>
              <packages>
                <package name="feeder" line-rate="0.0000" branch-rate="1.0000" complexity="0">
                  <classes>
                    <class name="feed" filename="usrapp/feeder/feed.pgx" line-rate="0.0000" branch-rate="1.0000" complexity="0">
                      <methods/>
                      <lines>
                        <line number="5" hits="0" branch="false"/>
                        <line number="6" hits="0" branch="false"/>
                      </lines>
                    </class>
                  </classes>
                </package>
                <package name="pal" line-rate="0.6250" branch-rate="0.5000" complexity="0">
                  <classes>
                    <class name="start" filename="usrapp/pal/start.pgx" line-rate="0.5714" branch-rate="0.5000" complexity="0">
                      <methods/>
                      <lines>
                        <line number="10" hits="3" branch="true" condition-coverage="50% (1/2)">
                          <conditions>
                            <condition number="0" type="jump" coverage="50%"/>
                          </conditions>
                        </line>
                        <line number="11" hits="3" branch="false"/>
                        <line number="13" hits="7" branch="true" condition-coverage="50% (1/2)">
                          <conditions>
                            <condition number="0" type="jump" coverage="50%"/>
                          </conditions>
                        </line>
                        <line number="15" hits="0" branch="true" condition-coverage="0% (0/2)">
                          <conditions>
                            <condition number="0" type="jump" coverage="0%"/>
                          </conditions>
                        </line>
                        <line number="16" hits="0" branch="false"/>
                        <line number="19" hits="1" branch="true" condition-coverage="100% (2/2)">
                          <conditions>
                            <condition number="0" type="jump" coverage="100%"/>
                          </conditions>
                        </line>
                        <line number="20" hits="0" branch="false"/>
                      </lines>
                    </class>
                    <class name="stop" filename="usrapp/pal/stop.pgx" line-rate="1.0000" branch-rate="1.0000" complexity="0">
                      <methods/>
                      <lines>
                        <line number="4" hits="2" branch="false"/>
                      </lines>
                    </class>
                  </classes>
                </package>
              </packages>
            </coverage>
        "#]].assert_eq(&text(|out| super::write(&example(), "/cell & more", out)).replace(env!("CARGO_PKG_VERSION"), "VERSION"));
    }
}
