use std::ops::ControlFlow;

use camino::Utf8Path;
use val3_test::Fixture;

use super::*;
use crate::Delay;

/// Collects the output.
#[derive(Default)]
struct Answers(Vec<String>);

impl Listener for Answers {
    fn answer(&mut self, answer: &EvaluationOutput) -> ControlFlow<()> {
        self.0.push(answer.to_string());
        ControlFlow::Continue(())
    }

    fn wait(&mut self, delay: Delay) {
        assert_eq!(delay, Delay::None, "no test talks to the outside");
    }
}

fn evaluated(evaluator: &mut Evaluator, texts: &[&str]) -> Vec<String> {
    let mut answers = Answers::default();
    texts.iter().for_each(|text| evaluator.evaluate(text, &mut answers));
    answers.0
}

fn empty() -> Evaluator {
    Evaluator::open(None, "/nowhere".into(), &[], &ControllerSettings::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn texts_share_variables_and_keep_their_values() {
    let answers = evaluated(&mut empty(), &["num nA=2", "nA=nA+1", "nA", "string s", "s=\"x\"", "nA", "s"]);
    assert_eq!(answers, ["3", "3", "\"x\""]);
}

#[test]
fn faults_do_not_change_variables() {
    let answers = evaluated(&mut empty(), &["num nA=7", "num if", "nX", "nA+", "1/0", "nA"]);
    assert_eq!(answers.len(), 5, "{answers:?}");
    assert!(answers[..3].iter().all(|answer| answer.starts_with("error: ")), "{answers:?}");
    assert_eq!(answers[3..], ["error 10: division by zero", "7"]);
}

#[test]
fn pasted_blocks_execute_only_the_chosen_branch() {
    let code = "num nA=2\nswitch nA\n  case 0\n    nA=10\n  break\n  case 2\n    if nA==2\n      switch nA\n        \
                default\n          nA=20\n        break\n      endSwitch\n    endIf\n  break\nendSwitch\nnA";
    let texts = texts(code);
    assert_eq!(evaluated(&mut empty(), &texts.iter().map(String::as_str).collect::<Vec<_>>()), ["20"]);
}

#[test]
fn characters_of_xml_are_ordinary_characters() {
    let texts = ["\"a]]>b\"", "\"a<b&amp;'\"", "1<2 and 2>=1", "\"&#65;<\""];
    assert_eq!(evaluated(&mut empty(), &texts), ["\"a]]>b\"", "\"a<b&amp;'\"", "true", "\"&#65;<\""]);
}

/// Excerpt of the fault in the code.
fn excerpt(text: &str) -> String {
    #[derive(Default)]
    struct Faults(Vec<CodeFault>);
    impl Listener for Faults {
        fn answer(&mut self, answer: &EvaluationOutput) -> ControlFlow<()> {
            self.0.extend(answer.fault().cloned());
            ControlFlow::Continue(())
        }
        fn wait(&mut self, _: Delay) {}
    }
    let mut faults = Faults::default();
    empty().evaluate(text, &mut faults);
    faults.0.first().and_then(|fault| fault.excerpt(text)).unwrap_or_default()
}

#[test]
fn faults_are_marked_among_characters_of_xml() {
    assert_eq!(excerpt("\"]]>\"+nX+\"<\""), "  \"]]>\"+nX+\"<\"\n        ^^");
    assert_eq!(excerpt("? \"&\"\n? \"é<\"+nX"), "  ? \"é<\"+nX\n         ^^");
    assert_eq!(excerpt("1<>nX"), "  1<>nX\n   ^^");
}

#[test]
fn an_endless_wait_is_reported_with_its_position() {
    let answers = evaluated(&mut empty(), &["num nA", "nA=1\nwait(nA==2)", "nA"]);
    assert_eq!(answers, ["error: line 2 waits for a condition, and nothing here can end the wait", "1"]);
}

#[test]
fn a_listener_can_end_a_text() {
    struct Once(usize);
    impl Listener for Once {
        fn answer(&mut self, _: &EvaluationOutput) -> ControlFlow<()> {
            self.0 += 1;
            ControlFlow::Break(())
        }
        fn wait(&mut self, _: Delay) {}
    }
    let (mut evaluator, mut once) = (empty(), Once(0));
    evaluator.evaluate("while true\n? 1\nendWhile", &mut once);
    assert_eq!(once.0, 1);
    assert_eq!(evaluated(&mut evaluator, &["2"]), ["2"]);
}

/// Evaluator of a listing's application, with its folder.
fn of_listing(listing: &str) -> (tempfile::TempDir, Evaluator) {
    let folder = tempfile::tempdir().unwrap();
    let root = Utf8Path::from_path(folder.path()).unwrap();
    for (path, text) in &Fixture::parse(listing).files {
        let path = root.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let application = root.join("usrapp/main");
    let evaluator = Evaluator::open(Some(&application), root, &[], &ControllerSettings::default());
    (folder, evaluator.unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn later_changes_of_the_files_are_ignored() {
    let (folder, mut evaluator) =
        of_listing("num nCount\nnCount=1\nprogram double(num& x_nA)\nbegin\n  x_nA=x_nA*2\nend\n");
    assert!(evaluator.has_variable("nCount"));
    assert_eq!(evaluated(&mut evaluator, &["nCount=4", "call double(nCount)", "nCount"]), ["8"]);
    std::fs::remove_dir_all(folder.path().join("usrapp")).unwrap();
    assert_eq!(evaluated(&mut evaluator, &["num nNew=1", "nCount+nNew"]), ["9"]);
}

#[test]
fn positions_are_for_the_arm_of_the_application() {
    let settings = ControllerSettings { arm: Some("TS2-60".to_owned()), ..ControllerSettings::default() };
    let locals = ["point pA".to_owned(), "joint jA".to_owned()];
    let mut evaluator = Evaluator::open(None, "/nowhere".into(), &locals, &settings).unwrap();
    let answers =
        evaluated(&mut evaluator, &["pA", "jA", "config cA", "pA.config", "pA=here(flange,world)", "pA.config"]);
    assert_eq!(answers, ["{{0,0,0,0,0,0},{ssame}}", "{0,0,0,0}", "{ssame}", "{lefty}"]);
    let (_folder, mut evaluator) = of_listing("pointRs pA\nprogram idle()\nbegin\nend\n");
    let answers = evaluated(&mut evaluator, &["point pB", "pB=pA", "pB", "joint jB", "jB"]);
    assert_eq!(answers, ["{{0,0,0,0,0,0},{ssame}}", "{0,0,0,0}"]);
}

#[test]
fn libraries_are_loaded_on_demand() {
    let (_folder, mut evaluator) = of_listing(
        "library part \"Disk://part/part.pjx\"\nnum nA\ncall part:init()\n--- part\npublic num nWeight=5\n\
         public program init()\nbegin\nend\n--- other\npublic num nWeight=6\npublic program init()\nbegin\nend\n",
    );
    let answers = evaluated(&mut evaluator, &["part:nWeight", "part:libLoad(\"Disk://other\")", "part:nWeight"]);
    assert_eq!(answers, ["5", "0", "6"]);
}

#[test]
fn completions_know_variables_and_instructions() {
    let mut evaluator = empty();
    evaluated(&mut evaluator, &["num nSpeed"]);
    let names: Vec<String> = evaluator.completions("nSp", 3).into_iter().map(|(_, name)| name).collect();
    assert!(names.contains(&"nSpeed".to_owned()), "{names:?}");
    let found = evaluator.completions("1<2 and nSpe", 12);
    assert!(found.contains(&(8, "nSpeed".to_owned())), "{found:?}");
}
