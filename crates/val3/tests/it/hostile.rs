//! Programs and files that misuse the controller. The program gets an error, and the run continues.

use std::fs;
use std::io::{Cursor, Write};

use zip::CompressionMethod;
use zip::unstable::write::FileOptionsExt as _;
use zip::write::{SimpleFileOptions, ZipWriter};

use crate::support::Folder;

#[track_caller]
fn prints(folder: &Folder, more: &[&str], expected: &str) {
    let run = folder.val3(&[&["run", "usrapp/main"], more].concat());
    assert_eq!((run.code, run.stdout.as_str()), (0, expected), "{run:?}");
}

#[test]
fn recursion_without_end_fills_the_stack_of_its_task_alone() {
    let folder = Folder::with(
        r#"
program deep(num x_nDepth)
begin
  call deep(x_nDepth+1)
end
program start()
begin
  taskCreate "deep",10,deep(1)
  wait(taskStatus("deep")!=1)
  ? taskStatus("deep")
  taskKill("deep")
end
"#,
    );
    prints(&folder, &[], "41\n");
}

#[test]
fn a_collection_has_9999_keys_of_128_bytes_and_no_more() {
    let folder = Folder::with(
        r#"
num nByKey[""]
num nCount
string sKey
program fill()
begin
  while true
    nCount=nCount+1
    sKey=toString("",nCount)
    while len(sKey)<128
      sKey=sKey+left("________________________________",128-len(sKey))
    endWhile
    insert(nByKey[sKey])
    nByKey[sKey]=nCount
  endWhile
end
program start()
begin
  taskCreate "fill",100,fill()
  wait(taskStatus("fill")!=1)
  ? taskStatus("fill")
  ? size(nByKey)
  ? nByKey[last(nByKey)]
  ? len(last(nByKey))
  taskKill("fill")
end
"#,
    );
    prints(&folder, &[], "40\n9999\n9\n128\n");
}

/// An application next to a secret file, which is outside of the root folders.
fn beside_a_secret(code: &str) -> Folder {
    let folder = Folder::with(&format!(
        r#"
--- main
library secret "part" autoload=false
string sList[1]
num nFile
program start()
begin
{code}
end
--- part
public num nValue
"#
    ));
    folder.write("secret/secret.pjx", "<Project/>");
    folder.write("secret/note.txt", "secret");
    folder.write("stick/readme.txt", "hello");
    #[cfg(unix)]
    std::os::unix::fs::symlink(folder.path().join("secret"), folder.path().join("stick/link")).unwrap();
    folder
}

#[test]
fn no_path_leaves_its_root() {
    let ways =
        ["Disk://../secret", "../../secret", "./../../secret", "USB0://../secret", "USB0://link", "Disk://../../etc"];
    for way in ways {
        let folder = beside_a_secret(&accesses(way));
        let stick = format!("--root=USB0={}", folder.path().join("stick").display());
        let refused = "true\nfalse\n\ntrue\n-1\n-1\nfalse\nfalse\nfalse\nfalse\nfalse\n";
        prints(&folder, &[&stick], refused);
        assert_eq!(folder.read("secret/note.txt"), "secret", "{way}");
        assert_eq!(fs::read_dir(folder.path().join("secret")).unwrap().count(), 2, "{way}");
        assert!(!folder.path().join("stick/stolen.txt").exists(), "{way}");
    }
}

/// Code that accesses a path in every way.
fn accesses(way: &str) -> String {
    [
        format!("  ? secret:libLoad(\"{way}\")!=0"),
        format!("  ? libList(\"{way}\",sList)"),
        "  ? sList[0]".to_owned(),
        format!("  ? libDelete(\"{way}\")!=0"),
        format!("  ? $fileOpen(\"{way}/note.txt\",\"r\")"),
        format!("  ? $fileOpen(\"{way}/new.txt\",\"w\")"),
        format!("  ? $fileExists(\"{way}/note.txt\")"),
        format!("  ? $copy(\"{way}/note.txt\",\"USB0://stolen.txt\")"),
        format!("  ? $copy(\"USB0://readme.txt\",\"{way}/note.txt\")"),
        format!("  ? $rename(\"{way}/note.txt\",\"USB0://stolen.txt\")"),
        format!("  ? $delete(\"{way}/note.txt\")"),
    ]
    .join("\n")
}

const PASSWORD: &str = "k7#fjW-20q";

fn pack(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        zip.start_file(*name, options.with_deprecated_encryption(PASSWORD.as_bytes()).unwrap()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

#[test]
fn archives_with_bombs_or_escaping_paths_are_not_loaded() {
    let folder = Folder::with(&format!(
        r#"
--- main
library part "part" autoload=false
program start()
begin
  ? part:libLoad("good.zip","{PASSWORD}")
  ? part:nValue
  ? part:libLoad("bomb.zip","{PASSWORD}")
  ? part:libLoad("slip.zip","{PASSWORD}")
  ? part:nValue
end
--- part
public num nValue=7
"#
    ));
    let [project, data] = ["pjx", "dtx"].map(|end| folder.read(&format!("usrapp/part/part.{end}")));
    let library = [("part.pjx", project.as_bytes()), ("part.dtx", data.as_bytes())];
    let zeros = vec![0; 64 << 20];
    let with = |more: &[(&str, &[u8])]| pack(&[&library, more].concat());
    for (name, bytes) in
        [("good", with(&[])), ("bomb", with(&[("bomb.pgx", &zeros)])), ("slip", with(&[("../main/evil.pgx", b"evil")]))]
    {
        fs::write(folder.path().join(format!("usrapp/{name}.zip")), bytes).unwrap();
    }
    prints(&folder, &[], "0\n7\n12\n12\n7\n");
    assert!(!folder.path().join("usrapp/main/evil.pgx").exists());
}
