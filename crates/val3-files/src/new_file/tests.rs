use std::fs::File;

use super::*;

/// A folder with the file `a.pgx`, whose content is `old`.
struct Fixture {
    _kept: tempfile::TempDir,
    folder: Utf8PathBuf,
    path: Utf8PathBuf,
}

impl Fixture {
    fn new() -> Self {
        let kept = tempfile::tempdir().unwrap();
        let folder = Utf8PathBuf::from_path_buf(kept.path().canonicalize().unwrap()).unwrap();
        let path = folder.join("a.pgx");
        fs::write(&path, "old").unwrap();
        Self { _kept: kept, folder, path }
    }

    fn content(&self) -> String {
        fs::read_to_string(&self.path).unwrap()
    }

    fn names(&self) -> Vec<String> {
        let entries = self.folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().file_name().to_owned());
        let mut names: Vec<String> = entries.collect();
        names.sort();
        names
    }
}

#[test]
fn a_leftover_is_removed_by_the_next_write() {
    let fixture = Fixture::new();
    let leftover = fixture.folder.join(".a.pgx.val3-tmp");
    fs::write(&leftover, "half").unwrap();
    replace(&fixture.path, b"new").unwrap();
    assert_eq!(fixture.content(), "new");
    assert_eq!(fixture.names(), ["a.pgx"]);
}

#[test]
fn a_file_is_written_by_one_run_at_a_time() {
    let fixture = Fixture::new();
    let mut first = NewFile::create(&fixture.path).unwrap();
    assert_eq!(fixture.names(), [".a.pgx.val3-tmp", "a.pgx"]);
    assert_eq!(replace(&fixture.path, b"second"), Err(Unwritable::Busy));
    first.write_all(b"first").unwrap();
    first.commit().unwrap();
    assert_eq!(fixture.content(), "first");
    assert_eq!(fixture.names(), ["a.pgx"]);
}

#[test]
fn a_folder_is_no_target() {
    let fixture = Fixture::new();
    assert_eq!(replace(&fixture.folder, b"new"), Err(Unwritable::NotRegular));
    assert_eq!(replace(&fixture.folder.join("none/a"), b"new"), Err(Unwritable::NoFolder));
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, chown, symlink};

    use super::*;

    #[test]
    fn mode_and_owner_are_kept() {
        let fixture = Fixture::new();
        fs::set_permissions(&fixture.path, fs::Permissions::from_mode(0o640)).unwrap();
        // Only root may change the owner.
        let is_root = chown(&fixture.path, Some(1234), Some(5678)).is_ok();
        replace(&fixture.path, b"new").unwrap();
        let found = fs::metadata(&fixture.path).unwrap();
        assert_eq!(found.mode() & 0o777, 0o640);
        assert!(!is_root || (found.uid(), found.gid()) == (1234, 5678));
        assert_eq!(fixture.content(), "new");
    }

    #[test]
    fn a_new_file_has_the_usual_mode() {
        let fixture = Fixture::new();
        let (usual, new) = (fixture.folder.join("usual"), fixture.folder.join("new"));
        File::create(&usual).unwrap();
        replace(&new, b"").unwrap();
        assert_eq!(fs::metadata(&new).unwrap().mode(), fs::metadata(&usual).unwrap().mode());
    }

    #[test]
    fn a_link_stays_a_link() {
        let fixture = Fixture::new();
        let link = fixture.folder.join("link.pgx");
        symlink(&fixture.path, &link).unwrap();
        replace(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(fixture.content(), "new");
    }

    #[test]
    fn a_file_with_several_links_keeps_them() {
        let fixture = Fixture::new();
        let other = fixture.folder.join("b.pgx");
        fs::hard_link(&fixture.path, &other).unwrap();
        replace(&fixture.path, b"new").unwrap();
        assert_eq!(fs::read(&other).unwrap(), b"new");
        assert_eq!(fixture.names(), ["a.pgx", "b.pgx"]);
    }

    #[test]
    fn an_interrupted_overwriting_is_left_to_the_user() {
        let fixture = Fixture::new();
        let backup = fixture.folder.join(".a.pgx.val3-old");
        fs::hard_link(&fixture.path, fixture.folder.join("b.pgx")).unwrap();
        fs::write(&backup, "before").unwrap();
        assert_eq!(replace(&fixture.path, b"new"), Err(Unwritable::Interrupted(backup)));
        assert_eq!(fixture.content(), "old");
        assert_eq!(fixture.names(), [".a.pgx.val3-old", "a.pgx", "b.pgx"]);
    }

    #[test]
    fn a_planted_link_is_removed_and_its_target_is_kept() {
        let fixture = Fixture::new();
        let canary = fixture.folder.join("canary");
        fs::write(&canary, "kept").unwrap();
        symlink(&canary, fixture.folder.join(".a.pgx.val3-tmp")).unwrap();
        replace(&fixture.path, b"new").unwrap();
        assert_eq!(fs::read(&canary).unwrap(), b"kept");
        assert_eq!(fixture.names(), ["a.pgx", "canary"]);
    }

    #[test]
    fn a_link_to_nothing_is_replaced() {
        let fixture = Fixture::new();
        let (link, target) = (fixture.folder.join("link"), fixture.folder.join("none"));
        symlink(&target, &link).unwrap();
        replace(&link, b"new").unwrap();
        assert!(!target.exists() && !link.is_symlink());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn extended_attributes_are_kept() {
        use rustix::fs::{XattrFlags, getxattr, setxattr};
        let fixture = Fixture::new();
        let path = fixture.path.as_str();
        if setxattr(path, "user.station", b"7", XattrFlags::empty()).is_err() {
            // The file system of the test has no extended attributes.
            return;
        }
        replace(&fixture.path, b"new").unwrap();
        let mut value = [0; 8];
        assert_eq!(getxattr(path, "user.station", &mut value), Ok(1));
        assert_eq!(value[0], b'7');
    }
}
