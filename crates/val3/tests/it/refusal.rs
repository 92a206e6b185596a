//! Faults because of which an application is not started: the faults that the controller's compiler rejects.

use camino::Utf8PathBuf;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_check::rule::{Rule, Severity};
use val3_check::{refusals, rules};
use val3_lang::page;
use val3_test::{Fixture, ROOT};

use crate::support::{CommandOutput, Folder};

/// Rules of level error whose faults have an effect only at run time.
const AT_RUN_TIME: [&str; 21] = [
    "V0212", "V0225", "V0227", "V0230", "V0235", "V0241", "V0244", "V0247", "V0316", "V0320", "V0321", "V0322",
    "V0325", "V0329", "V0333", "V0401", "V0409", "V0410", "V0418", "V0501", "V0603",
];

/// First bad example of a rule, in a cell with a `val3.toml`. Rules about unreadable files have no example.
fn bad_example(rule: &Rule, settings: &str) -> Option<Workspace> {
    let section = format!("{}\n", page::section(rule.page, "Bad"));
    let listing = page::examples(&section).into_iter().next()?;
    let mut files = Fixture::parse(&listing).files;
    files.push(("val3.toml".to_owned(), settings.to_owned()));
    let system = Memory::new(files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.clone().into_bytes())));
    Some(load(&system, &[Utf8PathBuf::from(ROOT)]).unwrap())
}

fn refused_codes(workspace: &Workspace) -> Vec<&'static str> {
    let refused = workspace.projects.iter().flat_map(|project| refusals(&workspace.db, *project));
    refused.map(|finding| finding.rule.code).collect()
}

#[test]
fn all_faults_are_listed() {
    let faults = rules::all().iter().filter(|rule| rule.severity == Severity::Error);
    let mut tried = 0;
    for rule in faults {
        for settings in ["", "[rules]\nall = \"off\"\n"] {
            let Some(workspace) = bad_example(rule, settings) else { continue };
            tried += 1;
            let refused = refused_codes(&workspace);
            if AT_RUN_TIME.contains(&rule.code) {
                assert_eq!(refused, [""; 0], "{} with `{settings}`", rule.code);
                for project in &workspace.projects {
                    assert!(val3_compile::compile(&workspace.db, *project).is_ok(), "{}", rule.code);
                }
            } else if rule.code != "V0104" {
                // Most repositories do not contain the add-on tables, and their absence is no fault.
                assert!(refused.contains(&rule.code), "{} with `{settings}`: {refused:?}", rule.code);
            }
        }
    }
    assert!(tried > 150, "{tried} examples are too few");
}

#[test]
fn warnings_do_not_prevent_a_run() {
    let advice = rules::all().iter().filter(|rule| rule.severity != Severity::Error);
    for rule in advice {
        let Some(workspace) = bad_example(rule, "[rules]\nall = \"error\"\n") else { continue };
        assert!(!refused_codes(&workspace).contains(&rule.code), "{}", rule.code);
    }
}

#[track_caller]
fn is_refused(run: &CommandOutput, code: &str) {
    assert_eq!((run.code, run.stdout.as_str()), (1, ""), "{run:?}");
    assert!(run.stderr.contains(&format!("error[{code}]")), "{run:?}");
}

const ILL_TYPED: &str = "num n\nstring s\nprogram start()\nbegin\n  ? \"begun\"\n  n=s\n  ? s\nend\n";

#[test]
fn settings_cannot_make_ill_typed_code_run() {
    let folder = Folder::with(ILL_TYPED);
    is_refused(&folder.val3(&["run"]), "V0202");
    for settings in ["[rules]\nall = \"off\"\n", "[rules]\nV0202 = \"info\"\n", "exclude = [\"**/start.pgx\"]\n"] {
        folder.write("val3.toml", settings);
        is_refused(&folder.val3(&["run"]), "V0202");
    }
}

#[test]
fn comments_cannot_make_ill_typed_code_run() {
    let silenced = ILL_TYPED.replace("  n=s", "  //val3: allow(V0202)\n  n=s");
    is_refused(&Folder::with(&silenced).val3(&["run"]), "V0202");
}

#[test]
fn a_certain_run_time_error_is_shown_and_the_application_starts() {
    let folder = Folder::with("num n\nprogram start()\nbegin\n  ? \"begun\"\n  n=1/0\nend\n");
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (1, "begun\n"), "{run:?}");
    assert!(run.stderr.contains("error[V0230]") && run.stderr.contains("error[10]"), "{run:?}");
    folder.write("val3.toml", "[rules]\nall = \"off\"\n");
    let run = folder.val3(&["run"]);
    assert!(!run.stderr.contains("V0230") && run.stderr.contains("error[10]"), "{run:?}");
}

#[test]
fn libraries_that_do_not_match_their_interface_return_codes() {
    let folder = Folder::with(
        "library part \"Disk://box\"\nlibrary later \"Disk://box\" autoload=false\nprogram start()\nbegin\n  \
         ? part:libLoad(\"Disk://bag\")\n  ? later:libSave(\"Disk://copy\")\n  ? later:libLoad(\"Disk://broken\")\nend\n\
         program use()\nbegin\n  call part:pick(1)\nend\n--- box\npublic program pick(num x_nCount)\nbegin\nend\n--- bag\npublic num nWeight\n\
         --- broken\nnum n\npublic program pick(num x_nCount)\nbegin\n  n=\"one\"\nend\n",
    );
    folder.write("val3.toml", "[rules]\nall = \"off\"\n");
    let run = folder.val3(&["run", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.get(..6)), (0, Some("11\n10\n")), "{run:?}");
    assert!(run.stdout.ends_with("a `string` cannot be assigned to a `num`\n12\n"), "{run:?}");
}

#[test]
fn the_record_of_a_refused_application_is_json() {
    let folder = Folder::with(ILL_TYPED);
    let run = folder.val3(&["run", "--events", "-"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert_eq!(run.stdout, "{\"t\":0.0,\"kind\":\"end\",\"reason\":\"refused\"}\n");
    assert!(run.stderr.contains("error[V0202]"), "{run:?}");
}
