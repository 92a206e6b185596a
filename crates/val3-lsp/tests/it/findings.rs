//! Pushed and pulled findings, compared with `val3 check`.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use serde_json::{Value, json};
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_check::{Checked, check_unit, finish, units};

use crate::cell::{Cell, place};
use crate::client::{Client, uri};
use crate::codes;

/// File, line, code, message.
type Found = (String, usize, String, String);

fn example(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    path.canonicalize().unwrap().to_str().unwrap().to_owned()
}

/// Findings of `val3 check`, computed by the same calls as in its engine.
fn checked(folder: &str) -> Vec<Found> {
    let workspace = load(&Disk, &[Utf8PathBuf::from(folder)]).unwrap();
    let db = &workspace.db;
    let settings = WorkspaceSettings::new(db, &workspace.projects, &RuleSelection::default()).unwrap();
    let units = units(db, &workspace.projects);
    let sum: Checked = units.iter().map(|unit| check_unit(db, *unit, &settings)).sum();
    let found = finish(db, &units, &settings, sum).findings.into_iter().map(|found| {
        let text = found.place.file.text(db);
        let line = text[..usize::from(found.place.range.start())].matches('\n').count();
        let parts = [found.message, found.help];
        let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        (uri(found.place.file.path(db).as_str()), line, found.rule.code.to_owned(), parts.join("\n"))
    });
    sorted(found)
}

fn sorted(found: impl Iterator<Item = Found>) -> Vec<Found> {
    let mut found: Vec<Found> = found.collect();
    found.sort();
    found
}

fn of_file<'f>(uri: &'f str, findings: &'f [Value]) -> impl Iterator<Item = Found> + 'f {
    findings.iter().map(move |found| {
        let line = usize::try_from(found["range"]["start"]["line"].as_u64().unwrap()).unwrap();
        let text = |key: &str| found[key].as_str().unwrap().to_owned();
        (uri.to_owned(), line, text("code"), text("message").replace("\nhelp: ", "\n"))
    })
}

#[test]
fn pushed_findings_equal_the_check() {
    for name in ["faulty", "palletiser"] {
        let folder = example(name);
        let expected = checked(&folder);
        let mut client = Client::start(&[&folder]);
        let mut files: BTreeMap<String, Vec<Value>> = BTreeMap::new();
        let total = |files: &BTreeMap<String, Vec<Value>>| files.values().map(Vec::len).sum::<usize>();
        while total(&files) < expected.len() {
            let sent = client.told("textDocument/publishDiagnostics");
            let findings = sent["params"]["diagnostics"].as_array().unwrap().clone();
            files.insert(sent["params"]["uri"].as_str().unwrap().to_owned(), findings);
        }
        assert_eq!(sorted(files.iter().flat_map(|(uri, found)| of_file(uri, found))), expected, "{name}");
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn pulled_findings_equal_the_check() {
    let folder = example("faulty");
    let abilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::start_with(&[&folder], abilities, Value::Null);
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    let reports = report["items"].as_array().unwrap();
    let found = reports.iter().flat_map(|report| {
        of_file(report["uri"].as_str().unwrap(), report["items"].as_array().unwrap()).collect::<Vec<_>>()
    });
    assert_eq!(sorted(found), checked(&folder));
    for report in reports {
        let params = json!({ "textDocument": { "uri": report["uri"] } });
        let of_document = client.ask("textDocument/diagnostic", params);
        assert_eq!(of_document["kind"], "full");
        assert_eq!(of_document["items"], report["items"]);
        let again = json!({ "textDocument": { "uri": report["uri"] }, "previousResultId": of_document["resultId"] });
        assert_eq!(client.ask("textDocument/diagnostic", again)["kind"], "unchanged");
    }
    let known = reports.iter().map(|report| json!({ "uri": report["uri"], "value": report["resultId"] }));
    let again = client.ask("workspace/diagnostic", json!({ "previousResultIds": known.collect::<Vec<_>>() }));
    assert!(again["items"].as_array().unwrap().iter().all(|report| report["kind"] == "unchanged"), "{again}");
    // A client that pulls receives no published findings.
    assert!(client.passed().all(|message| message["method"] != "textDocument/publishDiagnostics"));
    assert_eq!(client.end(), 0);
}

const TWO: &str = "library part \"Disk://part/part.pjx\"\nnum nA\nnA=part:nWeight\nput(nA)\n\
                   --- part\npublic num nWeight";

#[test]
fn an_edit_updates_dependent_projects() {
    let cell = Cell::new(TWO);
    let (data, start) = (cell.path("usrapp/part/part.dtx"), cell.path("usrapp/main/start.pgx"));
    let mut client = Client::start(&[&cell.folder()]);
    let text = cell.text("usrapp/part/part.dtx");
    client.open(&data, text);
    assert_eq!(client.findings(&data, Some(1)), Vec::<Value>::new());
    client.change(&data, 2, &text.replace("nWeight", "nMass"));
    let found = client.findings(&start, None);
    assert!(!found.is_empty());
    client.change(&data, 3, text);
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn a_closed_document_has_its_stored_text() {
    let cell = Cell::new("num nA\nnA=1\nput(nA)");
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, &cell.text("usrapp/main/start.pgx").replace("nA=1", "nB=1"));
    assert!(codes(&client.findings(&start, Some(1))).contains(&"V0101"));
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&start) } }));
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn columns_follow_the_agreed_encoding() {
    let cell = Cell::new("string sA\nsA=\"é😀\"+nWrong");
    let start = cell.path("usrapp/main/start.pgx");
    let text = cell.text("usrapp/main/start.pgx");
    let (line, in_utf16) = place(text, "nWrong");
    let in_utf8 = in_utf16 + 1 + 2;
    for (offered, column) in
        [(json!(["utf-16", "utf-8"]), in_utf8), (json!(["utf-16"]), in_utf16), (json!([]), in_utf16)]
    {
        let abilities = json!({ "general": { "positionEncodings": offered } });
        let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
        let found = client.findings(&start, None);
        assert_eq!(found[0]["range"]["start"], json!({ "line": line, "character": column }), "{offered}");
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn settings_of_the_editor_select_findings() {
    let cell = Cell::new("nA=1\nnB=1");
    let start = cell.path("usrapp/main/start.pgx");
    let ignore = json!({ "val3": { "check": { "ignore": ["V0101"] } } });
    let mut client = Client::start_with(&[&cell.folder()], json!({}), ignore);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    assert!(!codes(&client.findings(&start, Some(1))).contains(&"V0101"));
    client.notify("workspace/didChangeConfiguration", json!({ "settings": { "val3": {} } }));
    assert!(codes(&client.findings(&start, Some(1))).contains(&"V0101"));
    assert_eq!(client.end(), 0);
}

#[test]
fn settings_are_requested_from_the_client() {
    let cell = Cell::new("nA=1");
    let start = cell.path("usrapp/main/start.pgx");
    let abilities = json!({ "workspace": { "configuration": true } });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    let asked = client.told("workspace/configuration");
    assert_eq!(asked["params"]["items"][0]["section"], "val3");
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    let settings = json!([{ "check": { "ignore": ["V01"] } }]);
    client.send(&json!({ "jsonrpc": "2.0", "id": asked["id"], "result": settings }));
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

/// Kinds of the progress messages for a token, until the end.
fn progress_of(client: &mut Client, token: &str) -> Vec<String> {
    let mut kinds = Vec::new();
    while kinds.last().is_none_or(|kind| kind != "end") {
        let told = client.told("$/progress");
        if told["params"]["token"] == token {
            kinds.push(told["params"]["value"]["kind"].as_str().unwrap().to_owned());
        }
    }
    kinds
}

/// Accepts the server's next progress request, and returns its token.
fn agree(client: &mut Client) -> String {
    let asked = client.told("window/workDoneProgress/create");
    client.send(&json!({ "jsonrpc": "2.0", "id": asked["id"], "result": null }));
    asked["params"]["token"].as_str().unwrap().to_owned()
}

#[test]
fn the_first_scan_reports_its_progress() {
    let cell = Cell::new("nA=1");
    let abilities = json!({ "window": { "workDoneProgress": true } });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    let token = agree(&mut client);
    assert_eq!(progress_of(&mut client, &token), ["begin", "report", "end"]);
    client.findings(&cell.path("usrapp/main/start.pgx"), None);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_client_that_does_not_agree_is_served_all_the_same() {
    let cell = Cell::new("nA=1");
    let abilities = json!({ "window": { "workDoneProgress": true } });
    for is_refused in [true, false] {
        let mut client = Client::start_with(&[&cell.folder()], abilities.clone(), Value::Null);
        let asked = client.told("window/workDoneProgress/create");
        if is_refused {
            let error = json!({ "code": -32601, "message": "not here" });
            client.send(&json!({ "jsonrpc": "2.0", "id": asked["id"], "error": error }));
        }
        assert_eq!(codes(&client.findings(&cell.path("usrapp/main/start.pgx"), None)), ["V0101"]);
        assert_eq!(client.try_told("$/progress"), None);
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn findings_of_the_workspace_report_their_progress() {
    let cell = Cell::new("nA=1\n--- part\nnum nInner");
    let abilities = json!({ "window": { "workDoneProgress": true }, "textDocument": { "diagnostic": {} } });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    let (scan, pull) = (agree(&mut client), agree(&mut client));
    assert_eq!(progress_of(&mut client, &scan), ["begin", "end"]);
    // The client shows the progress of the first pull, and of later pulls that contain a token.
    client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert_eq!(progress_of(&mut client, &pull), ["begin", "report", "report", "end"]);
    client.ask("workspace/diagnostic", json!({ "previousResultIds": [], "workDoneToken": "mine" }));
    assert_eq!(progress_of(&mut client, "mine"), ["begin", "report", "report", "end"]);
    client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert_eq!(client.try_told("$/progress"), None);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_pulling_client_is_told_to_refresh() {
    let cell = Cell::new("call other(1)\nprogram other(num x_n)\nbegin\n  put(x_n)\nend");
    let (start, other) = (cell.path("usrapp/main/start.pgx"), cell.path("usrapp/main/other.pgx"));
    let abilities = json!({
        "textDocument": { "diagnostic": {} },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    client.open(&other, cell.text("usrapp/main/other.pgx"));
    assert_eq!(pulled(&mut client, &start), json!([]));
    assert_eq!(pulled(&mut client, &other), json!([]));
    // The client pulls findings for an edited document without a refresh.
    client.change(&other, 2, &cell.text("usrapp/main/other.pgx").replace("put(x_n)", "put(x_m)"));
    assert_eq!(client.try_told("workspace/diagnostic/refresh"), None);
    assert_eq!(codes(pulled(&mut client, &other).as_array().unwrap()), ["V0101"]);
    client.change(&other, 3, &cell.text("usrapp/main/other.pgx").replace("\"num\"", "\"string\""));
    let told = client.told("workspace/diagnostic/refresh");
    client.send(&json!({ "jsonrpc": "2.0", "id": told["id"], "result": null }));
    assert_eq!(codes(pulled(&mut client, &start).as_array().unwrap()), ["V0203"]);
    assert_eq!(client.try_told("workspace/diagnostic/refresh"), None);
    assert_eq!(client.end(), 0);
}

/// Findings that a client pulls for a document.
fn pulled(client: &mut Client, path: &str) -> Value {
    client.ask("textDocument/diagnostic", json!({ "textDocument": { "uri": uri(path) } }))["items"].clone()
}

/// Three applications with the same program, whose parameter has the name of the program.
fn shared_cause() -> String {
    let program = "public program message(string message)\nbegin\nputln(message)\nend\n";
    format!("call message(\"\")\n{program}--- one\n{program}--- two\n{program}")
}

/// Files with a finding of this rule, in the client's current state.
fn files_with(files: &BTreeMap<String, Vec<Value>>, code: &str) -> Vec<String> {
    let with = files.iter().filter(|(_, found)| found.iter().any(|found| found["code"] == code));
    with.map(|(uri, _)| uri.rsplit_once("/usrapp/").unwrap().1.to_owned()).collect()
}

#[test]
fn a_shared_cause_is_pushed_once() {
    let cell = Cell::new(&shared_cause());
    let message = cell.path("usrapp/main/message.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    let text = cell.text("usrapp/main/message.pgx");
    client.open(&message, text);
    let mut files: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    receive_findings(&mut client, &mut files);
    assert_eq!(files_with(&files, "V0123"), ["main/message.pgx"]);
    assert_eq!(files_with(&files, "V0123").len(), checked(&cell.folder()).iter().filter(|it| it.2 == "V0123").count());
    let found = files[&uri(&message)].iter().find(|found| found["code"] == "V0123").unwrap();
    let related = found["relatedInformation"].to_string();
    assert!(related.contains("/one/") && related.contains("/two/"), "{related}");
    client.change(
        &message,
        2,
        &text.replace("name=\"message\" type", "name=\"x_s\" type").replace("(message)", "(x_s)"),
    );
    receive_findings(&mut client, &mut files);
    assert_eq!(files_with(&files, "V0123"), ["one/message.pgx"]);
    client.change(&message, 3, text);
    receive_findings(&mut client, &mut files);
    assert_eq!(files_with(&files, "V0123"), ["main/message.pgx"]);
    assert_eq!(client.end(), 0);
}

/// Replaces the findings of the files for which the server sends new ones.
fn receive_findings(client: &mut Client, files: &mut BTreeMap<String, Vec<Value>>) {
    while let Some(sent) = client.try_told("textDocument/publishDiagnostics") {
        let findings = sent["params"]["diagnostics"].as_array().unwrap().clone();
        files.insert(sent["params"]["uri"].as_str().unwrap().to_owned(), findings);
    }
}

#[test]
fn a_shared_cause_is_pulled_once() {
    let cell = Cell::new(&shared_cause());
    let message = cell.path("usrapp/main/message.pgx");
    let abilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    let text = cell.text("usrapp/main/message.pgx");
    client.open(&message, text);
    assert_eq!(files_with(&pulled_workspace(&mut client), "V0123"), ["main/message.pgx"]);
    client.change(
        &message,
        2,
        &text.replace("name=\"message\" type", "name=\"x_s\" type").replace("(message)", "(x_s)"),
    );
    assert_eq!(files_with(&pulled_workspace(&mut client), "V0123"), ["one/message.pgx"]);
    assert_eq!(client.end(), 0);
}

/// Findings of all files that a client pulls for the workspace.
fn pulled_workspace(client: &mut Client) -> BTreeMap<String, Vec<Value>> {
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    let items = report["items"].as_array().unwrap().iter();
    items.map(|it| (it["uri"].as_str().unwrap().to_owned(), it["items"].as_array().unwrap().clone())).collect()
}

#[test]
fn a_finding_is_one_sentence_with_help_and_its_page() {
    let cell = Cell::new("tool tA\nmdesc mA\njoint jA\nmovej(jA,mA,tA)\nwaitEndMove()");
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    let found = client.findings(&start, None);
    let found = found.iter().find(|found| found["code"] == "V0203").unwrap();
    let message = found["message"].as_str().unwrap();
    assert_eq!(message.lines().filter(|line| !line.starts_with("help: ")).count(), 1, "{message}");
    let label = &found["relatedInformation"][0];
    assert_eq!(label["location"], json!({ "uri": uri(&start), "range": found["range"] }));
    assert_eq!(label["message"], "this is an `mdesc`");
    let page = found["codeDescription"]["href"].as_str().unwrap();
    assert!(page.starts_with("https://") && page.ends_with("/rules/V0203.html"), "{page}");
    assert_eq!(client.end(), 0);
}

#[test]
fn unused_items_are_faded() {
    let cell = Cell::new("num nA\nnum nB\nnA=1");
    let data = cell.path("usrapp/main/main.dtx");
    let mut client = Client::start(&[&cell.folder()]);
    let mut found = client.findings(&data, None);
    found.sort_by_key(|found| found["code"].to_string());
    assert_eq!(codes(&found), ["V0113", "V0116"]);
    for found in found {
        assert_eq!((&found["severity"], &found["tags"]), (&json!(4), &json!([1])), "{found}");
    }
    // A configuration can raise the level.
    client.open(&cell.path("val3.toml"), "[rules]\nV0113 = \"warning\"\n");
    let found = client.findings(&data, None);
    let unused = found.iter().find(|found| found["code"] == "V0113").unwrap();
    assert_eq!((&unused["severity"], &unused["tags"]), (&json!(2), &json!([1])), "{unused}");
    assert_eq!(client.end(), 0);
}

fn reports_of(report: &Value, path: &str) -> Vec<Value> {
    let reports = report["items"].as_array().unwrap().iter().filter(|report| report["uri"] == uri(path));
    reports.flat_map(|report| report["items"].as_array().unwrap().clone()).collect()
}

#[test]
fn a_pulling_client_sees_a_broken_configuration() {
    let cell = Cell::new("nA=1");
    cell.write("val3.toml", "[rules]\nV0101 = \"of\"\n");
    let config = cell.path("val3.toml");
    let abilities = json!({
        "textDocument": { "diagnostic": {} },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    // A client may never pull the findings in a file that is not open.
    let sent = client.findings(&config, None);
    assert_eq!(sent[0]["range"]["start"]["line"], 1, "{sent:?}");
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert_eq!(reports_of(&report, &config), sent);
    // Pulled findings are not published as well.
    assert_eq!(client.findings(&config, None), Vec::<Value>::new());
    let params = json!({ "textDocument": { "uri": uri(&config) } });
    assert_eq!(client.ask("textDocument/diagnostic", params.clone())["items"], json!(sent));
    cell.write("val3.toml", "[rules]\n");
    let event = json!({ "uri": uri(&config), "type": 2 });
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": [event] }));
    let told = client.told("workspace/diagnostic/refresh");
    client.send(&json!({ "jsonrpc": "2.0", "id": told["id"], "result": null }));
    assert_eq!(client.ask("textDocument/diagnostic", params)["items"], json!([]));
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert_eq!(reports_of(&report, &config), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn settings_that_leave_the_cell_are_reported_and_nothing_outside_is_read() {
    let cell = Cell::new("nA=1");
    cell.write("val3.toml", "version = \"s8.12\"\nadd-ons = [\"/dev/zero\"]\n");
    let mut client = Client::start(&[&cell.folder()]);
    let sent = client.findings(&cell.path("val3.toml"), None);
    assert_eq!(sent[0]["range"]["start"]["line"], 1, "{sent:?}");
    let message = sent[0]["message"].as_str().unwrap();
    assert!(message.contains("`add-ons` resolves to `/dev/zero`, outside of the cell"), "{message}");
    assert!(message.contains("val3 trust"), "{message}");
    assert_eq!(client.end(), 0);
}

#[test]
fn unknown_settings_are_reported() {
    let cell = Cell::new("nA=1");
    let start = cell.path("usrapp/main/start.pgx");
    for abilities in [json!({}), json!({ "textDocument": { "diagnostic": {} } })] {
        let settings = json!({ "val3": { "check": { "ingore": ["V0101"] }, "server": { "path": "" } } });
        let mut client = Client::start_with(&[&cell.folder()], abilities, settings.clone());
        let told = client.told("window/showMessage");
        assert_eq!(told["params"]["type"], 2, "{told}");
        let message = told["params"]["message"].as_str().unwrap();
        assert!(message.contains("`val3.check.ingore`") && message.contains("`ignore`"), "{message}");
        client.notify("workspace/didChangeConfiguration", json!({ "settings": settings }));
        assert_eq!(client.try_told("window/showMessage"), None, "once is enough");
        let settings = json!({ "val3": { "check": { "ignore": "V0101" } } });
        client.notify("workspace/didChangeConfiguration", json!({ "settings": settings }));
        let told = client.told("window/showMessage");
        assert!(told["params"]["message"].as_str().unwrap().contains("`val3.check.ignore`"), "{told}");
        client.open(&start, cell.text("usrapp/main/start.pgx"));
        assert_eq!(client.end(), 0);
    }
}

/// Bytes of an s5 program with `café`.
const IN_LATIN1: &[u8] = b"<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>\n\
    <programList xmlns=\"ProgramNameSpace\">\n\
    <program name=\"start\" public=\"false\"><source><code>begin\n  putln(\"caf\xe9\")\nend</code></source></program>\n\
    </programList>\n";

/// Encoding faults of a stored file that an editor shows as `shown`.
fn encoding_faults(stored: &[u8], shown: &str) -> Vec<String> {
    let cell = Cell::new("cls()");
    let start = cell.path("usrapp/main/start.pgx");
    cell.write_bytes("usrapp/main/start.pgx", stored);
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, shown);
    let found = client.latest_findings(&start, 1);
    assert_eq!(client.end(), 0);
    let faults = found.iter().filter(|found| found["code"] == "V0005");
    faults.map(|found| found["message"].as_str().unwrap().lines().next().unwrap().to_owned()).collect()
}

#[test]
fn a_file_opened_in_the_wrong_encoding_is_reported() {
    let in_latin1: String = IN_LATIN1.iter().copied().map(char::from).collect();
    assert_eq!(encoding_faults(IN_LATIN1, &in_latin1), Vec::<String>::new());
    let misread = encoding_faults(IN_LATIN1, &String::from_utf8_lossy(IN_LATIN1));
    assert!(misread[0].contains("open in another encoding"), "{misread:?}");
    // The file was opened with the wrong encoding and saved.
    let lost = String::from_utf8_lossy(IN_LATIN1).into_owned();
    let found = encoding_faults(lost.as_bytes(), &lost);
    assert!(found[0].contains("lost"), "{found:?}");
    let found = encoding_faults(in_latin1.as_bytes(), &in_latin1);
    assert!(found[0].contains("declares ISO-8859-1 and is stored as UTF-8"), "{found:?}");
}

#[test]
fn a_file_saved_in_the_wrong_encoding_is_reported() {
    let cell = Cell::new("cls()");
    let start = cell.path("usrapp/main/start.pgx");
    cell.write_bytes("usrapp/main/start.pgx", IN_LATIN1);
    let in_latin1: String = IN_LATIN1.iter().copied().map(char::from).collect();
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, &in_latin1);
    assert!(!codes(&client.latest_findings(&start, 1)).contains(&"V0005"));
    cell.write("usrapp/main/start.pgx", &in_latin1);
    client.notify("textDocument/didSave", json!({ "textDocument": { "uri": uri(&start) } }));
    while !codes(&client.findings(&start, Some(1))).contains(&"V0005") {}
    cell.write_bytes("usrapp/main/start.pgx", IN_LATIN1);
    client.notify("textDocument/didSave", json!({ "textDocument": { "uri": uri(&start) } }));
    while codes(&client.findings(&start, Some(1))).contains(&"V0005") {}
    assert_eq!(client.end(), 0);
}

#[test]
fn an_unreadable_add_on_table_is_pulled_once() {
    let cell = Cell::new("num nA\n--- one\nnum nA\n--- two\nnum nA\n=== /app/val3.One.anthro.cfx\n<Table />");
    let abilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    let items = report["items"].as_array().unwrap().iter();
    let findings = items.flat_map(|it| it["items"].as_array().unwrap()).filter(|found| found["code"] == "V0502");
    assert_eq!(findings.count(), 1, "{report}");
    assert_eq!(checked(&cell.folder()).iter().filter(|it| it.2 == "V0502").count(), 1);
    assert_eq!(client.end(), 0);
}

#[cfg(unix)]
#[test]
fn a_listed_socket_is_a_finding_at_its_entry() {
    let cell = Cell::new("program start()\nbegin\n  call helper()\nend\n\nprogram helper()\nbegin\nend");
    cell.remove("usrapp/main/helper.pgx");
    let _socket = std::os::unix::net::UnixListener::bind(cell.path("usrapp/main/helper.pgx")).unwrap();
    let mut client = Client::start(&[&cell.folder()]);
    let project = cell.path("usrapp/main/main.pjx");
    client.open(&project, cell.text("usrapp/main/main.pjx"));
    let findings = client.latest_findings(&project, 1);
    assert_eq!(codes(&findings), ["V0502"]);
    assert_eq!(client.end(), 0);
}
