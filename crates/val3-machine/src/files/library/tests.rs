use std::io;

use val3_data::{SavedContainer, SavedContent, SavedValue};

use super::*;

const PROJECT: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Programs>
    <Program file="START.pgx" />
    <Program file="Comm/readData.pgx" />
    <Program file="missing.pgx" />
    <Program file="../../../secret" />
  </Programs>
  <Database>
    <Data file="part.dtx" />
    <Data file="more.dtx" />
  </Database>
</Project>"#;

fn database(name: &str, value: u32) -> String {
    format!(
        "\u{feff}<Database>\r\n  <Datas>\r\n    <Data name=\"{name}\" access=\"public\" xsi:type=\"array\" type=\"num\" \
         size=\"1\">\r\n      <Value key=\"0\" value=\"{value}\" />\r\n    </Data>\r\n  </Datas>\r\n</Database>"
    )
}

/// Medium with the library `part`, in which some files are spelled in another letter case.
struct Medium {
    _folder: tempfile::TempDir,
    disk: Utf8PathBuf,
    roots: Roots,
}

impl Medium {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let outer = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        std::fs::write(outer.join("secret"), "secret").unwrap();
        let disk = outer.join("disk");
        std::fs::create_dir_all(disk.join("part/Comm")).unwrap();
        let write = |name: &str, text: &str| std::fs::write(disk.join("part").join(name), text).unwrap();
        write("part.pjx", PROJECT);
        write("start.pgx", "start");
        write("Comm/readData.pgx", "read");
        write("part.dtx", &database("nA", 1));
        write("more.dtx", &database("nB", 1));
        let mut roots = Roots::default();
        roots.mount("Disk", &disk).unwrap();
        Self { _folder: folder, disk, roots }
    }

    fn path(text: &str) -> LibraryPath {
        let application = ControllerPath::root("Disk").join("app").unwrap();
        LibraryPath::new(&ControllerPath::parse(text, &application).unwrap()).unwrap()
    }

    fn read(&self, text: &str) -> Result<LibraryFiles, u16> {
        Self::path(text).read(&self.roots, "").map_err(FileFault::code)
    }

    fn save_as(&self, text: &str, files: &LibraryFiles) -> u16 {
        code(Self::path(text).save_as(&self.roots, files, &mut Uninterrupted))
    }

    fn delete(&self, text: &str) -> u16 {
        code(Self::path(text).delete(&self.roots))
    }

    /// The files on the disk, by path.
    fn listing(&self) -> Vec<String> {
        let mut found = Vec::new();
        let mut open = vec![self.disk.clone()];
        while let Some(folder) = open.pop() {
            for entry in folder.read_dir_utf8().unwrap() {
                let path = entry.unwrap().into_path();
                match path.is_dir() {
                    true => open.push(path),
                    false => found.push(path.strip_prefix(&self.disk).unwrap().to_string()),
                }
            }
        }
        found.sort();
        found
    }
}

fn code(result: Result<(), FileFault>) -> u16 {
    result.map_or_else(FileFault::code, |()| 0)
}

fn number(name: &str, value: u32) -> SavedData {
    let content = SavedContent::Attributes(vec![("value".into(), value.to_string())]);
    SavedData {
        name: name.into(),
        type_name: "num".into(),
        shape: SavedContainer::Sizes(vec![1]),
        values: vec![SavedValue { key: "0".to_owned(), content }],
        is_part: false,
    }
}

fn names(files: &LibraryFiles) -> Vec<&str> {
    files.files.iter().map(|file| file.path.as_str()).collect()
}

#[test]
fn a_path_names_folder_project_or_archive() {
    for (text, shown) in [
        ("part", r#"Disk://part Some("part.pjx")"#),
        ("./part/Part.pjx", r#"Disk://app/part Some("Part.pjx")"#),
        ("USB0://x/secret.zip", "USB0://x/secret.zip None"),
    ] {
        let path = Medium::path(text);
        assert_eq!(format!("{} {:?}", path.folder(), path.manifest.as_deref()), shown);
    }
    let root = LibraryPath::new(&ControllerPath::root("Disk"));
    assert_eq!(root.unwrap_err().code(), 22);
}

#[test]
fn a_library_is_the_files_that_its_project_names() {
    let medium = Medium::new();
    let files = medium.read("Disk://PART").unwrap();
    assert_eq!(names(&files), ["part.pjx", "start.pgx", "Comm/readData.pgx", "part.dtx", "more.dtx"]);
    assert_eq!(medium.read("part/part.pjx").unwrap(), files);
}

#[test]
fn missing_libraries_have_a_code() {
    let medium = Medium::new();
    assert_eq!(medium.read("nothing"), Err(39));
    assert_eq!(medium.read("no/such/library"), Err(21));
    assert_eq!(medium.read("floppy://part"), Err(20));
    assert_eq!(medium.read("../../../etc/passwd"), Err(21));
    assert_eq!(medium.read("nothing.zip"), Err(39));
    assert!(Medium::path("part").exists(&medium.roots).unwrap());
    assert!(!Medium::path("nothing").exists(&medium.roots).unwrap());
}

#[test]
fn saving_writes_what_changed() {
    let medium = Medium::new();
    let old = medium.read("part").unwrap();
    std::fs::write(medium.disk.join("part/start.pgx"), "edited meanwhile").unwrap();
    let new = old.with_data(&[number("nA", 2), number("nB", 1)]).unwrap();
    assert_eq!(code(Medium::path("part").save(&medium.roots, &old, &new, &mut Uninterrupted)), 0);
    let text = |name: &str| std::fs::read_to_string(medium.disk.join("part").join(name)).unwrap();
    assert_eq!(text("part.dtx"), database("nA", 2));
    assert_eq!(text("more.dtx"), database("nB", 1));
    assert_eq!(text("start.pgx"), "edited meanwhile");
    assert_eq!(medium.listing().len(), 5);
}

#[test]
fn a_deleted_library_can_be_saved_again() {
    let medium = Medium::new();
    let old = medium.read("part").unwrap();
    assert_eq!(medium.delete("part"), 0);
    assert_eq!(medium.listing(), [""; 0]);
    assert!(!medium.disk.join("part").exists());
    assert_eq!(medium.delete("part"), 0);
    assert_eq!(code(Medium::path("part").save(&medium.roots, &old, &old, &mut Uninterrupted)), 0);
    assert_eq!(medium.read("part").unwrap(), old);
}

#[test]
fn deleting_keeps_files_that_are_not_part_of_the_library() {
    let medium = Medium::new();
    std::fs::write(medium.disk.join("part/log.txt"), "kept").unwrap();
    assert_eq!(medium.delete("part"), 0);
    assert_eq!(medium.listing(), ["part/log.txt"]);
    assert_eq!(medium.delete("floppy://part"), 20);
    assert_eq!(medium.delete("../../x"), 21);
    assert_eq!(medium.delete("no/such/library"), 0);
}

#[test]
fn a_library_is_saved_under_another_path() {
    let medium = Medium::new();
    let files = medium.read("part").unwrap();
    assert_eq!(medium.save_as("copy", &files), 0);
    assert_eq!(names(&medium.read("copy").unwrap())[..2], ["copy.pjx", "start.pgx"]);
    assert_eq!(medium.save_as("COPY", &files), 31);
    assert_eq!(medium.save_as("part", &files), 31);
    assert_eq!(medium.save_as("no/such/folder", &files), 21);
    assert_eq!(medium.save_as("USB0://articles/article_1", &files), 20);
    assert_eq!(medium.save_as("copy.zip", &files), 22);
    assert_eq!(medium.delete("copy"), 0);
    assert_eq!(medium.save_as("copy", &files), 0);
    let secret = LibraryFiles { encrypted: true, ..files };
    assert_eq!(medium.save_as("secret", &secret), 40);
}

#[test]
fn a_folder_is_listed() {
    let medium = Medium::new();
    std::fs::create_dir(medium.disk.join("Zoo")).unwrap();
    std::fs::write(medium.disk.join("a.txt"), "").unwrap();
    let listed = |path: &ControllerPath| list(&medium.roots, path).map_err(FileFault::code);
    let root = ControllerPath::root("Disk");
    assert_eq!(listed(&root).unwrap(), ["a.txt", "part", "Zoo"]);
    assert_eq!(listed(&root.join("nowhere").unwrap()), Err(21));
    assert_eq!(listed(&root.join("a.txt").unwrap()), Err(21));
    assert_eq!(listed(&ControllerPath::root("Ftp")), Err(20));
}

/// Ends the work before the step with this number: permanently, or like a full disk.
struct Ends {
    at: usize,
    count: usize,
    kind: io::ErrorKind,
    once: bool,
}

impl Steps for Ends {
    fn next(&mut self) -> io::Result<()> {
        self.count += 1;
        let ends = if self.once { self.count == self.at } else { self.count >= self.at };
        if ends { Err(self.kind.into()) } else { Ok(()) }
    }
}

/// Saves two changed data files and a missing program, and ends before each step in turn. A program then reads the
/// library before or after the save. Returns the counts of both.
fn end_everywhere(kind: io::ErrorKind, once: bool, mut check: impl FnMut(&Medium, &LibraryFiles, u16)) -> [usize; 2] {
    let mut seen = [0, 0];
    for at in 1..100 {
        let medium = Medium::new();
        let old = medium.read("part").unwrap();
        let new = old.with_data(&[number("nA", 2), number("nB", 2)]).unwrap();
        let mut ends = Ends { at, count: 0, kind, once };
        let result = code(Medium::path("part").save(&medium.roots, &old, &new, &mut ends));
        check(&medium, &old, result);
        let found = medium.read("part").unwrap();
        assert!(found == old || found == new, "{at}: {found:?}");
        assert_eq!(medium.listing().len(), 5, "{at}: {:?}", medium.listing());
        seen[usize::from(found == new)] += 1;
        if ends.count < at {
            assert_eq!((result, found == new), (0, true));
            return seen;
        }
    }
    panic!("it never ends");
}

#[test]
fn a_crash_at_any_step_leaves_the_old_or_the_new_library() {
    let [old, new] = end_everywhere(io::ErrorKind::Interrupted, false, |medium, _, result| {
        let found = medium.disk.join("part/part.dtx");
        assert!(found.exists());
        assert!(result == 0 || result == 30, "{result}");
    });
    assert!(old > 8 && new > 4, "{old} {new}");
}

#[test]
fn a_full_disk_leaves_the_old_library() {
    end_everywhere(io::ErrorKind::StorageFull, true, |medium, old, result| {
        let untouched = medium.disk.join("part/.saved").exists() || medium.read("part").unwrap() == *old;
        assert!(result == 0 || (result == 38 && untouched), "{result}");
        assert!(!medium.disk.join("part/.saving").exists());
    });
}

#[test]
fn a_crash_while_a_library_is_first_saved_leaves_none_or_all() {
    for at in 1..100 {
        let medium = Medium::new();
        let files = medium.read("part").unwrap();
        let mut ends = Ends { at, count: 0, kind: io::ErrorKind::Interrupted, once: false };
        let result = code(Medium::path("copy").save_as(&medium.roots, &files, &mut ends));
        match medium.read("copy") {
            Ok(found) => assert_eq!(found.files[1..], files.files[1..], "{at}"),
            Err(missing) => {
                assert_eq!((missing, result), (39, 30), "{at}");
                assert_eq!(medium.save_as("copy", &files), 0, "{at}");
            }
        }
        if ends.count < at {
            return;
        }
    }
    panic!("it never ends");
}
