use super::*;
use crate::files::volume::{LARGEST, relative};

/// A medium `Disk` in a separate folder, next to `secret`.
fn disk() -> (tempfile::TempDir, Utf8PathBuf, Roots) {
    let folder = tempfile::tempdir().unwrap();
    let outer = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
    std::fs::create_dir_all(outer.join("usr/usrapp/Parts/bolt")).unwrap();
    std::fs::write(outer.join("usr/usrapp/Parts/bolt/Bolt.PJX"), "pjx").unwrap();
    std::fs::write(outer.join("secret"), "secret").unwrap();
    let mut roots = Roots::default();
    roots.mount("Disk", &outer.join("usr/usrapp")).unwrap();
    (folder, outer, roots)
}

fn place(roots: &Roots, text: &str) -> Result<(String, EntryKind), u16> {
    let application = ControllerPath::root("Disk").join("Parts").unwrap();
    let found = ControllerPath::parse(text, &application).and_then(|path| roots.place(&path));
    let shown = found.and_then(|place| Ok((relative(&place.path).to_string(), place.kind()?)));
    shown.map_err(FileFault::code)
}

#[test]
fn letter_case_is_ignored() {
    let (_folder, _, roots) = disk();
    let bolt = Ok(("Parts/bolt/Bolt.PJX".to_owned(), EntryKind::File));
    assert_eq!(place(&roots, "disk://PARTS/Bolt/bolt.pjx"), bolt);
    assert_eq!(place(&roots, "./BOLT/Bolt.PJX"), bolt);
    assert_eq!(place(&roots, "parts/nut/x"), Ok(("Parts/nut/x".to_owned(), EntryKind::Missing)));
    assert_eq!(place(&roots, "Disk://"), Ok((".".to_owned(), EntryKind::Folder)));
}

#[test]
fn the_same_spelling_wins() {
    let (_folder, outer, roots) = disk();
    for name in ["nut", "NUT", "Nut"] {
        std::fs::write(outer.join("usr/usrapp").join(name), name).unwrap();
    }
    let name = |text| place(&roots, text).unwrap().0;
    assert_eq!((name("Nut").as_str(), name("nut").as_str(), name("nUt").as_str()), ("Nut", "nut", "NUT"));
}

#[test]
fn unknown_media() {
    let (_folder, _, roots) = disk();
    assert_eq!(place(&roots, "USB0://x"), Err(20));
    assert_eq!(place(&roots, "ftpServer://x"), Err(20));
    assert_eq!(place(&roots, "://x"), Err(20));
}

#[test]
fn parent_steps_cannot_leave_the_medium() {
    let (_folder, _, roots) = disk();
    for path in
        ["Disk://../../etc", "Disk://..", "../..", "a/../../usrapp/Parts", "Disk://../usrapp", "../../../secret"]
    {
        assert_eq!(place(&roots, path), Err(21), "{path}");
    }
    assert_eq!(place(&roots, "/etc/passwd"), Ok(("etc/passwd".to_owned(), EntryKind::Missing)));
}

#[test]
fn a_cell_has_a_folder_above() {
    let (_folder, outer, mut roots) = disk();
    roots.mount_disk(&outer.join("usr/usrapp")).unwrap();
    assert_eq!(place(&roots, "Disk://parts").unwrap().0, "usrapp/Parts");
    assert_eq!(place(&roots, "Disk://..//templates/x").unwrap().0, "templates/x");
    assert_eq!(place(&roots, "Disk://../../secret"), Err(21));
    roots.mount_disk(&outer.join("usr")).unwrap();
    assert_eq!(place(&roots, "Disk://../secret"), Err(21));
}

#[cfg(unix)]
#[test]
fn links_cannot_leave_the_medium() {
    let (_folder, outer, roots) = disk();
    let parts = outer.join("usr/usrapp/Parts");
    std::os::unix::fs::symlink(outer.join("secret"), parts.join("absolute")).unwrap();
    std::os::unix::fs::symlink("../../..", parts.join("up")).unwrap();
    std::os::unix::fs::symlink("bolt", parts.join("inside")).unwrap();
    assert_eq!(place(&roots, "./absolute"), Err(21));
    assert_eq!(place(&roots, "./up/secret"), Err(21));
    assert_eq!(place(&roots, "./inside/bolt.pjx").unwrap().1, EntryKind::File);
}

#[test]
fn a_file_is_no_folder() {
    let (_folder, _, roots) = disk();
    assert_eq!(place(&roots, "parts/bolt/bolt.pjx/x"), Err(21));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_not_waited_for() {
    let (_folder, outer, roots) = disk();
    let pipe = outer.join("usr/usrapp/pipe");
    rustix::fs::mkfifoat(rustix::fs::CWD, pipe.as_std_path(), rustix::fs::Mode::RUSR).unwrap();
    assert_eq!(place(&roots, "pipe"), Err(21));
}

#[test]
fn a_file_of_any_size_is_refused() {
    let (_folder, outer, roots) = disk();
    std::fs::File::create(outer.join("usr/usrapp/huge")).unwrap().set_len(LARGEST + 1).unwrap();
    let huge = roots.place(&ControllerPath::root("Disk").join("huge").unwrap()).unwrap();
    assert_eq!(huge.read(), Err(FileFault::Medium));
}

proptest::proptest! {
    /// Any path in a program resolves to a location inside the medium.
    #[test]
    fn no_path_leaves_its_medium(parts in proptest::collection::vec(
        proptest::sample::select(vec!["..", ".", "/", "\\\\", "//", "Disk://", "USB0:", "parts", "Bolt", "~", " ", "\0", "secret", "up"]),
        0..12,
    )) {
        let (_folder, outer, roots) = disk();
        #[cfg(unix)]
        std::os::unix::fs::symlink("../../..", outer.join("usr/usrapp/Parts/up")).unwrap();
        let path = ControllerPath::parse(&parts.concat(), &ControllerPath::root("Disk").join("parts").unwrap());
        let Ok(place) = path.and_then(|path| roots.place(&path)) else { return Ok(()) };
        proptest::prop_assert!(place.path.is_relative());
        proptest::prop_assert!(place.path.components().all(|part| part.as_str() != ".."));
        if let Ok(bytes) = place.read() {
            proptest::prop_assert_ne!(bytes, b"secret");
        }
    }
}
