//! Memory use of a workspace with many files.

use serde_json::{Value, json};

use super::probes::probed;
use crate::client::Client;
use crate::server_state::MANY_TREES;

const PROJECTS: usize = 60;
const PROGRAMS: usize = 10;

/// Writes projects with programs, and returns their folder.
fn workspace() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for project in 0..PROJECTS {
        let name = format!("app{project}");
        let path = folder.path().join(&name);
        std::fs::create_dir(&path).unwrap();
        let list: String = (0..PROGRAMS).map(|program| format!("<Program file=\"p{program}.pgx\" />")).collect();
        let manifest = format!(
            "<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters version=\"s7.11\" />\
             <Programs>{list}</Programs><Database /><Libraries /></Project>"
        );
        write(&path.join(format!("{name}.pjx")), &manifest);
        for program in 0..PROGRAMS {
            let text = format!(
                "<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"p{program}\">\
                 <Code><![CDATA[begin\n  putln(\"{name}\")\nend]]></Code></Program></Programs>"
            );
            write(&path.join(format!("p{program}.pgx")), &text);
        }
    }
    folder
}

fn write(path: &std::path::Path, text: &str) {
    let path = camino::Utf8Path::from_path(path).unwrap();
    val3_files::replace(path, text.as_bytes()).unwrap();
}

/// Waits until the server has freed the syntax trees of a completed request.
fn wait_for_few_trees(client: &mut Client) {
    let count = |client: &mut Client| client.ask("test/trees", json!({})).as_u64();
    let is_freed = (0..500).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(20));
        count(client).is_some_and(|count| count <= MANY_TREES as u64)
    });
    assert!(is_freed, "{:?} trees are kept", count(client));
}

#[test]
fn results_of_many_files_are_freed_after_each_request() {
    let folder = workspace();
    let pulls = json!({ "textDocument": { "diagnostic": {} }, "workspace": { "diagnostics": {} } });
    let mut client = Client::of(probed).begin(&[folder.path().to_str().unwrap()], pulls, Value::Null);
    client.ask("workspace/symbol", json!({ "query": "none" }));
    wait_for_few_trees(&mut client);
    let report = client.ask("workspace/diagnostic", json!({ "previousResultIds": [] }));
    assert!(report["items"].as_array().is_some(), "{report}");
    wait_for_few_trees(&mut client);
    assert_eq!(client.end(), 0);
}
