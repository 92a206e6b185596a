use std::io::Write;

use zip::unstable::write::FileOptionsExt;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::*;

const PASSWORD: &str = "k7#fjW-20q";

fn options() -> SimpleFileOptions {
    SimpleFileOptions::default().compression_method(CompressionMethod::Deflated)
}

fn pack(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        let options = options().with_deprecated_encryption(PASSWORD.as_bytes()).unwrap();
        zip.start_file(*name, options).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn names(bytes: &[u8], password: &str) -> Result<Vec<String>, u16> {
    let files = unpack(bytes, password).map_err(FileFault::code)?;
    Ok(files.into_iter().map(|file| file.path.into_string()).collect())
}

#[test]
fn an_archive_is_read_with_its_password() {
    let packed = pack(&[("a.dtx", b"data"), ("part.pjx", b"project"), ("Comm/b.pgx", b"program")]);
    let files = unpack(&packed, PASSWORD).unwrap();
    assert_eq!(files[0], LibraryFile { path: "part.pjx".into(), bytes: b"project".to_vec() });
    assert_eq!(names(&packed, PASSWORD).unwrap(), ["part.pjx", "a.dtx", "Comm/b.pgx"]);
    assert_eq!(names(&packed, "wrong"), Err(12));
    assert_eq!(names(&packed, ""), Err(12));
}

#[test]
fn the_folder_itself_may_be_packed() {
    let packed = pack(&[("part/start.pgx", b""), ("part/part.pjx", b""), ("part/sub/sub.pjx", b""), ("readme", b"")]);
    assert_eq!(names(&packed, PASSWORD).unwrap(), ["part.pjx", "start.pgx", "sub/sub.pjx"]);
}

#[test]
fn an_archive_must_be_encrypted() {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file("part.pjx", options()).unwrap();
    zip.write_all(b"clear").unwrap();
    let clear = zip.finish().unwrap().into_inner();
    assert_eq!(names(&clear, PASSWORD), Err(23));
    assert_eq!(names(b"no archive at all", PASSWORD), Err(23));
    assert_eq!(names(b"", PASSWORD), Err(23));
}

#[test]
fn names_cannot_leave_the_archive() {
    for name in ["../evil.pgx", "a/../../evil.pgx", "/etc/evil", "..\\evil.pgx", "C:/evil", "C:evil"] {
        let packed = pack(&[("part.pjx", b""), (name, b"evil")]);
        assert_eq!(names(&packed, PASSWORD), Err(12), "{name}");
    }
}

#[test]
fn a_decompression_bomb_is_not_unpacked() {
    let zeros = vec![0; 8 << 20];
    assert_eq!(names(&pack(&[("part.pjx", b""), ("bomb.dtx", &zeros)]), PASSWORD), Err(12));
    let many: Vec<_> = (0..5_000).map(|number| format!("{number}.pgx")).collect();
    let many: Vec<(&str, &[u8])> = many.iter().map(|name| (name.as_str(), &b""[..])).collect();
    assert_eq!(names(&pack(&many), PASSWORD), Err(12));
    let noise: Vec<u8> = (0..(70u64 << 20)).map(|at| (at.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 56) as u8).collect();
    assert_eq!(names(&pack(&[("part.pjx", b""), ("big.dtx", &noise)]), PASSWORD), Err(12));
}

#[test]
fn an_archive_without_a_project() {
    assert_eq!(names(&pack(&[("a.dtx", b"data")]), PASSWORD), Err(12));
    assert_eq!(names(&pack(&[]), PASSWORD), Err(12));
}

#[test]
fn damaged_archives_are_refused() {
    let text = b"<Project/>".repeat(40);
    let packed = pack(&[("part.pjx", &text), ("a.dtx", b"data")]);
    for at in 0..packed.len() {
        let mut damaged = packed.clone();
        damaged[at] ^= 0x55;
        if let Ok(files) = unpack(&damaged, PASSWORD) {
            assert!(files.iter().all(|file| file.path.is_relative()));
        }
        assert!(unpack(&packed[..at], PASSWORD).is_err(), "{at}");
    }
}
