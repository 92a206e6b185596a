//! Archives of backups, which are read in place, and programs without a project.

use std::fs;
use std::io::{Cursor, Write as _};
use std::path::Path;

use zip::write::{SimpleFileOptions, ZipWriter};

use crate::support::{FAULTY, Folder, add_stops};

/// Packs the files of a folder below `usr`, as a controller does.
fn pack(folder: &Folder, archive: &Path) {
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

/// A folder with the archive `backup.zip` of a listing.
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
fn a_program_without_a_project_is_checked_for_what_needs_none() {
    let application = Folder::with(
        "--- main\nnum nCount\nprogram start()\nbegin\n  nCount=nOther+1\n  call other(pPick)\n  part:open()\nend\n",
    );
    let folder = Folder::empty();
    let program = application.read("usrapp/main/start.pgx");
    folder.write("start.pgx", &program);
    let run = folder.val3(&["check", "start.pgx"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    let note = "note: `start.pgx` has no project (`.pjx`) in the folder: names and types that the project declares are not \
                checked";
    assert!(run.stderr.contains(note), "{run:?}");
    folder.write("start.pgx", &program.replace("nCount=nOther+1", "nCount=left(1,2)\n  nCount=(1"));
    let run = folder.val3(&["check", "start.pgx", "--format", "concise"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.lines().count() == 2 && !run.stdout.contains("start.pjx"), "{run:?}");
    folder.write("start.pgx", "");
    assert_eq!(folder.val3(&["check", "start.pgx"]).code, 2);
}
