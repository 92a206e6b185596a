//! One record per line in the format of the manufacturer's checker, for wrappers that parse its output.
//!
//! A template defines the contents of a record:
//!
//! | placeholder | meaning |
//! |---|---|
//! | `%e` | level: `Error`, `Warning` or `Message` |
//! | `%f` | file on the controller (`Disk://pal/pick.pgx`) |
//! | `%l` | line of the code, the line of `begin` being 1; outside code the line of the file |
//! | `%m` | message |
//! | `%c` | class: `PRG` in a program, `DATA` elsewhere |
//! | `%p` | program; empty elsewhere |
//! | `%s` | section: `CODE` in the code of a program; empty elsewhere |
//! | `%%` | a per cent sign |

use std::io;
use std::str::FromStr;

use codespan_reporting::term::termcolor::WriteColor;

use crate::printable::one_line;
use crate::report::{CheckReport, Finding, FindingSeverity};

/// Record template that known wrappers of the manufacturer's checker parse.
pub(crate) const DEFAULT_TEMPLATE: &str = "<level>%e<CLASS>%c<P1>%p<P2>%s<line>%l<msg>%m<file>%f";

/// Template of a record.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Template(String);

impl Default for Template {
    fn default() -> Self {
        Self(DEFAULT_TEMPLATE.to_owned())
    }
}

impl FromStr for Template {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut letters = text.chars();
        while letters.by_ref().any(|letter| letter == '%') {
            match letters.next() {
                Some('e' | 'f' | 'l' | 'm' | 'c' | 'p' | 's' | '%') => {}
                Some(other) => {
                    return Err(format!("`%{other}` is not a placeholder; supported: %e %f %l %m %c %p %s %%"));
                }
                None => return Err("`%` at the end; write `%%` for a per cent sign".to_owned()),
            }
        }
        Ok(Self(text.to_owned()))
    }
}

/// Writes one record for each finding.
pub(crate) fn write(report: &CheckReport, template: &Template, out: &mut dyn WriteColor) -> io::Result<()> {
    for finding in &report.findings {
        writeln!(out, "{}", record(finding, template))?;
    }
    Ok(())
}

fn record(finding: &Finding, template: &Template) -> String {
    let mut record = String::new();
    let mut letters = template.0.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '%' => record.push_str(&placeholder(letters.next(), finding)),
            _ => record.push(letter),
        }
    }
    // A record is one line, even if its message quotes several lines.
    one_line(&record).into_owned()
}

fn placeholder(letter: Option<char>, finding: &Finding) -> String {
    match letter {
        Some('e') => level(finding.severity).to_owned(),
        Some('f') => file(finding),
        Some('l') => line(finding).to_string(),
        Some('m') => finding.message.clone(),
        Some('c') => class(finding).to_owned(),
        Some('p') => finding.program.clone().unwrap_or_default(),
        Some('s') => section(finding).to_owned(),
        _ => "%".to_owned(),
    }
}

fn level(severity: FindingSeverity) -> &'static str {
    match severity {
        FindingSeverity::Info => "Message",
        FindingSeverity::Warning => "Warning",
        FindingSeverity::Error => "Error",
    }
}

fn file(finding: &Finding) -> String {
    let file = &finding.place.file;
    file.disk.clone().unwrap_or_else(|| file.path.clone())
}

fn line(finding: &Finding) -> usize {
    finding.code_line.unwrap_or_else(|| finding.place.start().line)
}

fn class(finding: &Finding) -> &'static str {
    if finding.program.is_some() { "PRG" } else { "DATA" }
}

fn section(finding: &Finding) -> &'static str {
    if finding.code_line.is_some() { "CODE" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn each_finding_is_a_record_on_its_line() {
        insta::assert_snapshot!(rendered(ReportFormat::Val3Check, &sample::report()));
    }

    #[test]
    fn a_template_shapes_the_record() {
        let finding = &sample::report().findings[2];
        let template = "%e;%f(%l);%m;100%%".parse().unwrap();
        assert_eq!(record(finding, &template), "Warning;Disk://pal/pick.pgx(4);`nCout` is not declared;100%");
    }

    #[test]
    fn an_unknown_placeholder_is_refused() {
        assert!("%x".parse::<Template>().unwrap_err().contains("`%x`"));
        assert!("%%%".parse::<Template>().is_err());
    }
}
