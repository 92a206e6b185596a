//! Backup archives, which are read without unpacking.

use std::fs;
use std::io::{Cursor, Write as _};
use std::path::Path;

use zip::write::{SimpleFileOptions, ZipWriter};

use crate::support::{FAULTY, Folder, add_stops};

/// Packs the `usr` files of a folder into an archive, as a controller does.
pub(crate) fn pack(folder: &Folder, archive: &Path) {
    add_stops(folder.path());
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let mut folders = vec![folder.path().to_owned()];
    while let Some(above) = folders.pop() {
        for entry in fs::read_dir(above).unwrap().map(Result::unwrap) {
            if entry.file_type().unwrap().is_dir() {
                folders.push(entry.path());
                continue;
            }
            let path = entry.path();
            let inner = path.strip_prefix(folder.path()).unwrap().to_str().unwrap();
            writer.start_file(format!("usr/{inner}"), SimpleFileOptions::default()).unwrap();
            writer.write_all(&fs::read(&path).unwrap()).unwrap();
        }
    }
    fs::write(archive, writer.finish().unwrap().into_inner()).unwrap();
}

/// A folder that contains a listing as the archive `backup.zip`.
fn archived(listing: &str) -> Folder {
    let folder = Folder::empty();
    pack(&Folder::with(listing), &folder.path().join("backup.zip"));
    folder
}

#[test]
fn an_archive_is_checked_in_place() {
    let folder = archived(FAULTY);
    for path in ["backup.zip", "backup.zip/usr/usrapp/main"] {
        let run = folder.val3(&["check", path, "--format", "concise"]);
        assert_eq!(run.code, 1, "{run:?}");
        assert!(run.stdout.starts_with("backup.zip/usr/usrapp/main/start.pgx:"), "{run:?}");
    }
    let before = fs::read(folder.path().join("backup.zip")).unwrap();
    let fixed = folder.val3(&["check", "backup.zip", "--unsafe-fixes", "--fix"]);
    assert_eq!(fixed.code, 2, "{fixed:?}");
    assert!(fixed.stderr.contains("is not changed: it is in an archive"), "{fixed:?}");
    assert_eq!(fs::read(folder.path().join("backup.zip")).unwrap(), before);
}

#[test]
fn the_cell_around_an_archived_application_counts() {
    let folder = archived("=== /configs/arm.cfx\n<arm>\n\n--- main\nnum nCount\nnCount=1\n");
    let run = folder.val3(&["check", "backup.zip"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stdout.contains("the file `usr/configs/arm.cfx` of the cell cannot be read: line 1:"), "{run:?}");
}

#[test]
fn archives_are_compared_with_folders_and_with_each_other() {
    let folder = archived("num nCount\nnCount=1\n");
    let now = Folder::with("num nCount\nnCount=2\n");
    pack(&now, &folder.path().join("now.zip"));
    let with_archive = folder.val3(&["diff", "backup.zip", "now.zip"]);
    assert_eq!(with_archive.code, 1, "{with_archive:?}");
    assert!(with_archive.stdout.contains("start()"), "{with_archive:?}");
    let with_folder = folder.val3(&["diff", "now.zip", now.path().to_str().unwrap()]);
    assert_eq!(with_folder.code, 0, "{with_folder:?}");
}

#[test]
fn an_archived_application_runs() {
    let folder = archived("program start()\nbegin\n  ? \"hello\"\nend\n");
    for path in ["backup.zip", "backup.zip/usr/usrapp/main"] {
        let run = folder.val3(&["run", path]);
        assert_eq!((run.code, run.stdout.as_str()), (0, "hello\n"), "{run:?}");
    }
}

#[test]
fn a_damaged_archive_is_named() {
    let folder = Folder::empty();
    folder.write("backup.zip", "no archive");
    for command in ["check", "run"] {
        let run = folder.val3(&[command, "backup.zip"]);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains("backup.zip") && run.stderr.contains("no ZIP archive"), "{run:?}");
    }
    let run = folder.val3(&["diff", "backup.zip", "backup.zip"]);
    assert_eq!(run.code, 2, "{run:?}");
}

#[test]
fn a_command_that_reads_no_archives_states_the_remedy() {
    let folder = archived("program start()\nbegin\n  ? \"hello\"\nend\n");
    for command in [&["test", "backup.zip"][..], &["eval", "--app", "backup.zip", "1"], &["fmt", "backup.zip"]] {
        let run = folder.val3(command);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains("unpack the archive, and name its folder"), "{run:?}");
    }
}

#[test]
fn the_archives_of_a_folder_without_applications_are_named() {
    let folder = archived("program start()\nbegin\n  ? \"hello\"\nend\n");
    for command in [&["check"][..], &["run", "."], &["test"], &["eval", "--app", ".", "1"], &["diff", ".", "."]] {
        let run = folder.val3(command);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains("backup.zip"), "{run:?}");
    }
}
