//! Pulls that must not destroy local files: from a wrong place, during edits, and with conflicts that cannot be merged.

use std::cell::Cell;
use std::fs;

use val3_controller::{
    ControllerAddress, ControllerError, ControllerPath, FileDifference, PullDecisions, PullRequest, PullResult,
    SideChange, SilentObserver, TransferObserver, TransferStep, check_identity, pull,
};

use crate::bench::{Bench, FILES, address, path, request, tree};
use crate::memory::MemoryFiles;

pub(crate) const START: &str = "usr/usrapp/demo/start.pgx";

/// A project that was pulled from a controller in memory.
pub(crate) fn bench() -> Bench<MemoryFiles> {
    let bench = Bench::with(MemoryFiles::new(tree(), false));
    bench.pull().unwrap();
    bench
}

/// Pulls with changed arguments.
fn pull_with<'a>(
    bench: &Bench<MemoryFiles>,
    observer: &mut dyn TransferObserver,
    change: impl FnOnce(PullRequest<'a>) -> PullRequest<'a>,
) -> Result<PullResult, ControllerError> {
    let (mut project, mut files) = (bench.project(), bench.server.clone());
    let identity = check_identity(&project, &address(), &mut files, false)?;
    pull(&mut project, &mut files, change(request(identity)), observer)
}

/// Changes a file of the controller; `None` removes it.
pub(crate) fn teach(bench: &Bench<MemoryFiles>, path: &str, text: Option<&str>) {
    let tree = &mut bench.server.state().tree;
    let key = format!("/{path}");
    match text {
        None => _ = tree.files.remove(&key),
        Some(text) => {
            let folders = std::iter::successors(key.rsplit_once('/'), |(folder, _)| folder.rsplit_once('/'));
            tree.folders.extend(folders.map(|(folder, _)| folder.to_owned()));
            tree.files.insert(key, text.into());
        }
    }
}

/// Local files without `.val3`.
fn local_files(bench: &Bench<MemoryFiles>) -> Vec<(ControllerPath, u64)> {
    let files = bench.project().local_files(&[path("usr")]).unwrap();
    files.into_iter().map(|(path, digest)| (path, digest.size)).collect()
}

#[test]
fn a_place_without_applications_is_no_controller() {
    let bench = bench();
    let before = (local_files(&bench), bench.text(".val3/controller.toml"));
    bench.server.state().tree.folders.remove("/usr/usrapp");
    bench.server.state().tree.files.retain(|path, _| !path.contains("usrapp"));
    let error = bench.pull().unwrap_err();
    assert_eq!(error, ControllerError::NoApplications { place: "memory".into() });
    assert_eq!((local_files(&bench), bench.text(".val3/controller.toml")), before);
}

#[test]
fn an_application_is_removed_only_if_this_is_accepted() {
    for removed in ["/usr/usrapp/", "/usr/usrapp/tools/"] {
        let bench = bench();
        let before = local_files(&bench);
        bench.server.state().tree.files.retain(|path, _| !path.starts_with(removed));
        bench.server.state().tree.folders.retain(|path| !path.starts_with(removed));
        let Err(ControllerError::RemovesFolders(folders)) = bench.pull() else { panic!("{removed} is removed here") };
        let tools = (path("usr/usrapp/tools"), 2);
        assert_eq!(
            folders,
            if removed.ends_with("tools/") { vec![tools] } else { vec![(path("usr/usrapp/demo"), 3), tools] }
        );
        assert_eq!(local_files(&bench), before);
        let pulled =
            pull_with(&bench, &mut SilentObserver, |request| PullRequest { accepts_removals: true, ..request });
        assert_eq!(pulled.unwrap().removed.len(), folders.iter().map(|(_, files)| files).sum::<usize>());
        assert!(!bench.folder.join("usr/usrapp/tools").exists() && bench.status().unwrap().differences.is_empty());
    }
}

#[test]
fn a_removed_application_in_a_folder_of_others_is_named() {
    let bench = bench();
    teach(&bench, "usr/usrapp/types/Slot/Slot.pjx", Some("<Project/>"));
    teach(&bench, "usr/usrapp/types/Part/Part.pjx", Some("<Project/>"));
    bench.pull().unwrap();
    teach(&bench, "usr/usrapp/types/Slot/Slot.pjx", None);
    assert_eq!(bench.pull(), Err(ControllerError::RemovesFolders(vec![(path("usr/usrapp/types/Slot"), 1)])));
}

#[test]
fn a_wrong_name_of_an_application_is_not_an_empty_application() {
    let bench = Bench::with(MemoryFiles::new(tree(), false));
    let wrong = path("usr/usrapp/Demo");
    let pulled =
        pull_with(&bench, &mut SilentObserver, |request| PullRequest { folders: vec![wrong.clone()], ..request });
    let present = vec!["demo".to_owned(), "tools".to_owned()];
    assert_eq!(pulled, Err(ControllerError::NoApplication { folder: wrong, present }));
    assert!(!bench.folder.join(".val3/controller.toml").exists());
}

#[test]
fn without_a_serial_number_the_address_identifies_the_controller() {
    let bench = Bench::with(MemoryFiles::new(tree(), false));
    teach(&bench, FILES[0].0.trim_start_matches('/'), None);
    bench.pull().unwrap();
    let check = |text: &str, accepts_new| {
        let address = ControllerAddress::parse(text).unwrap();
        check_identity(&bench.project(), &address, &mut bench.server.clone(), accepts_new)
    };
    check("ftp://maintenance@ROBOT", false).unwrap();
    for other in ["ftp://robot:2121", "ftp://robot/cell", "ftp://other", "robot"] {
        let error = ControllerError::OtherAddress { expected: address().to_string() };
        assert_eq!(check(other, false), Err(error), "{other}");
        check(other, true).unwrap();
    }
}

/// Saves a file in an editor at one of the observer's calls.
struct Editor<'a> {
    /// Number of calls before; `None` after the file was saved.
    calls_before: Cell<Option<usize>>,
    save: &'a dyn Fn(),
}

impl Editor<'_> {
    fn call(&self) {
        if self.calls_before.get() == Some(0) {
            (self.save)();
        }
        self.calls_before.set(self.calls_before.get().and_then(|calls| calls.checked_sub(1)));
    }
}

impl TransferObserver for Editor<'_> {
    fn step(&mut self, _: TransferStep, _: usize) {
        self.call();
    }

    fn file(&mut self, _: &ControllerPath, _: u64) {
        self.call();
    }

    fn is_interrupted(&self) -> bool {
        false
    }
}

/// The law: what the user saves during a pull is in the local file afterwards, and a conflict if the controller has
/// changed the file, too.
#[test]
fn a_file_that_is_saved_during_a_pull_is_kept() {
    for (file, text) in [(START, Some("theirs")), (START, None), ("usr/usrapp/demo/new.pgx", Some("theirs"))] {
        for calls_before in 0.. {
            let bench = bench();
            teach(&bench, file, text);
            let save = || bench.write(file, "saved");
            let mut editor = Editor { calls_before: Cell::new(Some(calls_before)), save: &save };
            let pulled = pull_with(&bench, &mut editor, |request| request);
            if editor.calls_before.get().is_some() {
                // The pull has fewer calls.
                assert!(calls_before >= 6 && pulled.is_ok());
                break;
            }
            assert_eq!(pulled, Err(ControllerError::Conflicts(vec![path(file)])), "{file} at {calls_before}");
            assert_eq!(bench.text(file), "saved");
        }
    }
}

#[test]
fn files_that_are_saved_during_a_merge_are_kept() {
    let (data, added) = ("usr/usrapp/demo/demo.dtx", "usr/usrapp/demo/new.pgx");
    let bench = bench();
    bench.write(START, "mine");
    for (file, text) in
        [(START, Some("theirs")), (data, Some("theirs")), (added, Some("theirs")), ("usr/usrapp/tools/grip.pgx", None)]
    {
        teach(&bench, file, text);
    }
    let files = [START, data, added, "usr/usrapp/tools/grip.pgx"];
    let mut merge = |_: &_, _: &_| {
        files.iter().for_each(|file| bench.write(file, "saved"));
        Some(b"merged".to_vec())
    };
    let pulled = pull_with(&bench, &mut SilentObserver, |request| PullRequest { merge: Some(&mut merge), ..request });
    let mut expected = files.map(path).to_vec();
    expected.sort();
    assert_eq!(pulled.unwrap().changed_meanwhile, expected);
    files.iter().for_each(|file| assert_eq!(bench.text(file), "saved"));
    let differences = bench.status().unwrap().differences;
    assert!(differences.len() == 4 && differences.values().all(|one| matches!(one, FileDifference::Conflict { .. })));
}

#[test]
fn a_conflict_that_cannot_be_merged_remains_until_it_is_decided() {
    let conflicts =
        |bench: &Bench<MemoryFiles>| ControllerError::Conflicts(vec![path(START)]) == bench.plan().unwrap_err();
    for is_local in [true, false] {
        let bench = bench();
        bench.write(START, "mine");
        teach(&bench, START, Some("theirs"));
        teach(&bench, "usr/usrapp/demo/demo.dtx", Some("theirs"));
        let mut merge = |_: &_, _: &_| None;
        let pulled =
            pull_with(&bench, &mut SilentObserver, |request| PullRequest { merge: Some(&mut merge), ..request })
                .unwrap();
        assert_eq!((pulled.unmerged, pulled.merged), (vec![path(START)], Vec::new()));
        assert_eq!((bench.text(START).as_str(), bench.text("usr/usrapp/demo/demo.dtx").as_str()), ("mine", "theirs"));
        assert!(conflicts(&bench) && bench.pull().is_err());
        let side = vec![path("usr/usrapp/demo")];
        let both = PullDecisions { local: vec![path(START)], controller: side.clone() };
        let twice = pull_with(&bench, &mut SilentObserver, |request| PullRequest { decisions: both, ..request });
        assert_eq!((twice, bench.text(START).as_str()), (Err(ControllerError::DecidedTwice(path(START))), "mine"));
        let decisions = match is_local {
            true => PullDecisions { local: side, ..PullDecisions::default() },
            false => PullDecisions { controller: side, ..PullDecisions::default() },
        };
        pull_with(&bench, &mut SilentObserver, |request| PullRequest { decisions, ..request }).unwrap();
        assert_eq!(bench.text(START), if is_local { "mine" } else { "theirs" });
        let expected = is_local.then_some((path(START), FileDifference::Local(SideChange::Modified)));
        assert_eq!(bench.status().unwrap().differences.into_iter().next(), expected);
    }
}

#[test]
fn a_decision_restores_files_that_were_removed_here() {
    let bench = bench();
    fs::remove_dir_all(bench.folder.join("usr")).unwrap();
    let decide = |folder: &str| {
        let decisions = PullDecisions { controller: vec![path(folder)], ..PullDecisions::default() };
        pull_with(&bench, &mut SilentObserver, |request| PullRequest { decisions, ..request })
    };
    assert_eq!(decide("usr/usrapp").unwrap().updated.len(), 5);
    assert!(bench.status().unwrap().differences.is_empty());
    assert_eq!(decide("usr/usrapp/demo"), Err(ControllerError::NoConflict(path("usr/usrapp/demo"))));
}
