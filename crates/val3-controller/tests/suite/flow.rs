//! Pull, status and push without failures.

use std::fs;

use expect_test::expect;
use val3_controller::{
    ControllerError, ControllerProject, FileDifference, FolderFiles, ProjectStatus, PullRequest, PushPlan, SideChange,
    SilentObserver, check_identity, pull, read_file,
};

use crate::bench::{Bench, FILES, address, path, pull_from, request, shown, tree};
use crate::server::{Behaviour, ListForm};

const FORMS: [ListForm; 5] = [ListForm::Mlsd, ListForm::Unix, ListForm::Dos, ListForm::Names, ListForm::Paths];

#[test]
fn a_change_goes_to_the_controller_and_back() {
    for form in FORMS {
        for keeps_targets in [false, true] {
            let bench = Bench::pulled(Behaviour { form, keeps_targets, ..Behaviour::default() });
            assert!(bench.status().unwrap().differences.is_empty());
            bench.edit();
            bench.push().unwrap();
            expect![[r#"
                /usr/configs/controller.cfx: <controller><String name="serialNumber" value="F10-1"/></controller>
                /usr/usrapp/demo/demo.dtx: <Database>2</Database>
                /usr/usrapp/demo/demo.pjx: <Project version="2"/>
                /usr/usrapp/demo/start.pgx: start 2
                /usr/usrapp/new/inner/new.pjx: <Project/>
                /usr/usrapp/tools/tools.pjx: <Project/>
            "#]]
            .assert_eq(&shown(&bench.server.state().tree));
            assert!(bench.status().unwrap().differences.is_empty(), "{form:?}");
            assert!(bench.recover().unwrap().is_empty());
            let copy = tempfile::tempdir().unwrap();
            let copy = camino::Utf8Path::from_path(copy.path()).unwrap();
            pull_from(copy, &mut bench.server.connect()).unwrap();
            assert_eq!(fs::read(copy.join("usr/usrapp/demo/start.pgx")).unwrap(), b"start 2");
        }
    }
}

#[test]
fn one_file_is_read_or_missing() {
    for form in FORMS {
        let bench = Bench::pulled(Behaviour { form, ..Behaviour::default() });
        let mut files = bench.server.connect();
        let tree = bench.server.state().tree.clone();
        assert_eq!(
            read_file(&mut files, &path("usr/usrapp/demo/start.pgx")).as_ref(),
            Ok(&tree.files["/usr/usrapp/demo/start.pgx"])
        );
        for missing in ["usr/usrapp/demo/none.pgx", "usr/none/start.pgx", "none"].map(path) {
            assert_eq!(read_file(&mut files, &missing), Err(ControllerError::Missing(missing)), "{form:?}");
        }
    }
}

#[test]
fn the_plan_has_libraries_first_and_project_files_last() {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    bench.write(
        "usr/usrapp/demo/demo.pjx",
        "<Project version=\"2\"><Library path=\"Disk://tools/tools.pjx\"/></Project>",
    );
    bench.write("usr/usrapp/tools/tools.pjx", "<Project version=\"2\"/>");
    bench.write("usr/usrapp/tools/open.pgx", "open");
    let plan = bench.plan().unwrap();
    let lines: Vec<String> = plan
        .changes
        .iter()
        .map(|change| {
            let verb = match (&change.old, &change.new) {
                (None, _) => "add",
                (_, None) => "remove",
                _ => "replace",
            };
            format!("{verb} {}\n", change.path)
        })
        .collect();
    expect![[r#"
        add usr/usrapp/tools/open.pgx
        replace usr/usrapp/demo/demo.dtx
        replace usr/usrapp/demo/start.pgx
        add usr/usrapp/new/inner/new.pjx
        replace usr/usrapp/tools/tools.pjx
        replace usr/usrapp/demo/demo.pjx
        remove usr/usrapp/tools/grip.pgx
    "#]]
    .assert_eq(&lines.concat());
    assert_eq!(plan.applications(), ["demo", "new", "tools"]);
}

#[test]
fn a_removed_application_leaves_no_folder() {
    let bench = Bench::pulled(Behaviour::default());
    fs::remove_dir_all(bench.folder.join("usr/usrapp/tools")).unwrap();
    bench.push().unwrap();
    let state = bench.server.state();
    assert!(!state.tree.folders.contains("/usr/usrapp/tools") && state.tree.folders.contains("/usr/usrapp/demo"));
}

/// A clone with only `.val3/controller.toml`, or with project files that were moved, must not empty the controller.
#[test]
fn a_push_that_leaves_no_application_is_refused() {
    let remove = |bench: &Bench, paths: &[&str]| {
        for path in paths.iter().map(|path| bench.folder.join(path)) {
            if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) }.unwrap();
        }
    };
    for (removed, count) in [
        (&["usr"][..], 5),
        (&["usr/usrapp/demo", "usr/usrapp/tools"], 5),
        (&["usr/usrapp/demo/demo.pjx", "usr/usrapp/tools/tools.pjx"], 2),
    ] {
        let bench = Bench::pulled(Behaviour::default());
        remove(&bench, removed);
        assert_eq!(bench.plan().unwrap_err(), ControllerError::NoApplicationLeft(count), "{removed:?}");
        let selection = [path("usr/usrapp/demo")];
        PushPlan::new(&bench.project(), &bench.status().unwrap(), &selection).unwrap_err();
    }
    let bench = Bench::pulled(Behaviour::default());
    remove(&bench, &["usr/usrapp/tools/tools.pjx"]);
    let plan = bench.plan().unwrap();
    assert_eq!(plan.removed_applications, [path("usr/usrapp/tools")].into());
    assert_eq!(plan.remaining_applications(), Vec::<String>::new());
    bench.write("usr/usrapp/demo/start.pgx", "start 2");
    remove(&bench, &["usr/usrapp/tools"]);
    assert_eq!(bench.plan().unwrap().remaining_applications(), ["demo"]);
}

/// The repository and the tools of either side stay there.
#[test]
fn repositories_are_not_transferred() {
    let bench = Bench::pulled(Behaviour::default());
    for name in [".git/config", ".git/objects/ab/cdef", "demo/.svn/entries", "demo/Thumbs.db"] {
        bench.write(&format!("usr/usrapp/{name}"), "x");
    }
    bench.write("usr/usrapp/demo/start.pgx", "start 2");
    let changes: Vec<String> = bench.plan().unwrap().changes.into_iter().map(|change| change.path.into()).collect();
    assert_eq!(changes, ["usr/usrapp/demo/start.pgx"]);
    bench.push().unwrap();
    assert_eq!(bench.server.state().tree.folders, tree().folders);
    let mut controller = bench.server.state().tree.clone();
    controller.folders.insert("/usr/usrapp/.hg".into());
    controller.files.insert("/usr/usrapp/.hg/store".into(), b"x".to_vec());
    bench.server.state().tree = controller;
    assert!(bench.status().unwrap().differences.is_empty());
}

#[test]
fn a_push_removes_no_settings() {
    let bench = Bench::pulled(Behaviour::default());
    bench.server.state().tree.files.insert("/usr/configs/sio.cfx".into(), b"<sio/>".to_vec());
    bench.server.state().tree.files.remove("/usr/configs/controller.cfx");
    let folders = [path("usr/configs"), path("usr/usrapp")];
    let mut project = bench.project();
    let mut files = bench.server.connect();
    let identity = check_identity(&project, &address(), &mut files, true).unwrap();
    let request = PullRequest { folders: folders.to_vec(), ..request(identity) };
    pull(&mut project, &mut files, request, &mut SilentObserver).unwrap();
    fs::remove_dir_all(bench.folder.join("usr/configs")).unwrap();
    let status = ProjectStatus::read(&project, &mut files, &folders, &mut SilentObserver).unwrap();
    let error = PushPlan::new(&project, &status, &folders[..1]).unwrap_err();
    assert_eq!(error, ControllerError::RemovesSettings(vec![path("usr/configs/sio.cfx")]));
}

#[test]
fn nothing_is_written_until_all_files_are_uploaded() {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    bench.server.behave(Behaviour::default());
    bench.push().unwrap();
    let state = bench.server.state();
    let writes = |line: &&String| ["STOR", "RNTO", "DELE"].iter().any(|verb| line.starts_with(verb));
    let writes: Vec<&str> = state.log.iter().filter(writes).map(String::as_str).collect();
    let first_rename = writes.iter().position(|line| line.starts_with("RNTO")).unwrap();
    assert!(writes[..first_rename].iter().all(|line| line.starts_with("STOR") && !line.ends_with("pjx")));
    assert!(writes[first_rename..].iter().all(|line| !line.starts_with("STOR")));
    assert_eq!(writes.last(), Some(&"DELE /usr/usrapp/val3.lock"));
    assert_eq!(state.log.last().map(String::as_str), Some("QUIT"));
}

#[test]
fn a_pull_keeps_local_changes() {
    let bench = Bench::pulled(Behaviour::default());
    bench.write("usr/usrapp/demo/start.pgx", "mine");
    bench.write("usr/usrapp/demo/notes.txt", "mine");
    bench.server.state().tree.files.insert("/usr/usrapp/demo/demo.dtx".into(), b"theirs".to_vec());
    bench.server.state().tree.files.remove("/usr/usrapp/tools/grip.pgx");
    let pulled = bench.pull().unwrap();
    assert_eq!(
        pulled.status.differences.into_iter().collect::<Vec<_>>(),
        [
            (path("usr/usrapp/demo/demo.dtx"), FileDifference::Controller(SideChange::Modified)),
            (path("usr/usrapp/demo/notes.txt"), FileDifference::Local(SideChange::Added)),
            (path("usr/usrapp/demo/start.pgx"), FileDifference::Local(SideChange::Modified)),
            (path("usr/usrapp/tools/grip.pgx"), FileDifference::Controller(SideChange::Removed)),
        ]
    );
    assert_eq!(bench.text("usr/usrapp/demo/demo.dtx"), "theirs");
    assert_eq!(bench.text("usr/usrapp/demo/start.pgx"), "mine");
    assert!(!bench.folder.join("usr/usrapp/tools/grip.pgx").exists());
    assert_eq!(bench.status().unwrap().differences.len(), 2);
}

#[test]
fn a_conflict_stops_both_directions_until_it_is_merged() {
    let bench = Bench::pulled(Behaviour::default());
    bench.write("usr/usrapp/demo/start.pgx", "mine");
    bench.server.state().tree.files.insert("/usr/usrapp/demo/start.pgx".into(), b"theirs".to_vec());
    bench.server.state().tree.files.insert("/usr/usrapp/demo/demo.dtx".into(), b"theirs".to_vec());
    let conflict = ControllerError::Conflicts(vec![path("usr/usrapp/demo/start.pgx")]);
    assert_eq!(bench.pull().unwrap_err(), conflict);
    assert_eq!(bench.text("usr/usrapp/demo/demo.dtx"), "<Database>1</Database>");
    assert_eq!(bench.plan().unwrap_err(), conflict);
    let (mut project, mut files) = (bench.project(), bench.server.connect());
    let identity = check_identity(&project, &address(), &mut files, false).unwrap();
    let mut merge = |_: &_, versions: &val3_controller::ConflictVersions| {
        Some([versions.base.as_deref().unwrap(), &versions.local, &versions.controller].join(&b'+'))
    };
    let request = PullRequest { merge: Some(&mut merge), ..request(identity) };
    let merged = pull(&mut project, &mut files, request, &mut SilentObserver).unwrap().merged;
    assert_eq!(merged, [path("usr/usrapp/demo/start.pgx")]);
    bench.push().unwrap();
    let state = bench.server.state();
    assert_eq!(state.tree.files["/usr/usrapp/demo/start.pgx"], b"start+mine+theirs");
    assert_eq!(state.tree.files["/usr/usrapp/demo/demo.dtx"], b"theirs");
}

/// Without the version of the last pull, a removal by one side would look like an addition by the other.
#[test]
fn a_conflict_has_no_base_after_the_loss_of_its_copy() {
    let bench = Bench::pulled(Behaviour::default());
    fs::remove_dir_all(bench.folder.join(".val3/base")).unwrap();
    for name in ["demo/new.pgx", "demo/start.pgx"] {
        bench.write(&format!("usr/usrapp/{name}"), "mine");
        bench.server.state().tree.files.insert(format!("/usr/usrapp/{name}"), b"theirs".to_vec());
    }
    let (mut project, mut files) = (bench.project(), bench.server.connect());
    let identity = check_identity(&project, &address(), &mut files, false).unwrap();
    let mut bases = Vec::new();
    let mut merge = |_: &_, versions: &val3_controller::ConflictVersions| {
        bases.push(versions.base.clone());
        None
    };
    let request = PullRequest { merge: Some(&mut merge), ..request(identity) };
    let unmerged = pull(&mut project, &mut files, request, &mut SilentObserver).unwrap().unmerged;
    assert_eq!(unmerged, [path("usr/usrapp/demo/new.pgx"), path("usr/usrapp/demo/start.pgx")]);
    assert_eq!(bases, [Some(Vec::new()), None]);
}

#[test]
fn a_change_on_the_controller_stops_a_push() {
    let bench = Bench::pulled(Behaviour::default());
    bench.write("usr/usrapp/demo/start.pgx", "mine");
    bench.server.state().tree.files.insert("/usr/usrapp/demo/demo.dtx".into(), b"theirs".to_vec());
    assert_eq!(bench.plan().unwrap_err(), ControllerError::Outdated(vec![path("usr/usrapp/demo/demo.dtx")]));
}

#[test]
fn another_controller_is_recognised() {
    let bench = Bench::pulled(Behaviour::default());
    let text = FILES[0].1.replace("F10-1", "F10-2").into_bytes();
    bench.server.state().tree.files.insert(FILES[0].0.into(), text);
    let error = bench.pull().unwrap_err();
    expect!["this is another controller: its serial number is F10-2, and at the last pull it was F10-1"]
        .assert_eq(&error.to_string());
}

#[test]
fn a_folder_is_a_controller_too() {
    let bench = Bench::pulled(Behaviour::default());
    let emulator = tempfile::tempdir().unwrap();
    let emulator = camino::Utf8Path::from_path(emulator.path()).unwrap();
    for (path, text) in FILES {
        let path = emulator.join(path.trim_start_matches('/'));
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let mut files = FolderFiles::open(emulator).unwrap();
    pull_from(&bench.folder, &mut files).unwrap();
    assert_eq!(ControllerProject::open(&bench.folder).unwrap().state.unwrap().files.len(), 5);
    assert_eq!(tree().files.len(), 6);
}
