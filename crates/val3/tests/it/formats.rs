//! Contents and destinations of the formats.

use serde_json::Value;

use crate::support::{CLEAN, FAULTY, Folder, run};

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn json_gives_the_position_of_a_finding() {
    let folder = Folder::with(FAULTY);
    let run = folder.val3(&["check", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    let document = json(&run.stdout);
    assert_eq!(document["version"], 1);
    assert_eq!(document["summary"]["applications"], 1);
    assert_eq!(document["summary"]["errors"], 1);
    let finding = &document["diagnostics"][0];
    assert_eq!(finding["code"], "V0101");
    assert_eq!(finding["name"], "unknown-name");
    assert_eq!(finding["file"], "usrapp/main/start.pgx");
    assert_eq!(finding["application"], "usrapp/main/main.pjx");
    assert_eq!(finding["program"], "start");
    assert_eq!(finding["code_line"], 2);
    assert_eq!(marked(&folder, finding), "nCuont");
}

#[test]
fn equal_files_give_equal_reports() {
    let folder = Folder::with(FAULTY);
    for format in [
        "concise",
        "json",
        "json-lines",
        "val3check",
        "sarif",
        "github",
        "gitlab",
        "azure",
        "junit",
        "checkstyle",
        "rdjson",
    ] {
        let report = || folder.val3(&["check", "--format", format]).stdout;
        assert_eq!(report(), report(), "{format}");
    }
}

/// File text between the offsets of a finding.
fn marked(folder: &Folder, finding: &Value) -> String {
    let text = folder.read("usrapp/main/start.pgx");
    let offset = |end: &str| finding["range"][end]["offset"].as_u64().unwrap() as usize;
    text[offset("start")..offset("end")].to_owned()
}

#[test]
fn paths_are_relative_to_the_given_folder() {
    let folder = Folder::with(FAULTY);
    for (path, file, application) in [
        ("usrapp", "main/start.pgx", "main/main.pjx"),
        ("usrapp/main", "start.pgx", "main.pjx"),
        ("usrapp/main/main.pjx", "start.pgx", "main.pjx"),
    ] {
        let document = json(&folder.val3(&["check", path, "--format", "json"]).stdout);
        let finding = &document["diagnostics"][0];
        assert_eq!((&finding["file"], &finding["application"]), (&file.into(), &application.into()));
    }
}

#[test]
fn terminal_paths_open_from_the_current_folder() {
    let run = Folder::with(FAULTY).val3(&["check", "usrapp/main", "--format", "concise"]);
    assert!(run.stdout.starts_with("usrapp/main/start.pgx:"), "{run:?}");
    assert!(run.stdout.contains(": error[V0101] "), "{run:?}");
}

#[test]
fn each_line_of_json_lines_is_a_finding() {
    let run = Folder::with(FAULTY).val3(&["check", "--format", "json-lines"]);
    assert_eq!(run.stdout.lines().count(), 1, "{run:?}");
    assert_eq!(json(&run.stdout)["severity"], "error");
}

#[test]
fn val3check_names_files_by_their_controller_path() {
    let folder = Folder::with(FAULTY);
    let run = folder.val3(&["check", "--format", "val3check"]);
    assert!(run.stdout.starts_with("<level>Error<CLASS>PRG<P1>start<P2>CODE<line>2<msg>"), "{run:?}");
    assert!(run.stdout.ends_with("<file>Disk://main/start.pgx\n"), "{run:?}");
    let template = "--val3check-template=%l|%f|%e";
    let run = folder.val3(&["check", "--format", "val3check", template]);
    assert_eq!(run.stdout, "2|Disk://main/start.pgx|Error\n");
}

#[test]
fn services_get_paths_relative_to_the_repository() {
    let folder = Folder::with(FAULTY);
    folder.write(".git/HEAD", "ref: refs/heads/main\n");
    let below = |format: &str| report_below(&folder, format);
    assert!(below("github").starts_with("::error file=usrapp/main/start.pgx,line="));
    assert!(below("azure").contains(";sourcepath=usrapp/main/start.pgx;"));
    assert!(below("checkstyle").contains("<file name=\"usrapp/main/start.pgx\">"));
    assert_eq!(json(&below("gitlab"))[0]["location"]["path"], "usrapp/main/start.pgx");
    let log = json(&below("sarif"));
    let location = &log["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
    assert_eq!(location["artifactLocation"]["uri"], "usrapp/main/start.pgx");
}

/// Report of a check in the folder `usrapp`.
fn report_below(folder: &Folder, format: &str) -> String {
    let mut command = folder.command(&["check", "main", "--format", format]);
    command.current_dir(folder.path().join("usrapp"));
    run(command).stdout
}

#[test]
fn fingerprints_do_not_depend_on_line_numbers() {
    let folder = Folder::with(FAULTY);
    let before = fingerprint(&folder);
    let program = folder.read("usrapp/main/start.pgx");
    folder.write("usrapp/main/start.pgx", &program.replace("nCuont", "// new\n\n  nCuont"));
    assert_eq!(fingerprint(&folder), before);
}

/// Fingerprints of the first finding.
fn fingerprint(folder: &Folder) -> Value {
    let run = folder.val3(&["check", "--format", "sarif"]);
    json(&run.stdout)["runs"][0]["results"][0]["partialFingerprints"].clone()
}

#[test]
fn junit_has_a_suite_for_each_application() {
    let run = Folder::with(&format!("{FAULTY}\n--- part\n{CLEAN}")).val3(&["check", "--format", "junit"]);
    assert!(
        run.stdout.contains("<testsuite name=\"usrapp/main/main.pjx\" tests=\"1\" failures=\"1\" errors=\"0\">"),
        "{run:?}"
    );
    assert!(
        run.stdout.contains("<testsuite name=\"usrapp/part/part.pjx\" tests=\"1\" failures=\"0\" errors=\"0\">"),
        "{run:?}"
    );
}

#[test]
fn every_output_gets_its_format() {
    let folder = Folder::with(FAULTY);
    let run =
        folder.val3(&["check", "--output", "json=report.json", "--output", "concise=report.txt", "--color", "always"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("V0101"), "{run:?}");
    assert_eq!(json(&folder.read("report.json"))["summary"]["errors"], 1);
    let text = folder.read("report.txt");
    assert!(text.contains("error[V0101]") && text.contains("1 error in"), "{text}");
    assert!(!text.contains('\u{1b}'), "{text}");
}

#[test]
fn a_clean_application_writes_a_document_without_findings() {
    let run = Folder::with(CLEAN).val3(&["check", "--format", "json"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert_eq!(json(&run.stdout)["diagnostics"], Value::Array(Vec::new()));
}
