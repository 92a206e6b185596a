//! Resolution of links in paths whose last parts need not exist.

use camino::{Utf8Path, Utf8PathBuf};

use crate::paths::normalise;

/// Maximum number of followed links, as on Linux.
const MOST: usize = 40;

/// Resolves all links in the path. A link to a missing file resolves to the path where the file would be created.
pub(super) fn target(path: &Utf8Path) -> Utf8PathBuf {
    follow(path, MOST)
}

fn follow(path: &Utf8Path, left: usize) -> Utf8PathBuf {
    if let Ok(existing) = path.canonicalize_utf8() {
        return existing;
    }
    let (Some(parent), Some(name)) = (path.parent(), path.file_name()) else { return normalise(path) };
    if left == 0 {
        return normalise(path);
    }
    match path.read_link_utf8() {
        Ok(target) => follow(&parent.join(target), left - 1),
        Err(_) => follow(parent, left).join(name),
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn missing_names_and_dangling_links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let root = Utf8PathBuf::from_path_buf(folder.path().canonicalize().unwrap()).unwrap();
        fs::create_dir(root.join("real")).unwrap();
        symlink("real", root.join("link")).unwrap();
        symlink("../secret/new.txt", root.join("real/dangling")).unwrap();
        symlink("circle", root.join("circle")).unwrap();
        assert_eq!(target(&root.join("link/a/b")), root.join("real/a/b"));
        assert_eq!(target(&root.join("link/dangling")), root.join("secret/new.txt"));
        assert_eq!(target(&root.join("circle")), root.join("circle"));
        assert_eq!(target(&root.join("link/..")), root);
    }
}
