use camino::Utf8PathBuf;

use super::*;

struct Media {
    _folder: tempfile::TempDir,
    outer: Utf8PathBuf,
    roots: Roots,
}

impl Media {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let outer = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        for (name, text) in [("usr/usrapp/log.txt", "log"), ("usr/usrapp/data/a/b.txt", "b"), ("usb/u.txt", "u")] {
            std::fs::create_dir_all(outer.join(name).parent().unwrap()).unwrap();
            std::fs::write(outer.join(name), text).unwrap();
        }
        let mut roots = Roots::default();
        roots.mount_inside("Disk", &outer.join("usr"), "usrapp".into()).unwrap();
        roots.mount("USB0", &outer.join("usb")).unwrap();
        Self { _folder: folder, outer, roots }
    }

    fn done(
        &self,
        with: impl Fn(&Roots, &ControllerPath, &ControllerPath) -> Result<(), FileFault>,
        from: &str,
        to: &str,
    ) -> u16 {
        let path = |text| ControllerPath::parse(text, &ControllerPath::root("Disk")).unwrap();
        with(&self.roots, &path(from), &path(to)).map_or_else(FileFault::code, |()| 0)
    }

    fn delete(&self, path: &str) -> u16 {
        self.done(|roots, path, _| delete(roots, path), path, "")
    }

    fn text(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.outer.join(name)).ok()
    }
}

#[test]
fn files_and_folders_are_copied() {
    let media = Media::new();
    assert_eq!(media.done(copy, "Disk://LOG.txt", "USB0://U.TXT"), 0);
    assert_eq!(media.text("usb/u.txt").as_deref(), Some("log"));
    assert_eq!(media.done(copy, "data", "USB0://saved"), 0);
    assert_eq!(media.text("usb/saved/a/b.txt").as_deref(), Some("b"));
    assert_eq!(media.done(copy, "data", "USB0://saved"), 21);
    assert_eq!(media.done(copy, "nothing", "USB0://x"), 39);
    assert_eq!(media.done(copy, "log.txt", "data"), 21);
    assert_eq!(media.done(copy, "log.txt", "no/folder/x"), 21);
    assert_eq!(media.done(copy, "log.txt", "USB7://x"), 20);
}

#[test]
fn a_copy_onto_itself_loses_nothing() {
    let media = Media::new();
    assert_eq!(media.done(copy, "log.txt", "Log.TXT"), 21);
    assert_eq!(media.done(copy, "data", "data/a/again"), 21);
    assert_eq!(media.text("usr/usrapp/log.txt").as_deref(), Some("log"));
}

#[test]
fn files_and_folders_are_moved() {
    let media = Media::new();
    assert_eq!(media.done(rename, "log.txt", "data/old.txt"), 0);
    assert_eq!(media.text("usr/usrapp/data/old.txt").as_deref(), Some("log"));
    assert_eq!(media.done(rename, "log.txt", "x"), 39);
    assert_eq!(media.done(rename, "data", "Data"), 0);
    assert_eq!(media.text("usr/usrapp/Data/a/b.txt").as_deref(), Some("b"));
    assert_eq!(media.done(rename, "data", "data/a/inside"), 21);
    assert_eq!(media.done(rename, "data/old.txt", "USB0://u.txt"), 21);
    assert_eq!(media.done(rename, "data", "USB0://all"), 0);
    assert_eq!(media.text("usb/all/old.txt").as_deref(), Some("log"));
}

#[test]
fn files_and_folders_are_deleted() {
    let media = Media::new();
    assert_eq!(media.delete("Log.txt"), 0);
    assert_eq!(media.delete("log.txt"), 39);
    assert_eq!(media.delete("data"), 0);
    assert_eq!(media.text("usr/usrapp/data/a/b.txt"), None);
}

#[test]
fn a_medium_cannot_be_deleted() {
    let media = Media::new();
    for path in ["Disk://", "Disk://..", "Disk://../usrapp", "USB0://", "data/../.."] {
        assert_eq!(media.delete(path), 22, "{path}");
        assert_ne!(media.done(rename, path, "USB0://x"), 0, "{path}");
    }
    assert_eq!(media.delete("Disk://../../usb/u.txt"), 21);
    assert_eq!(media.text("usb/u.txt").as_deref(), Some("u"));
}

#[test]
fn only_files_exist_as_files() {
    let media = Media::new();
    let exists = |text| file_exists(&media.roots, &ControllerPath::parse(text, &ControllerPath::root("Disk")).unwrap());
    assert_eq!(exists("disk://LOG.TXT"), Ok(true));
    assert_eq!(exists("data"), Ok(false));
    assert_eq!(exists("nothing"), Ok(false));
    assert_eq!(exists("x://nothing"), Err(FileFault::BadRoot));
}

#[cfg(unix)]
#[test]
fn links_out_of_the_medium_are_not_followed() {
    let media = Media::new();
    std::os::unix::fs::symlink(media.outer.join("usb"), media.outer.join("usr/usrapp/data/out")).unwrap();
    assert_eq!(media.delete("data/out/u.txt"), 21);
    assert_eq!(media.done(copy, "log.txt", "data/out/new"), 21);
    assert_eq!(media.done(copy, "data", "copied"), 21);
    assert_eq!(media.text("usr/usrapp/copied/a/b.txt"), None);
    assert_eq!(media.delete("data"), 0);
    assert_eq!(media.text("usb/u.txt").as_deref(), Some("u"));
}
