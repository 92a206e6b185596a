//! Sample reports for the tests of all formats.

#![allow(clippy::expect_used, reason = "a sample that is broken may stop the tests")]

use std::sync::Arc;

use val3_check::fingerprint::Fingerprint;
use val3_syntax::encoding::Encoding;

use super::*;

const APPLICATION: &str = "cell/usr/usrapp/pal/pal.pjx";
const PROGRAM: &str = r#"<?xml version="1.0" encoding="iso-8859-1" ?>
<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="pick">
    <Code><![CDATA[begin
  // prise de pièce
  movej(pPick,tGrip,"fast") //ä
	nCout=1
end]]></Code>
  </Program>
</Programs>
"#;
const DATA: &str = "<Data name=\"mFast\" access=\"private\" type=\"mdesc\" size=\"1\"/>\r\n\
    <Data name=\"nCount\" access=\"private\" type=\"num\" size=\"1\"/>\r\n";

/// Three findings with three levels in two files.
pub(crate) fn report() -> CheckReport {
    let statistics = ReportStatistics { applications: 1, files: 3, programs: 1, code_lines: 1412, seconds: 0.0213 };
    let program = file("cell/usr/usrapp/pal/pick.pgx", PROGRAM, Encoding::Latin1);
    let data = file("cell/usr/usrapp/pal/pal.dtx", DATA, Encoding::Utf8);
    let findings = vec![unknown_name(&program, &data), argument_type(&program, &data), unused_data(&data)];
    let report = CheckReport::new(statistics, vec![APPLICATION.to_owned()], findings, Vec::new());
    CheckReport { source_root: "/home/me/Zelle 1".to_owned(), ..report }
}

/// Report of a check without findings.
pub(crate) fn clean() -> CheckReport {
    CheckReport::new(report().statistics, vec![APPLICATION.to_owned()], Vec::new(), Vec::new())
}

/// Report whose texts contain the special characters of all formats.
pub(crate) fn hostile() -> CheckReport {
    let file = file("cell/a&b \u{1}/<x>,\"y\":%.pgx", "nCout\u{0}=1\n", Encoding::Utf8);
    let finding = Finding {
        message: "`]]>\u{1b}[2J&amp;\" %\r\n::error::` is </error>".to_owned(),
        fix: Some(write(&file, "nCout", "a<b&&c")),
        related: Vec::new(),
        place: place(&file, "nCout"),
        ..unused_data(&report().findings[0].place.file)
    };
    CheckReport::new(report().statistics, vec![APPLICATION.to_owned()], vec![finding], Vec::new())
}

/// Range of `part` in `file`.
pub(crate) fn place(file: &Arc<SourceFile>, part: &str) -> ReportRange {
    let start = file.text.find(part).expect("the sample holds the part");
    ReportRange { file: Arc::clone(file), range: start..start + part.len() }
}

fn write(file: &Arc<SourceFile>, part: &str, instead: &str) -> ReportedFix {
    let edit = ReportedEdit { place: place(file, part), text: instead.to_owned() };
    ReportedFix { title: format!("write `{instead}`"), safe: false, edits: vec![edit] }
}

fn file(path: &str, text: &str, encoding: Encoding) -> Arc<SourceFile> {
    let mut file = SourceFile::new(path, text.into(), encoding);
    file.disk = path.split_once("usrapp/").map(|(_, rest)| format!("Disk://{rest}"));
    Arc::new(file)
}

fn fingerprint(rule: &str, file: &SourceFile, line: &str) -> Fingerprint {
    let [file, rule, line] = [&file.in_repository, rule, line].map(str::to_owned);
    Fingerprint { file, rule, line, message: String::new() }
}

fn argument_type(program: &Arc<SourceFile>, data: &Arc<SourceFile>) -> Finding {
    Finding {
        code: "V0203",
        name: "argument-type",
        severity: FindingSeverity::Error,
        message: "`movej` takes an mdesc as third argument and got a string".to_owned(),
        label: "this is a string".to_owned(),
        help: "pass a motion descriptor, for example `mFast`".to_owned(),
        fingerprint: fingerprint("V0203", program, "movej(pPick,tGrip,\"fast\") //ä"),
        place: place(program, "\"fast\""),
        program: Some("pick".to_owned()),
        code_line: Some(3),
        application: Some(APPLICATION.to_owned()),
        is_new: false,
        related: vec![Related { place: place(data, "mFast"), message: "an mdesc is declared here".to_owned() }],
        fix: None,
    }
}

fn unknown_name(program: &Arc<SourceFile>, data: &Arc<SourceFile>) -> Finding {
    Finding {
        code: "V0101",
        name: "unknown-name",
        severity: FindingSeverity::Warning,
        message: "`nCout` is not declared".to_owned(),
        label: String::new(),
        help: "did you mean `nCount`?".to_owned(),
        fingerprint: fingerprint("V0101", program, "nCout=1"),
        place: place(program, "nCout"),
        code_line: Some(4),
        related: vec![Related { place: place(data, "nCount"), message: "a similar name".to_owned() }],
        fix: Some(write(program, "nCout", "nCount")),
        ..argument_type(program, data)
    }
}

fn unused_data(data: &Arc<SourceFile>) -> Finding {
    Finding {
        code: "V0701",
        name: "unused-data",
        severity: FindingSeverity::Info,
        message: "`nCount` is never used".to_owned(),
        label: "declared here".to_owned(),
        help: String::new(),
        fingerprint: fingerprint("V0701", data, DATA.lines().nth(1).unwrap_or_default().trim()),
        place: place(data, "nCount"),
        program: None,
        code_line: None,
        application: Some(APPLICATION.to_owned()),
        is_new: false,
        related: Vec::new(),
        fix: None,
    }
}
