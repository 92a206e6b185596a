//! `val3.tests`: a command that returns the tests in the workspace or in one file.

use serde::Serialize;
use serde_json::Value;
use tower_lsp::lsp_types::{Location, Url};
use val3_analysis::db::Project;
use val3_ide::TestProgram;

use crate::snapshot::{Refusal, Snapshot};

/// Command name. Its argument is a file URI; without an argument it returns all tests.
pub(super) const TESTS: &str = "val3.tests";

/// A test, for clients that execute it in a terminal.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Test {
    /// `application:program`.
    name: String,
    application: String,
    program: String,
    /// URI of the application's `.pjx`.
    manifest: Url,
    /// Location of the program's name in its file.
    location: Location,
    /// Command line that executes the test.
    command: Vec<String>,
}

pub(super) fn tests(snapshot: &Snapshot, arguments: &[Value]) -> Result<Value, Refusal> {
    let file = match arguments {
        [] | [Value::Null] => None,
        [uri] => {
            let uri = serde_json::from_value(uri.clone());
            Some(snapshot.file(&uri.map_err(|_| because("the argument is the URI of a file"))?)?)
        }
        _ => return Err(because("there is one argument at most: the URI of a file")),
    };
    let db = snapshot.db();
    let real = snapshot.projects.iter().filter(|project| snapshot.is_shown(project.manifest(db)));
    let found = real.flat_map(|project| val3_ide::test_programs(db, *project).into_iter().map(|test| (*project, test)));
    let wanted = found.filter(|(_, test)| file.is_none_or(|file| test.place.file == file));
    let tests: Vec<Test> = wanted.map(|(project, test)| described(snapshot, project, &test)).collect();
    serde_json::to_value(tests).map_err(|error| because(&error.to_string()))
}

fn because(reason: &str) -> Refusal {
    Refusal::Because(format!("`{TESTS}`: {reason}"))
}

fn described(snapshot: &Snapshot, project: Project, test: &TestProgram) -> Test {
    let manifest = project.manifest(snapshot.db());
    let path = manifest.path(snapshot.db());
    let application = path.file_stem().unwrap_or_default();
    let name = format!("{application}:{}", test.name);
    let folder = path.parent().unwrap_or(path);
    let arguments = [&snapshot.executable, "test", folder.as_str(), "--exact", &name];
    Test {
        application: application.to_owned(),
        program: test.name.to_string(),
        manifest: snapshot.uri(manifest),
        location: snapshot.location(test.place),
        command: arguments.map(str::to_owned).to_vec(),
        name,
    }
}
