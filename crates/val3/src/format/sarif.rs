//! SARIF 2.1.0, the format of code scanning services such as GitHub's.
//!
//! Paths are relative to the root of the repository. The rule table contains only rules with findings, each with its
//! page.

mod log;
mod rules;

use std::collections::BTreeMap;
use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use crate::fingerprint::fingerprints;
use crate::report::{CheckReport, Finding, FindingSeverity, Related, ReportRange, ReportedEdit, ReportedFix};
use log::{
    ArtifactChange, ArtifactLocation, BaseUri, Driver, Invocation, Level, Location, Log, LogicalLocation, Message,
    Notification, PartialFingerprints, PhysicalLocation, Region, Replacement, Result as SarifResult, Run, Tool,
};
use rules::Rules;

/// Writes the log and a line end.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, &log(report))?;
    writeln!(out)
}

fn log(report: &CheckReport) -> Log<'_> {
    let rules = Rules::of(report);
    let marked = report.findings.iter().zip(fingerprints(&report.findings));
    let results = marked.map(|(finding, fingerprint)| result(finding, fingerprint, &rules)).collect();
    let driver = Driver {
        name: "val3",
        semantic_version: env!("CARGO_PKG_VERSION"),
        information_uri: env!("CARGO_PKG_REPOSITORY"),
        rules: rules.descriptors(),
    };
    let run = Run {
        tool: Tool { driver },
        invocations: [invocation(report)],
        original_uri_base_ids: base_uris(&report.source_root),
        column_kind: "unicodeCodePoints",
        results,
    };
    Log { schema: log::SCHEMA, version: "2.1.0", runs: [run] }
}

/// Absolute URI of the repository's root, by its name in the log.
fn base_uris(root: &str) -> BTreeMap<&'static str, BaseUri> {
    let absolute = Some(root).filter(|root| !root.is_empty()).map(|root| root.trim_matches('/'));
    let uri = |path: &str| format!("file:///{}/", utf8_percent_encode(path, ESCAPED)).replace("////", "///");
    absolute.map(|path| (SOURCE_ROOT, BaseUri { uri: uri(path) })).into_iter().collect()
}

fn invocation(report: &CheckReport) -> Invocation {
    let messages = report.unreadable.iter().map(|error| Message { text: error.to_string() });
    Invocation {
        execution_successful: report.is_complete(),
        tool_execution_notifications: messages.map(|message| Notification { level: Level::Error, message }).collect(),
    }
}

fn result<'a>(finding: &'a Finding, fingerprint: String, rules: &Rules) -> SarifResult<'a> {
    SarifResult {
        rule_id: finding.code,
        rule_index: rules.index(finding.code),
        level: level(finding.severity),
        message: Message { text: finding.message_with_help() },
        locations: [location(finding)],
        related_locations: (1..).zip(&finding.related).map(|(id, related)| related_location(id, related)).collect(),
        partial_fingerprints: PartialFingerprints { line: fingerprint },
        fixes: finding.fix.iter().map(fix).collect(),
    }
}

fn level(severity: FindingSeverity) -> Level {
    match severity {
        FindingSeverity::Info => Level::Note,
        FindingSeverity::Warning => Level::Warning,
        FindingSeverity::Error => Level::Error,
    }
}

fn location(finding: &Finding) -> Location<'_> {
    let program = finding.program.iter().map(|name| LogicalLocation { name, kind: "function" });
    Location {
        id: None,
        physical_location: physical_location(&finding.place),
        logical_locations: program.collect(),
        message: None,
    }
}

fn related_location(id: usize, related: &Related) -> Location<'_> {
    Location {
        id: Some(id),
        physical_location: physical_location(&related.place),
        logical_locations: Vec::new(),
        message: Some(Message { text: related.message.clone() }),
    }
}

fn physical_location(place: &ReportRange) -> PhysicalLocation {
    PhysicalLocation { artifact_location: artifact_location(&place.file.in_repository), region: region(place) }
}

fn region(place: &ReportRange) -> Region {
    let (start, end) = (place.start(), place.end());
    Region { start_line: start.line, start_column: start.column, end_line: end.line, end_column: end.column }
}

/// Name of the repository's root, to which paths are relative.
const SOURCE_ROOT: &str = "%SRCROOT%";

/// Characters of a path that are not percent-encoded.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~').remove(b'/');

fn artifact_location(path: &str) -> ArtifactLocation {
    ArtifactLocation { uri: utf8_percent_encode(path, ESCAPED).to_string(), uri_base_id: SOURCE_ROOT }
}

fn fix(fix: &ReportedFix) -> log::Fix {
    let changes = fix.edits.chunk_by(|a, b| a.place.file.path == b.place.file.path);
    log::Fix {
        description: Message { text: fix.title.clone() },
        artifact_changes: changes.filter_map(artifact_change).collect(),
    }
}

/// Converts one file's edits; `None` without edits.
fn artifact_change(edits: &[ReportedEdit]) -> Option<ArtifactChange> {
    let path = &edits.first()?.place.file.in_repository;
    Some(ArtifactChange {
        artifact_location: artifact_location(path),
        replacements: edits.iter().map(replacement).collect(),
    })
}

fn replacement(edit: &ReportedEdit) -> Replacement {
    Replacement { deleted_region: region(&edit.place), inserted_content: Message { text: edit.text.clone() } }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    const SCHEMA: &str = include_str!("../../tests/schemas/sarif-2.1.0.json");

    /// The published schema without its pattern for languages, which is no valid regular expression; the log has no
    /// language.
    fn schema() -> Value {
        let mut schema: Value = serde_json::from_str(SCHEMA).unwrap();
        for part in ["run", "toolComponent"] {
            let language = &mut schema["definitions"][part]["properties"]["language"];
            assert!(language.as_object_mut().unwrap().remove("pattern").is_some());
        }
        schema
    }

    fn valid(report: &CheckReport) -> Value {
        let log = serde_json::from_str(&rendered(ReportFormat::Sarif, report)).unwrap();
        let validator = jsonschema::validator_for(&schema()).unwrap();
        let faults: Vec<_> = validator.iter_errors(&log).map(|error| error.to_string()).collect();
        assert!(faults.is_empty(), "{faults:#?}");
        log
    }

    /// Replaces the rule pages, which have their own tests.
    fn shown(mut log: Value) -> String {
        for rule in log["runs"][0]["tool"]["driver"]["rules"].as_array_mut().unwrap() {
            rule["help"] = "…".into();
            rule["fullDescription"]["text"] = "…".into();
        }
        log["runs"][0]["tool"]["driver"]["semanticVersion"] = "…".into();
        log["runs"][0]["tool"]["driver"]["informationUri"] = "…".into();
        serde_json::to_string_pretty(&log).unwrap()
    }

    #[test]
    fn the_log_lists_rules_and_results() {
        insta::assert_snapshot!(shown(valid(&sample::report())));
    }

    #[test]
    fn logs_conform_to_the_schema() {
        valid(&sample::hostile());
        let clean = valid(&sample::clean());
        assert_eq!(clean["runs"][0]["results"], Value::Array(Vec::new()));
        let error = crate::user_error::UserError::new("cannot read the folder `x`");
        let log = valid(&CheckReport { unreadable: vec![error], ..sample::clean() });
        assert_eq!(log["runs"][0]["invocations"][0]["executionSuccessful"], false);
    }

    #[test]
    fn the_base_of_paths_is_a_folder() {
        let uri = |root: &str| base_uris(root).remove(SOURCE_ROOT).map(|base| base.uri);
        assert_eq!(uri("/home/me/Zelle 1").unwrap(), "file:///home/me/Zelle%201/");
        assert_eq!(uri("/").unwrap(), "file:///");
        assert_eq!(uri(""), None);
    }

    #[test]
    fn paths_are_percent_encoded() {
        assert_eq!(artifact_location("../Zelle 1/größe.pgx").uri, "../Zelle%201/gr%C3%B6%C3%9Fe.pgx");
    }
}
