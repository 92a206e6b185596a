//! Discovery on a disk: projects, roots, names in other letter cases, and obstacles.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use expect_test::expect;
use val3_analysis::load::load;
#[cfg(unix)]
use val3_analysis::system::Disk;
use val3_analysis::system::{Memory, PathKind, System};
use val3_files::{FileClass, Unreadable};

use crate::show::faults_in;

const PROGRAM: &str = "<Programs><Program name=\"start\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";

fn manifest(libraries: &[&str]) -> String {
    let entries: String =
        (0..).zip(libraries).map(|(index, path)| format!("<Library alias=\"a{index}\" path=\"{path}\" />")).collect();
    format!("<Project><Programs><Program file=\"start.pgx\" /></Programs><Libraries>{entries}</Libraries></Project>")
}

/// Creates projects at `folder/name`, each with libraries.
fn disk(projects: &[(&str, &[&str])]) -> Memory {
    Memory::new(files(projects))
}

fn files(projects: &[(&str, &[&str])]) -> Vec<(String, String)> {
    let files = projects.iter().flat_map(|(folder, libraries)| {
        let name = folder.rsplit('/').next().unwrap();
        [(format!("{folder}/{name}.pjx"), manifest(libraries)), (format!("{folder}/start.pgx"), PROGRAM.to_owned())]
    });
    files.collect()
}

/// Shows the projects found under `path`, with the folder of `Disk://`, and all faults.
fn found(system: &dyn System, path: &str) -> String {
    let workspace = match load(system, &[path.into()]) {
        Ok(workspace) => workspace,
        Err(error) => return format!("{error}\n"),
    };
    let db = &workspace.db;
    let projects = workspace.projects.iter().map(|project| {
        let disk = project.disk(db).map_or("?", |disk| disk.as_str());
        format!("{} on {disk}\n", project.manifest(db).path(db))
    });
    let unreadable = workspace.unreadable.iter().map(|(path, reason)| format!("{path}: {reason}\n"));
    projects.chain(unreadable).collect::<String>() + &faults_in(&workspace)
}

#[test]
fn every_way_to_name_an_application() {
    let disk = disk(&[("/cell/usr/usrapp/a", &[]), ("/cell/usr/usrapp/sub/b", &[])]);
    expect![[r#"
        /cell/usr/usrapp/a/a.pjx on /cell/usr/usrapp
        /cell/usr/usrapp/sub/b/b.pjx on /cell/usr/usrapp
    "#]]
    .assert_eq(&found(&disk, "/cell"));
    expect![[r#"
        /cell/usr/usrapp/a/a.pjx on /cell/usr/usrapp
    "#]]
    .assert_eq(&found(&disk, "/cell/usr/usrapp/a"));
    expect![[r#"
        /cell/usr/usrapp/a/a.pjx on /cell/usr/usrapp
    "#]]
    .assert_eq(&found(&disk, "/cell/usr/../usr/usrapp/a/a.pjx"));
    expect![[r#"
        /cell/usr/usrapp/a/a.pjx on /cell/usr/usrapp
    "#]]
    .assert_eq(&found(&disk, "/cell/usr/usrapp/a/start.pgx"));
    expect![[r#"
        /cell/usr/usrapp/a/other.pgx: there is no such file or folder
    "#]]
    .assert_eq(&found(&disk, "/cell/usr/usrapp/a/other.pgx"));
    expect![[r#"
        /x/readme.md: this is not a VAL 3 file; name a `.pjx`, or the folder of an application
    "#]]
    .assert_eq(&found(&Memory::new([("/x/readme.md", "")]), "/x/readme.md"));
    expect![[r#"
        /x: there is no VAL 3 application (`.pjx`) in this folder or below; name an application folder, a `.pjx`, or a controller folder
    "#]].assert_eq(&found(&Memory::new([("/x/readme.md", "")]), "/x"));
    expect![[r#"
        /x/start.pgx: there is no `.pjx` next to this file, so its application is not known
    "#]]
    .assert_eq(&found(&Memory::new([("/x/start.pgx", "")]), "/x/start.pgx"));
}

#[test]
fn roots_without_usrapp() {
    let beside = disk(&[("/repo/a", &["Disk://b"]), ("/repo/b", &[])]);
    expect![[r#"
        /repo/a/a.pjx on /repo
        /repo/b/b.pjx on /repo
    "#]]
    .assert_eq(&found(&beside, "/repo"));
    let deeper = disk(&[
        ("/repo/val3/apps/a", &["Disk://libs/b", "Disk://apps/c"]),
        ("/repo/val3/libs/b", &[]),
        ("/repo/val3/apps/c", &[]),
    ]);
    expect![[r#"
        /repo/val3/apps/a/a.pjx on /repo/val3
        /repo/val3/apps/c/c.pjx on /repo/val3
        /repo/val3/libs/b/b.pjx on /repo/val3
    "#]]
    .assert_eq(&found(&deeper, "/repo"));
    let lost = disk(&[("/repo/a", &["Disk://gone"])]);
    expect![[r#"
        /repo/a/a.pjx on ?
        repo/a/a.pjx:1 `Disk://gone` UnresolvedPath { what: Library, path: "Disk://gone", root: "Disk", near: None }
    "#]]
    .assert_eq(&found(&lost, "/repo"));
    let relative = disk(&[
        ("/repo/a", &["./inner", "../b", "../../far/c"]),
        ("/repo/a/inner", &[]),
        ("/repo/b", &[]),
        ("/far/c", &[]),
    ]);
    expect![[r#"
        /repo/a/a.pjx on /repo
        /repo/a/inner/inner.pjx on /repo
        /repo/b/b.pjx on /repo
        repo/a/a.pjx:1 `../../far/c` FileOutside(Library, "../../far/c")
    "#]]
    .assert_eq(&found(&relative, "/repo"));
}

#[test]
fn loaded_libraries_determine_the_root() {
    let load = PROGRAM
        .replace("begin", "begin\n  a0:libLoad(\"Disk://libs/b\")\n  a0:libLoad(\"Disk://libs/\"+toString(\"\",1))");
    let files = [
        ("/repo/apps/a/a.pjx", manifest(&["./inner"])),
        ("/repo/apps/a/start.pgx", load),
        ("/repo/apps/a/inner/inner.pjx", manifest(&[])),
        ("/repo/apps/a/inner/start.pgx", PROGRAM.to_owned()),
        ("/repo/libs/b/b.pjx", manifest(&[])),
        ("/repo/libs/b/start.pgx", PROGRAM.to_owned()),
    ];
    expect![[r#"
        /repo/apps/a/a.pjx on /repo
        /repo/apps/a/inner/inner.pjx on /repo
    "#]]
    .assert_eq(&found(&Memory::new(files), "/repo/apps"));
}

#[test]
fn letter_case_is_ignored() {
    let disk = disk(&[
        ("/cell/usr/UsrApp/Main", &["DISK://LIBS/part", "disk://libs/Part/PART.PJX"]),
        ("/cell/usr/UsrApp/libs/Part", &[]),
    ]);
    expect![[r#"
        /cell/usr/UsrApp/Main/Main.pjx on /cell/usr/UsrApp
    "#]]
    .assert_eq(&found(&disk, "/cell/usr/UsrApp/Main"));
}

#[test]
fn a_folder_can_be_called_like_a_file() {
    let files = [
        ("/cell/usrapp/x.pjx/x.pjx", manifest(&["Disk://x.pjx"])),
        ("/cell/usrapp/x.pjx/start.pgx", PROGRAM.to_owned()),
    ];
    expect![[r#"
        /cell/usrapp/x.pjx: it cannot be read: it is a folder
    "#]]
    .assert_eq(&found(&Memory::new(files), "/cell"));
}

/// A disk with an unreadable file, a folder that cannot be listed, and a folder that contains itself.
#[derive(Debug)]
struct Rough(Memory);

impl System for Rough {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        if path.as_str().contains("locked") { Err(Unreadable::Denied) } else { self.0.read(&real(path), class) }
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        self.0.size(&real(path))
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        if path.ends_with("closed") {
            return Err(io::ErrorKind::PermissionDenied.into());
        }
        let mut names = self.0.list(&real(path))?;
        names.extend(path.ends_with("loop").then(|| "again".to_owned()));
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        self.0.kind(&real(path))
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        real(path)
    }
}

/// Resolves the link `loop/again` to `loop`.
fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.as_str().replace("/again", "").into()
}

#[test]
fn unreadable_files_are_reported() {
    let mut files = vec![
        ("/cell/usrapp/a/a.pjx".to_owned(), r#"<Project><Programs><Program file="locked.pgx" /></Programs><Database><Data file="locked.dtx" /></Database><Libraries><Library alias="b" path="Disk://locked" /></Libraries></Project>"#.to_owned()),
        ("/cell/usrapp/a/locked.pgx".to_owned(), String::new()),
        ("/cell/usrapp/a/locked.dtx".to_owned(), String::new()),
        ("/cell/usrapp/locked/locked.pjx".to_owned(), String::new()),
        ("/cell/usrapp/closed/x/x.pjx".to_owned(), String::new()),
    ];
    files.extend([
        ("/cell/usrapp/loop/c/c.pjx".to_owned(), manifest(&[])),
        ("/cell/usrapp/loop/c/start.pgx".to_owned(), PROGRAM.to_owned()),
    ]);
    expect![[r#"
        /cell/usrapp/a/a.pjx on /cell/usrapp
        /cell/usrapp/locked/locked.pjx on /cell/usrapp
        /cell/usrapp/loop/c/c.pjx on /cell/usrapp
        /cell/usrapp/closed: permission denied
        app/a/a.pjx:1 `Disk://locked` FileUnreadable { path: "Disk://locked", reason: "permission denied" }
        app/a/a.pjx:1 `locked.dtx` FileUnreadable { path: "locked.dtx", reason: "permission denied" }
        app/a/a.pjx:1 `locked.pgx` FileUnreadable { path: "locked.pgx", reason: "permission denied" }
        app/locked/locked.pjx:1 `` FileUnreadable { path: "locked.pjx", reason: "permission denied" }
    "#]]
    .assert_eq(&found(&Rough(Memory::new(files)), "/cell"));
}

#[test]
fn utf16_is_refused() {
    let root = fresh_folder("utf16");
    let app = root.join("usrapp/a");
    std::fs::create_dir_all(&app).unwrap();
    std::fs::write(app.join("a.pjx"), manifest(&[])).unwrap();
    std::fs::write(app.join("start.pgx"), b"\xff\xfe<\0?\0").unwrap();
    let shown = found(&Disk, root.as_str()).replace(root.as_str().trim_start_matches('/'), "root");
    std::fs::remove_dir_all(&root).unwrap();
    expect![[r#"
        /root/usrapp/a/a.pjx on /root/usrapp
        root/usrapp/a/a.pjx:1 `start.pgx` FileUnreadable { path: "start.pgx", reason: "its text is UTF-16; save it as UTF-8" }
    "#]]
    .assert_eq(&shown);
}

#[cfg(unix)]
#[test]
fn circular_links_on_a_disk_end() {
    let root = fresh_folder("links_in_a_circle");
    let app = root.join("usrapp/a");
    std::fs::create_dir_all(&app).unwrap();
    std::fs::write(app.join("a.pjx"), manifest(&["Disk://a.pgx"])).unwrap();
    std::fs::create_dir(app.join("start.pgx")).unwrap();
    std::os::unix::fs::symlink(&root, app.join("up")).unwrap();
    let shown = found(&Disk, root.as_str()).replace(root.as_str().trim_start_matches('/'), "root");
    std::fs::remove_dir_all(&root).unwrap();
    expect![[r#"
        /root/usrapp/a/a.pjx on /root/usrapp
        root/usrapp/a/a.pjx:1 `Disk://a.pgx` FileMissing { what: Library, path: "Disk://a.pgx" }
        root/usrapp/a/a.pjx:1 `start.pgx` FileUnreadable { path: "start.pgx", reason: "it is a folder" }
    "#]]
    .assert_eq(&shown);
}

/// Creates an empty folder on the real disk for the test called `test`.
fn fresh_folder(test: &str) -> Utf8PathBuf {
    let folder = Utf8PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::remove_dir_all(&folder).ok();
    folder
}

/// A case-insensitive disk, as on Windows and macOS.
#[derive(Debug)]
struct Insensitive(Memory);

impl Insensitive {
    /// Returns the path as spelt on the disk.
    fn actual(&self, path: &Utf8Path) -> Utf8PathBuf {
        path.components().fold(Utf8PathBuf::new(), |folder, part| {
            let names = self.0.list(&folder).unwrap_or_default();
            let name = names.into_iter().find(|name| name.eq_ignore_ascii_case(part.as_str()));
            folder.join(name.as_deref().unwrap_or(part.as_str()))
        })
    }
}

impl System for Insensitive {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        self.0.read(&self.actual(path), class)
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        self.0.size(&self.actual(path))
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        self.0.list(&self.actual(path))
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        self.0.kind(&self.actual(path))
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        self.actual(path)
    }
}

/// Creates an application that names a program, a library and a library prefix in other letter cases than the disk.
fn spelt_otherwise() -> Memory {
    let code = "<Programs><Program name=\"start\"><Code><![CDATA[begin\n  a0:libLoad(\"Disk://PARTS/p\"+\"1\")\nend]]></Code></Program></Programs>";
    Memory::new([
        ("/cell/UsrApp/App/App.pjx".to_owned(), manifest(&["Disk://LIB"]).replace("start.pgx", "START.pgx")),
        ("/cell/UsrApp/App/Start.PGX".to_owned(), code.to_owned()),
        ("/cell/UsrApp/Lib/lib.PJX".to_owned(), manifest(&[])),
        ("/cell/UsrApp/Lib/start.pgx".to_owned(), PROGRAM.to_owned()),
        ("/cell/UsrApp/Parts/P1/p1.pjx".to_owned(), manifest(&[])),
        ("/cell/UsrApp/Parts/P1/start.pgx".to_owned(), PROGRAM.to_owned()),
    ])
}

#[test]
fn files_have_the_spelling_of_the_disk() {
    let disk = spelt_otherwise();
    let systems: [&dyn System; 2] = [&disk, &Insensitive(disk.clone())];
    for system in systems {
        let workspace = load(system, &["/cell/UsrApp/App".into()]).unwrap();
        let db = &workspace.db;
        let files = val3_analysis::db::Sources::get(db).files(db);
        let mut names: Vec<&str> = files.values().filter_map(|file| file.path(db).file_name()).collect();
        names.sort_unstable();
        assert_eq!(names, ["App.pjx", "Start.PGX", "lib.PJX", "p1.pjx", "start.pgx", "start.pgx"]);
    }
}

#[test]
fn the_configuration_of_a_cell_is_found_in_any_letter_case() {
    let arm = "<arm><String name=\"arm\" value=\"ts60\" /></arm>";
    let files = [("/cell/usr/Configs/Arm.CFX", arm.to_owned()), ("/cell/usr/usrapp/app/app.pjx", manifest(&[]))];
    let workspace = load(&Memory::new(files), &["/cell".into()]).unwrap();
    assert_eq!(workspace.projects[0].cell_arm(&workspace.db), Some(val3_lang::types::Arm::Scara));
}

#[test]
fn projects_beside_usr_use_the_disk_of_their_cell() {
    let cell = [
        ("/cell/usr/usrapp/pal", &[][..]),
        ("/cell/tests/palTest", &["Disk://pal/pal.pjx", "../assert/assert.pjx"]),
        ("/cell/tests/assert", &[]),
        ("/cell/tests/stubs/part", &["Disk://pal"]),
    ];
    expect![[r#"
        /cell/tests/assert/assert.pjx on /cell/usr/usrapp
        /cell/tests/palTest/palTest.pjx on /cell/usr/usrapp
        /cell/tests/stubs/part/part.pjx on /cell/usr/usrapp
        /cell/usr/usrapp/pal/pal.pjx on /cell/usr/usrapp
    "#]]
    .assert_eq(&found(&disk(&cell), "/cell"));
    // A nearer folder with the same number of libraries takes precedence.
    let with_nearer = [&cell[..], &[("/cell/tests/pal", &[])]].concat();
    expect![[r#"
        /cell/tests/palTest/palTest.pjx on /cell/tests
    "#]]
    .assert_eq(&found(&disk(&with_nearer), "/cell/tests/palTest"));
    // The disk of a cell outside of the repository is not used.
    let mut files = files(&cell);
    files.push(("/cell/tests/.git/HEAD".to_owned(), String::new()));
    expect![[r#"
        /cell/tests/assert/assert.pjx on /cell/tests
        /cell/tests/palTest/palTest.pjx on ?
        /cell/tests/stubs/part/part.pjx on ?
        cell/tests/palTest/palTest.pjx:1 `Disk://pal/pal.pjx` UnresolvedPath { what: Library, path: "Disk://pal/pal.pjx", root: "Disk", near: None }
        cell/tests/stubs/part/part.pjx:1 `Disk://pal` UnresolvedPath { what: Library, path: "Disk://pal", root: "Disk", near: None }
    "#]]
    .assert_eq(&found(&Memory::new(files), "/cell/tests"));
}
