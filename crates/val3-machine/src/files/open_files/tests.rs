use camino::Utf8PathBuf;

use super::*;

struct Medium {
    _folder: tempfile::TempDir,
    disk: Utf8PathBuf,
    roots: Roots,
    files: OpenFiles,
}

impl Medium {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let disk = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        let mut roots = Roots::default();
        roots.mount("Disk", &disk).unwrap();
        Self { _folder: folder, disk, roots, files: OpenFiles::default() }
    }

    fn open(&mut self, path: &str, mode: &str) -> Result<usize, u16> {
        let path = ControllerPath::parse(path, &ControllerPath::root("Disk")).unwrap();
        let mode = OpenMode::parse(mode).unwrap();
        self.files.open(&self.roots, &path, mode).map_err(FileFault::code)
    }

    /// Reads a file that contains `bytes`.
    fn reading(bytes: impl AsRef<[u8]>) -> Self {
        let mut medium = Self::new();
        std::fs::write(medium.disk.join("f"), bytes).unwrap();
        assert_eq!(medium.open("F", "r"), Ok(0));
        medium
    }

    fn lines(&mut self) -> Vec<String> {
        self.files.lines(0, 100)
    }
}

#[test]
fn written_data_can_be_read() {
    let mut medium = Medium::new();
    assert_eq!(medium.open("log.txt", "w"), Ok(0));
    assert_eq!(medium.files.write_lines(0, ["one", "", "zwei ü"]), 3);
    assert_eq!(medium.files.close(0), Ok(()));
    assert_eq!(medium.open("Disk://LOG.TXT", "a"), Ok(0));
    assert_eq!(medium.files.write_bytes(0, &[65, 255]), 2);
    assert_eq!(medium.files.close(0), Ok(()));
    assert_eq!(std::fs::read(medium.disk.join("log.txt")).unwrap(), b"one\n\nzwei \xc3\xbc\nA\xff");
    assert_eq!(medium.open("log.txt", "r"), Ok(0));
    assert_eq!(medium.files.lines(0, 2), ["one", ""]);
    assert_eq!(medium.files.bytes(0, 3), b"zwe");
    assert_eq!(medium.lines(), ["i ü", "A"]);
    assert_eq!(medium.lines(), [""; 0]);
    assert_eq!(medium.files.bytes(0, 3), [0; 0]);
}

#[test]
fn lines_end_in_either_way() {
    assert_eq!(Medium::reading("a\r\nb\n\nc\rd").lines(), ["a", "b", "", "c\rd"]);
    assert_eq!(Medium::reading("a\n").lines(), ["a"]);
    assert_eq!(Medium::reading("").lines(), [""; 0]);
}

#[test]
fn a_long_line_continues_in_the_next_string() {
    let long = "x".repeat(300);
    let lengths = |text: &str| Medium::reading(text).lines().iter().map(String::len).collect::<Vec<_>>();
    assert_eq!(lengths(&format!("{long}\r\nend")), [128, 128, 44, 3]);
    for end in ["\n", "\r\n"] {
        assert_eq!(lengths(&format!("{}{end}{}{end}{end}", &long[..128], &long[..127])), [128, 127, 0]);
        assert_eq!(lengths(&format!("{}{end}{}", &long[..129], &long[..256])), [128, 1, 128, 128]);
    }
    assert_eq!(lengths(&"字".repeat(43)), [126, 3]);
    assert_eq!(Medium::reading(format!("{}é\n", &long[..127])).lines()[1], "é");
}

#[test]
fn bytes_that_are_no_text_are_skipped() {
    let mut noise = vec![0xff; 50_000];
    noise.extend(b"text\n");
    assert_eq!(Medium::reading(noise).lines(), ["text"]);
}

#[test]
fn at_most_ten_files_are_open() {
    let mut medium = Medium::new();
    for number in 0..10 {
        assert_eq!(medium.open(&format!("{number}"), "w"), Ok(number));
    }
    assert_eq!(medium.open("more", "w"), Err(30));
    assert!(!medium.disk.join("more").exists());
    assert_eq!(medium.files.close(4), Ok(()));
    assert_eq!(medium.files.close(4), Err(FileFault::NotFound));
    assert_eq!(medium.files.close(99), Err(FileFault::NotFound));
    assert_eq!(medium.open("more", "w"), Ok(4));
}

#[test]
fn files_that_cannot_be_opened() {
    let mut medium = Medium::new();
    std::fs::create_dir(medium.disk.join("folder")).unwrap();
    assert_eq!(medium.open("nothing", "r"), Err(39));
    assert_eq!(medium.open("folder", "r"), Err(21));
    assert_eq!(medium.open("no/folder/x", "w"), Err(39));
    assert_eq!(medium.open("USB0://x", "r"), Err(20));
    assert_eq!(medium.open("../x", "w"), Err(21));
    assert_eq!(OpenMode::parse("rw"), None);
    assert_eq!(OpenMode::parse("RB"), Some(OpenMode::Read));
}

#[test]
fn access_of_the_wrong_kind_returns_nothing() {
    let mut medium = Medium::reading("abc");
    assert_eq!(medium.files.write_lines(0, ["x"]), 0);
    assert_eq!(medium.files.write_bytes(0, &[1]), 0);
    assert_eq!(medium.open("g", "w"), Ok(1));
    assert_eq!(medium.files.lines(1, 1), [""; 0]);
    assert_eq!(medium.files.bytes(7, 1), [0; 0]);
}
