//! Effects of a `val3.toml`: nearest file, roots, version, arm, add-ons, excluded applications.

use camino::Utf8PathBuf;
use expect_test::expect;
use val3_analysis::items::project::items;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;

use crate::show::faults_in;

const PROGRAM: &str = "<Programs><Program name=\"start\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";

/// Creates a project with one program and libraries with these paths.
fn application(folder: &str, libraries: &[&str]) -> Vec<(String, String)> {
    let entries: String =
        (0..).zip(libraries).map(|(index, path)| format!("<Library alias=\"a{index}\" path=\"{path}\" />")).collect();
    let name = folder.rsplit('/').next().unwrap();
    let manifest = format!(
        "<Project><Parameters version=\"s7.0\" /><Programs><Program file=\"start.pgx\" /></Programs>\
         <Libraries>{entries}</Libraries></Project>"
    );
    vec![(format!("{folder}/{name}.pjx"), manifest), (format!("{folder}/start.pgx"), PROGRAM.to_owned())]
}

/// Loads applications and other files; `asked` is the path to load.
fn loaded(applications: &[(&str, &[&str])], files: &[(&str, &str)], asked: &str) -> Result<Workspace, String> {
    let applications = applications.iter().flat_map(|(folder, libraries)| application(folder, libraries));
    let files = files.iter().map(|&(path, text)| (path.to_owned(), text.to_owned()));
    let memory = Memory::new(applications.chain(files));
    load(&memory, &[Utf8PathBuf::from(asked)]).map_err(|error| error.to_string() + "\n")
}

/// Shows version, arm and disk of the projects, then the faults.
fn shown(applications: &[(&str, &[&str])], files: &[(&str, &str)], asked: &str) -> String {
    let workspace = match loaded(applications, files, asked) {
        Ok(workspace) => workspace,
        Err(error) => return error,
    };
    let db = &workspace.db;
    let projects = workspace.projects.iter().map(|project| {
        let items = items(db, *project);
        let (path, disk) = (project.manifest(db).path(db), project.disk(db));
        format!("{path}: {} {:?} on {}\n", items.version, items.arm, disk.map_or("?", |disk| disk.as_str()))
    });
    projects.collect::<String>() + &faults_in(&workspace)
}

#[test]
fn only_the_nearest_file_applies() {
    let files = [
        ("/w/val3.toml", "version = \"s8.12\"\narm = \"scara\"\n"),
        ("/w/old/val3.toml", "version = \"s6.8\"\n"),
        ("/w/none/val3.toml", ""),
    ];
    expect![[r#"
        /w/a/a.pjx: s8.12 Some(Scara) on /w
        /w/none/c/c.pjx: s7.0 None on /w/none
        /w/old/b/b.pjx: s6.8 None on /w/old
    "#]]
    .assert_eq(&shown(&[("/w/a", &[]), ("/w/old/b", &[]), ("/w/none/c", &[])], &files, "/w"));
}

#[test]
fn roots_lead_to_libraries() {
    let files = [("/w/val3.toml", "disk = \"content\"\nroots = { USB0 = \"usb\" }\n")];
    let applications: [(&str, &[&str]); 3] = [
        ("/w/main", &["Disk://io/io.pjx", "USB0://part", "usb0://missing", "USB1://other"]),
        ("/w/content/io", &[]),
        ("/w/usb/part", &[]),
    ];
    expect![[r#"
        /w/main/main.pjx: s7.0 None on /w/content
        w/main/main.pjx:1 `usb0://missing` FileMissing { what: Library, path: "usb0://missing" }
        w/main/main.pjx:1 `USB1://other` UnresolvedPath { what: Library, path: "USB1://other", root: "USB1", near: None }
    "#]]
    .assert_eq(&shown(&applications, &files, "/w/main"));
}

#[test]
fn tables_of_add_ons() {
    let table = "<Language version=\"s7.0\"><Functions /></Language>";
    let files = [("/w/val3.toml", "add-ons = [\"tables/val3.One.cfx\"]\n"), ("/w/tables/val3.One.cfx", table)];
    let workspace = loaded(&[("/w/a", &[])], &files, "/w").unwrap();
    let db = &workspace.db;
    let cell = workspace.projects[0].cell(db).unwrap();
    assert_eq!(cell.config(db).add_ons.len(), 1);
}

#[test]
fn excluded_applications_can_be_used_as_libraries() {
    let files = [("/w/val3.toml", "disk = \".\"\nexclude = [\"old/**\", \"**/backup\"]\n")];
    let applications: [(&str, &[&str]); 4] =
        [("/w/main", &["Disk://old/io"]), ("/w/old/io", &[]), ("/w/x/backup/y", &[]), ("/w/x/z", &[])];
    expect![[r#"
        /w/main/main.pjx: s7.0 None on /w
        /w/x/z/z.pjx: s7.0 None on /w
    "#]]
    .assert_eq(&shown(&applications, &files, "/w"));
    for named in ["/w/old", "/w/old/io", "/w/old/io/io.pjx"] {
        assert!(shown(&applications, &files, named).contains("/w/old/io/io.pjx"), "{named}");
    }
    expect![[r#"
        /w/x: every application here is excluded by `exclude` in /w/val3.toml; name one to check it
    "#]]
    .assert_eq(&shown(&[("/w/x/backup/y", &[])], &files, "/w/x"));
}

#[test]
fn faulty_configurations() {
    let files = [
        ("/w/val3.toml", "disk = \"nowhere\"\nadd-ons = [\"none.cfx\"]\n"),
        ("/w/b/val3.toml", "[rules]\nV0101 = \"of\"\n"),
    ];
    expect![[r#"
        there is no folder `nowhere`
         --> /w/val3.toml:1
          |
        1 | disk = "nowhere"
          | ^^^^
          help: paths are relative to the folder of this file, `/w`
        `rules.V0101` must be one of off, on, info, warning, error, default, not "of"
         --> /w/b/val3.toml:2
          |
        2 | V0101 = "of"
          |         ^^^^
          help: did you mean `off`?
        the table of add-on instructions `none.cfx` cannot be read: it does not exist
         --> /w/val3.toml:2
          |
        2 | add-ons = ["none.cfx"]
          | ^^^^^^^
    "#]]
    .assert_eq(&shown(&[("/w/a", &[]), ("/w/b", &[])], &files, "/w"));
}
