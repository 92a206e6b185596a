use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use proptest::prelude::*;

use crate::files::{
    ControllerPath, FileFault, LibraryFile, LibraryFiles, LibraryPath, OpenFiles, OpenMode, Roots, Uninterrupted, copy,
    delete, file_exists, list, rename,
};
use crate::inputs::Inputs;

/// Two media with some files, on the disk or covered.
struct Media {
    _folder: tempfile::TempDir,
    outer: Utf8PathBuf,
    roots: Roots,
    files: OpenFiles,
}

impl Media {
    fn on_disk() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let outer = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        for (name, text) in [("disk/a", "a"), ("disk/d/b", "b\n"), ("disk/d/e/c", ""), ("usb/u", "u")] {
            std::fs::create_dir_all(outer.join(name).parent().unwrap()).unwrap();
            std::fs::write(outer.join(name), text).unwrap();
        }
        let mut roots = Roots::default();
        roots.mount("Disk", &outer.join("disk")).unwrap();
        roots.mount("USB0", &outer.join("usb")).unwrap();
        Self { _folder: folder, outer, roots, files: OpenFiles::default() }
    }

    fn covered() -> Self {
        let mut media = Self::on_disk();
        assert!(media.roots.cover(&Inputs::default(), 1 << 20));
        media
    }

    fn path(text: &str) -> ControllerPath {
        ControllerPath::parse(text, &ControllerPath::root("Disk")).unwrap()
    }

    fn library(text: &str) -> LibraryPath {
        LibraryPath::new(&Self::path(text)).unwrap()
    }

    fn apply(&mut self, action: &Action) -> String {
        let Self { roots, files, .. } = self;
        let code = |result: Result<(), FileFault>| result.map_or_else(FileFault::code, |()| 0).to_string();
        match action {
            Action::Open(path, mode) => {
                format!("{:?}", files.open(roots, &Self::path(path), *mode).map_err(FileFault::code))
            }
            Action::Write(file, text) => files.write_lines(*file, [text.as_str(), ""]).to_string(),
            Action::Close(file) => code(files.close(*file)),
            Action::Read(path) => match files.open(roots, &Self::path(path), OpenMode::Read) {
                Ok(file) => {
                    let lines = files.lines(file, 100);
                    files.close(file).unwrap();
                    lines.join("|")
                }
                Err(fault) => fault.code().to_string(),
            },
            Action::Delete(path) => code(delete(roots, &Self::path(path))),
            Action::Copy(from, to) => code(copy(roots, &Self::path(from), &Self::path(to))),
            Action::Rename(from, to) => code(rename(roots, &Self::path(from), &Self::path(to))),
            Action::List(path) => {
                let exists = file_exists(roots, &Self::path(path)).map_err(FileFault::code);
                format!("{:?} {exists:?}", list(roots, &Self::path(path)).map_err(FileFault::code))
            }
            Action::SaveAs(path, text) => code(Self::library(path).save_as(roots, &saved(text), &mut Uninterrupted)),
            Action::Save(path, text) => code(
                Self::library(path)
                    .read(roots, "")
                    .and_then(|old| Self::library(path).save(roots, &old, &saved(text), &mut Uninterrupted)),
            ),
            Action::DeleteLibrary(path) => code(Self::library(path).delete(roots)),
        }
    }

    fn close(&mut self) {
        (0..10).for_each(|file| _ = self.files.close(file));
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.outer.join(name), text).unwrap();
    }

    fn text(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.outer.join(name)).ok()
    }

    /// Contents of all files on the disk, by path; folders end with `/`.
    fn listing(&self) -> BTreeMap<String, Vec<u8>> {
        let mut found = BTreeMap::new();
        let mut open = vec![self.outer.clone()];
        while let Some(folder) = open.pop() {
            for entry in folder.read_dir_utf8().unwrap() {
                let path = entry.unwrap().into_path();
                let name = path.strip_prefix(&self.outer).unwrap().as_str().replace('\\', "/");
                if path.is_dir() {
                    found.insert(name + "/", Vec::new());
                    open.push(path);
                } else {
                    found.insert(name, std::fs::read(path).unwrap());
                }
            }
        }
        found
    }
}

fn saved(text: &str) -> LibraryFiles {
    let project = "<Project><Database><Data file=\"x.dtx\" /></Database></Project>";
    let file = |path: &str, text: &str| LibraryFile { path: path.into(), bytes: text.into() };
    LibraryFiles { files: vec![file("lib.pjx", project), file("x.dtx", text)], encrypted: false }
}

#[derive(Debug, Clone)]
enum Action {
    Open(&'static str, OpenMode),
    Write(usize, String),
    Close(usize),
    Read(&'static str),
    Delete(&'static str),
    Copy(&'static str, &'static str),
    Rename(&'static str, &'static str),
    List(&'static str),
    SaveAs(&'static str, String),
    Save(&'static str, String),
    DeleteLibrary(&'static str),
}

fn actions() -> impl Strategy<Value = Vec<Action>> {
    let paths =
        ["a", "A", "a/x", "d", "d/b", "d/e", "d/e/c", "d/new", "n", "n/x", "lib", "lib/x.dtx", "USB0://u", "USB0://d"];
    let path = || prop::sample::select(paths.to_vec());
    let text = || prop::sample::select(vec!["", "one", "two lines\nof text"]).prop_map(str::to_owned);
    let action = prop_oneof![
        3 => (path(), prop::sample::select(vec![OpenMode::Write, OpenMode::Append])).prop_map(|(path, mode)| Action::Open(path, mode)),
        3 => (0..3_usize, text()).prop_map(|(file, text)| Action::Write(file, text)),
        3 => (0..3_usize).prop_map(Action::Close),
        2 => path().prop_map(Action::Delete),
        3 => (path(), path()).prop_map(|(from, to)| Action::Copy(from, to)),
        4 => (path(), path()).prop_map(|(from, to)| Action::Rename(from, to)),
        2 => path().prop_map(Action::List),
        1 => (path(), text()).prop_map(|(path, text)| Action::SaveAs(path, text)),
        1 => (path(), text()).prop_map(|(path, text)| Action::Save(path, text)),
        1 => path().prop_map(Action::DeleteLibrary),
    ];
    prop::collection::vec((action, path()), 0..24).prop_map(|actions| {
        // An open file is not written through a second handle: the disk mixes the contents.
        let mut all = Vec::new();
        for (action, read) in actions {
            if let Action::Open(..) | Action::Copy(..) = action {
                all.extend((0..10).map(Action::Close));
            }
            all.extend([action, Action::Read(read)]);
        }
        all
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// File operations of a program have the same results in an overlay and on the disk, and so has the disk after the
    /// overlay was written. Until then the disk is unchanged.
    #[test]
    fn a_written_overlay_is_what_the_disk_would_be(actions in actions()) {
        let (mut disk, mut covered) = (Media::on_disk(), Media::covered());
        let before = covered.listing();
        for action in &actions {
            let (expected, found) = (disk.apply(action), covered.apply(action));
            prop_assert_eq!(found, expected, "{:?}", action);
        }
        disk.close();
        covered.close();
        prop_assert_eq!(covered.listing(), before);
        prop_assert_eq!(covered.roots.write(), Vec::<String>::new());
        prop_assert_eq!(covered.listing(), disk.listing());
    }

    /// Restoring a copy undoes all later changes.
    #[test]
    fn a_copy_can_be_returned_to(first in actions(), second in actions()) {
        let (mut once, mut twice) = (Media::covered(), Media::covered());
        for action in &first {
            once.apply(action);
            twice.apply(action);
        }
        let (overlay, files) = (twice.roots.overlay(), twice.files.copy());
        second.iter().for_each(|action| drop(twice.apply(action)));
        twice.roots.restore(overlay);
        twice.files = files;
        for action in &first {
            prop_assert_eq!(twice.apply(action), once.apply(action), "{:?}", action);
        }
        once.roots.write();
        twice.roots.write();
        prop_assert_eq!(twice.listing(), once.listing());
    }
}

/// A library is saved by moving its files into place; the disk moves no file over a folder.
#[test]
fn no_file_takes_the_place_of_a_folder() {
    let (mut disk, mut covered) = (Media::on_disk(), Media::covered());
    let save = |path| Action::SaveAs(path, String::new());
    for action in [Action::Copy("d", "lib"), save("lib/x.dtx"), save("lib")] {
        assert_eq!(covered.apply(&action), disk.apply(&action), "{action:?}");
    }
}

fn write(media: &mut Media, path: &str, mode: OpenMode, text: &str) {
    let file = media.files.open(&media.roots, &Media::path(path), mode).unwrap();
    assert_eq!(media.files.write_bytes(file, text.as_bytes()), text.len());
    media.files.close(file).unwrap();
}

#[test]
fn a_file_that_something_else_has_changed_stays() {
    let mut media = Media::covered();
    write(&mut media, "a", OpenMode::Append, " and more");
    write(&mut media, "new", OpenMode::Write, "the program's");
    media.apply(&Action::Delete("d"));
    media.write("disk/a", "by hand");
    media.write("disk/new", "by hand");
    media.write("disk/d/b", "by hand");
    let messages = media.roots.write();
    assert_eq!(media.text("disk/a").as_deref(), Some("by hand"));
    assert_eq!(media.text("disk/a.debugged").as_deref(), Some("a and more"));
    assert_eq!(media.text("disk/new").as_deref(), Some("by hand"));
    assert_eq!(media.text("disk/new.debugged").as_deref(), Some("the program's"));
    assert_eq!((media.text("disk/d/b").as_deref(), media.text("disk/d/e/c")), (Some("by hand"), None));
    expect_test::expect![[r#"
        `Disk://a` was changed on the disk after the program had changed it, and stays as it is: the file of the program is `a.debugged` next to it
        `Disk://new` was changed on the disk after the program had changed it, and stays as it is: the file of the program is `new.debugged` next to it
        `Disk://d/b` was changed on the disk after the program had deleted it, and stays
        `Disk://d` was changed on the disk after the program had deleted it, and stays"#]]
    .assert_eq(&messages.join("\n"));
}

#[test]
fn a_file_is_written_again_after_it_was_deleted_by_something_else() {
    let mut media = Media::covered();
    write(&mut media, "a", OpenMode::Append, "b");
    std::fs::remove_file(media.outer.join("disk/a")).unwrap();
    assert_eq!(media.roots.write(), [""; 0]);
    assert_eq!(media.text("disk/a").as_deref(), Some("ab"));
}

#[test]
fn changes_of_the_disk_are_seen_until_the_program_changes_the_file() {
    let mut media = Media::covered();
    media.write("disk/a", "two");
    assert_eq!(media.apply(&Action::Read("a")), "two");
    write(&mut media, "a", OpenMode::Append, "three");
    media.write("disk/a", "four");
    assert_eq!(media.apply(&Action::Read("a")), "twothree");
}

#[test]
fn changes_take_a_bounded_memory() {
    let mut media = Media::covered();
    let file = media.files.open(&media.roots, &Media::path("big"), OpenMode::Write).unwrap();
    let written = (0..200).map(|_| media.files.write_bytes(file, &[0; 10_000])).sum::<usize>();
    assert_eq!(written, (1 << 20) / 10_000 * 10_000);
    assert!(media.roots.take_overflow() && !media.roots.take_overflow());
    media.files.close(file).unwrap();
    media.apply(&Action::Delete("big"));
    write(&mut media, "big", OpenMode::Write, &"x".repeat(1 << 20));
    assert!(!media.roots.take_overflow());
}

#[test]
fn open_files_continue_in_the_overlay_and_on_the_disk() {
    let mut media = Media::on_disk();
    let reads = media.files.open(&media.roots, &Media::path("d/b"), OpenMode::Read).unwrap();
    let writes = media.files.open(&media.roots, &Media::path("a"), OpenMode::Append).unwrap();
    assert_eq!((media.files.bytes(reads, 1), media.files.write_bytes(writes, b"1")), (b"b".to_vec(), 1));
    media.roots.cover(&Inputs::default(), 1 << 20);
    media.files.follow(&media.roots);
    assert_eq!((media.files.bytes(reads, 9), media.files.write_bytes(writes, b"2")), (b"\n".to_vec(), 1));
    assert_eq!(media.text("disk/a").as_deref(), Some("a1"));
    assert_eq!(media.apply(&Action::Read("a")), "a12");
    assert_eq!(media.roots.write(), [""; 0]);
    media.roots.uncover();
    media.files.follow(&media.roots);
    assert_eq!(media.files.write_bytes(writes, b"3"), 1);
    assert_eq!(media.text("disk/a").as_deref(), Some("a123"));
}

#[cfg(unix)]
#[test]
fn permissions_and_links_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let mut media = Media::covered();
    let real = media.outer.join("disk/d/b");
    std::fs::set_permissions(&real, PermissionsExt::from_mode(0o640)).unwrap();
    symlink("d/b", media.outer.join("disk/link")).unwrap();
    write(&mut media, "link", OpenMode::Append, "more");
    assert_eq!(media.roots.write(), [""; 0]);
    assert_eq!(media.text("disk/d/b").as_deref(), Some("b\nmore"));
    assert!(media.outer.join("disk/link").is_symlink());
    assert_eq!(std::fs::metadata(real).unwrap().permissions().mode() & 0o777, 0o640);
}

#[cfg(unix)]
#[test]
fn links_in_a_deleted_folder_are_not_followed() {
    use std::os::unix::fs::symlink;
    for mut media in [Media::on_disk(), Media::covered()] {
        std::fs::create_dir(media.outer.join("disk/far")).unwrap();
        media.write("disk/far/x", "x");
        symlink("../far", media.outer.join("disk/d/link")).unwrap();
        symlink("nothing", media.outer.join("disk/d/broken")).unwrap();
        assert_eq!(media.apply(&Action::Delete("d")), "0");
        assert_eq!(media.apply(&Action::Read("far/x")), "x");
        assert_eq!(media.roots.write(), [""; 0]);
        let names: Vec<String> = media.listing().into_keys().collect();
        assert_eq!(names, ["disk/", "disk/a", "disk/far/", "disk/far/x", "usb/", "usb/u"]);
    }
}
