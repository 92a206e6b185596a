//! One `Disk://` root for an application and all loaded libraries and types, and the project directly in a folder.

use crate::support::Folder;

/// A project file with these user types.
fn project(name: &str, types: &[(&str, &str)], has_data: bool) -> String {
    let types: String =
        types.iter().map(|(name, path)| format!("    <Type name=\"{name}\" path=\"{path}\" />\n")).collect();
    let data = if has_data { format!("<Data file=\"{name}.dtx\" />") } else { String::new() };
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
         <Parameters version=\"s7.11\" stackSize=\"5000\" millimeterUnit=\"true\" />\n  <Programs />\n  \
         <Database>{data}</Database>\n  <Libraries />\n  <Types>\n{types}  </Types>\n</Project>\n"
    )
}

fn data(name: &str, ty: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    <Data name=\"{name}\" access=\"public\" \
         xsi:type=\"array\" type=\"{ty}\" size=\"1\" />\n  </Datas>\n</Database>\n"
    )
}

/// An application whose types have copies in a nested folder of the same name, `cell/libs/libs`.
fn with_copies() -> Folder {
    let folder = Folder::empty();
    let listing = val3_test::Fixture::parse(
        "--- app\nnum nCount\nprogram start()\nbegin\n  call take(b.a)\nend\nprogram take(A x_a)\nbegin\n  nCount=x_a.nX\nend\n",
    );
    for (path, text) in listing.files {
        let text = text.replace(
            "<Types />",
            "<Types>\n    <Type name=\"A\" path=\"Disk://libs/A/A.pjx\" />\n    <Type name=\"B\" path=\"Disk://libs/B/B.pjx\" />\n  \
             </Types>",
        );
        let text = text.replace(
            "  </Datas>",
            "    <Data name=\"b\" access=\"private\" xsi:type=\"array\" type=\"B\" size=\"1\" />\n  </Datas>",
        );
        folder.write(&path.replace("usrapp/", "cell/"), &text);
    }
    for libs in ["cell/libs", "cell/libs/libs"] {
        folder.write(&format!("{libs}/A/A.pjx"), &project("A", &[], true));
        folder.write(&format!("{libs}/A/A.dtx"), &data("nX", "num"));
        folder.write(&format!("{libs}/B/B.pjx"), &project("B", &[("A", "Disk://libs/A/A.pjx")], true));
        folder.write(&format!("{libs}/B/B.dtx"), &data("a", "A"));
    }
    folder
}

#[test]
fn copies_of_types_cause_no_findings() {
    let folder = with_copies();
    for path in ["cell/app", "cell", ".", "cell/libs"] {
        let run = folder.val3(&["check", path]);
        assert_eq!(run.code, 0, "{path}: {run:?}");
    }
    let run = folder.val3(&["run", "cell/app"]);
    assert_eq!(run.code, 0, "{run:?}");
    let explained = folder.val3(&["check", "cell", "--explain-config"]).stdout;
    let disk = |manifest: &str| explained_disk(&explained, manifest);
    assert_eq!(disk("cell/app/app.pjx"), "cell");
    assert_eq!(disk("cell/libs/B/B.pjx"), "cell");
    assert_eq!(disk("cell/libs/libs/B/B.pjx"), "cell/libs");
}

/// Disk of an application in the output of `--explain-config`.
fn explained_disk<'o>(output: &'o str, manifest: &str) -> &'o str {
    let line = output.lines().find(|line| line.contains(&format!("for {manifest}:"))).unwrap();
    line.rsplit(' ').next().unwrap()
}

#[test]
fn a_setting_takes_precedence_over_the_application() {
    let folder = with_copies();
    folder.write("cell/val3.toml", "disk = \".\"\n");
    let explained = folder.val3(&["check", "cell/libs/libs", "--explain-config"]).stdout;
    assert!(explained.lines().filter(|line| line.ends_with("Disk:// is cell")).count() == 2, "{explained}");
}

#[test]
fn two_types_of_one_name_are_shown_with_their_files() {
    let folder = with_copies();
    // The libraries have another disk root than the application.
    folder.write("cell/libs/val3.toml", "disk = \".\"\n");
    let run = folder.val3(&["check", "cell/app"]);
    assert_eq!(run.code, 1, "{run:?}");
    let message = "`take` takes an `A of libs/A/A.pjx` as `x_a`, not an `A of libs/libs/A/A.pjx`";
    assert!(run.stdout.contains(message), "{run:?}");
}

/// RoboDK exports an application with further projects in its subfolders.
#[test]
fn the_project_in_the_folder_is_meant_whatever_lies_below() {
    let folder = Folder::with("--- main\nprogram start()\nbegin\n  ? \"main\"\nend\n");
    let inner = Folder::with("--- part\nprogram start()\nbegin\n  ? \"part\"\nend\n");
    for name in ["part.pjx", "part.dtx", "start.pgx"] {
        let path = format!("usrapp/part/{name}");
        if inner.path().join(&path).exists() {
            folder.write(&format!("usrapp/main/part/{name}"), &inner.read(&path));
        }
    }
    for path in ["usrapp/main", "usrapp/main/main.pjx"] {
        let run = folder.val3(&["run", path]);
        assert_eq!((run.code, run.stdout.as_str()), (0, "main\n"), "{path}: {run:?}");
    }
    let mut command = folder.command(&["run", "."]);
    command.current_dir(folder.path().join("usrapp/main"));
    assert_eq!(crate::support::run(command).stdout, "main\n");
    let run = folder.val3(&["eval", "--app", "usrapp/main", "1+1"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "2\n"), "{run:?}");
    let several = folder.val3(&["run", "usrapp"]);
    assert_eq!(several.code, 2, "{several:?}");
    assert!(several.stderr.contains("holds 2 applications"), "{several:?}");
}
