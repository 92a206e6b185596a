//! Evaluation in the stack frames of a stopped run.

use expect_test::expect;
use val3_debug::{AdvanceResult, DisplayFormat, Stop, StopErrors};
use val3_machine::controller::RunStatus;
use val3_machine::event::Event;
use val3_session::{EvaluationError, Pace, Purpose};
use val3_vm::FragmentContext;

use crate::stopped::{Stopped, VARIABLES, shown};

/// Formats `text: answer` as a line.
fn line(text: &str, answer: &str) -> String {
    format!("{}: {answer}", text.trim()).trim_end().to_owned() + "\n"
}

#[test]
fn expressions_see_all_variables_of_a_frame() {
    let texts = "x_nTotal+x_nFactor
        l_nMany[2]
        l_bDone
        x_sNames[1]+\"s\"
        nCount==3
        l_tSlot.nCount
        tSlots[\"right\"].nCount
        nGrid[1,2]
        len(sNames[1])
        size(l_nMany)
        l_nMany
        tSlots
        l_tSlot
        pHome.trsf.rz
        distance(x_pAt,pHome)
        mFast.blend
        appro(pHome,{0,0,1,0,0,0})
        taskStatus(\"main~\")
        here(flange,world).trsf.x
        diMissing
        1/0
        sNames[5]
        {1,2,3,0,0,0}
        clock()>=0";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> = texts.lines().map(|text| line(text, &stopped.watch(text))).collect();
    expect![[r#"
        x_nTotal+x_nFactor: num 4.5
        l_nMany[2]: num 9
        l_bDone: bool false
        x_sNames[1]+"s": string "bolts"
        nCount==3: bool true
        l_tSlot.nCount: num 2
        tSlots["right"].nCount: num 7
        nGrid[1,2]: num 5
        len(sNames[1]): num 4
        size(l_nMany): num 3
        l_nMany: num[3] 3 values
        tSlots: Slot[""] 2 values
        l_tSlot: Slot {nCount=2, sNames=…}
        pHome.trsf.rz: num 90
        distance(x_pAt,pHome): num 0
        mFast.blend: blend joint
        appro(pHome,{0,0,1,0,0,0}): point {{1,2,4,0,0,90},{ssame,esame,wsame}}
        taskStatus("main~"): num 1
        here(flange,world).trsf.x: num 50
        diMissing: `diMissing` is not declared: no local variable, parameter or data has this name
        1/0: error 10: division by zero
        sNames[5]: error 20: index too large
        {1,2,3,0,0,0}: the type of the values between these braces is unknown
        clock()>=0: bool true
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(shown(stopped.evaluate(1, "l_nOuter", Purpose::Watch)), "num 4");
    assert!(shown(stopped.evaluate(1, "l_nMany", Purpose::Watch)).contains("not declared"));
    assert_eq!(shown(stopped.evaluate(2, "nCount", Purpose::Watch)), "the stack frame no longer exists");
}

#[test]
fn watched_expressions_have_no_side_effects() {
    let texts = "nCount=4
        nCount=nCount=4
        movej(pHome,tGripper,mFast)
        call double(nCount)
        delay(1)
        link(pHome,world)
        ? nCount
        toNum(\"3\",nCount,l_bDone)
        getKey()
        while true
        nCount";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> = texts.lines().map(|text| line(text, &stopped.watch(text))).collect();
    expect![[r#"
        nCount=4: a statement has no value to show; execute it in the debug console
        nCount=nCount=4: a statement has no value to show; execute it in the debug console
        movej(pHome,tGripper,mFast): `movej` has side effects; execute it in the debug console
        call double(nCount): a statement has no value to show; execute it in the debug console
        delay(1): a statement has no value to show; execute it in the debug console
        link(pHome,world): a statement has no value to show; execute it in the debug console
        ? nCount: a statement has no value to show; execute it in the debug console
        toNum("3",nCount,l_bDone): `toNum` has side effects; execute it in the debug console
        getKey(): `getKey` has side effects; execute it in the debug console
        while true: `while` is a keyword of VAL 3 and cannot be a name
        nCount: num 3
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.watch("nCount\nnCount=4"), "write one expression");
    assert_eq!(stopped.watch(" "), "a value is expected here, but the line ends");
}

#[test]
fn the_console_executes_statements() {
    let texts = "call double(x_nTotal)
        nCount
        ? nCount+1
        putln(\"a\")
        delay(5)
        wait(nCount==1)
        watch(nCount==1,2)
        ? 1/0
        call endless()
        nMissing=3
        logMsg(\"x\")
        taskStatus(\"main~\")
        taskCreate \"other\",10,show(nCount,pHome,sNames,2)
        taskStatus(\"other\")";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> = texts.lines().map(|text| line(text, &stopped.execute(text))).collect();
    expect![[r#"
        call double(x_nTotal): 6
        nCount: num 6
        ? nCount+1: 7
        putln("a"): a
        delay(5):
        wait(nCount==1): it waits for an event that cannot happen while the run is stopped
        watch(nCount==1,2): bool false
        ? 1/0: error 10: division by zero
        call endless(): it was ended because it executes too many lines, probably in an endless loop
        nMissing=3: `nMissing` is not declared: no local variable, parameter or data has this name
        logMsg("x"): log: USR x
        bool true
        taskStatus("main~"): num 1
        taskCreate "other",10,show(nCount,pHome,sNames,2):
        taskStatus("other"): num 1
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.execute("l_nMany[0]=2\n? l_nMany[0]+1\nput(\"a\")"), "3\na");
    assert_eq!(stopped.execute("? 1\n? 1/0"), "1\nerror 10: division by zero");
}

#[test]
fn values_are_assigned_to_all_that_is_assignable() {
    let pairs = [
        ("x_nTotal", "12.5"),
        ("nCount", "nCount+l_nMany[2]"),
        ("x_pAt.trsf", "{1,2,3,0,0,0}"),
        ("x_pAt.config.shoulder", "righty"),
        ("l_bDone", "true"),
        ("x_sNames[1]", "\"nut\""),
        ("tSlots[\"right\"].nCount", "1"),
        ("nGrid[1,2]", "-1"),
        ("pHome", "{{0,0,0,0,0,0},{lefty,epositive,wpositive}}"),
        ("mFast.vel", "50"),
        ("l_bDone", "3"),
        ("nCount+1", "3"),
        ("nMissing", "3"),
        ("l_nMany[7]", "3"),
        ("nCount", "3\nnGrid[0,0]=1"),
        ("nCount", "1/0"),
        ("x_nFactor", ""),
    ];
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> =
        pairs.iter().map(|(target, value)| format!("{target}={value}: {}\n", stopped.assign(target, value))).collect();
    expect![[r#"
        x_nTotal=12.5: 12.5
        nCount=nCount+l_nMany[2]: 21.5
        x_pAt.trsf={1,2,3,0,0,0}: {1,2,3,0,0,0}
        x_pAt.config.shoulder=righty: righty
        l_bDone=true: true
        x_sNames[1]="nut": "nut"
        tSlots["right"].nCount=1: 1
        nGrid[1,2]=-1: -1
        pHome={{0,0,0,0,0,0},{lefty,epositive,wpositive}}: {{0,0,0,0,0,0},{lefty,epositive,wpositive}}
        mFast.vel=50: 50
        l_bDone=3: a `num` cannot be assigned to a `bool`
        nCount+1=3: a value can only be assigned to a variable
        nMissing=3: `nMissing` is not declared: no local variable, parameter or data has this name
        l_nMany[7]=3: error 20: index too large
        nCount=3
        nGrid[0,0]=1: `nCount` cannot be assigned to
        nCount=1/0: error 10: division by zero
        x_nFactor=: a value is expected here, but the line ends
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.watch("nCount"), "num 21.5");
}

const LIBRARY: &str = r#"
library part "Disk://part/part.pjx"
num nCount
program start()
begin
  nCount=2
  call part:show(nCount)
end
--- part
num nSecret
public num nWeight=5
public string sNames[2]
public program show(num& x_nTotal)
num l_nOwn
begin
  l_nOwn=x_nTotal+1
  nSecret=8
  ? "here"
end
program hidden()
begin
  nSecret=nSecret+1
end
"#;

#[test]
fn frames_of_libraries_see_their_library() {
    let mut stopped = Stopped::on_disk(LIBRARY);
    assert_eq!(stopped.watch("l_nOwn+nSecret+nWeight"), "num 16");
    assert_eq!(stopped.execute("call hidden()"), "");
    assert_eq!(stopped.watch("nSecret"), "num 9");
    assert_eq!(stopped.assign("x_nTotal", "nSecret"), "9");
    let of_caller = |stopped: &mut Stopped, text| shown(stopped.evaluate(1, text, Purpose::Watch));
    assert_eq!(of_caller(&mut stopped, "nCount+part:nWeight"), "num 14");
    assert!(of_caller(&mut stopped, "part:nSecret").contains("nSecret"), "it is private");
    assert_eq!(shown(stopped.evaluate(1, "call part:show(nCount)", Purpose::Execute)), "here");
    assert_eq!(stopped.watch("nSecret"), "num 8");
}

#[test]
fn later_changes_of_the_files_do_not_matter() {
    let mut stopped = Stopped::on_disk(LIBRARY);
    std::fs::remove_dir_all(stopped.folder.as_ref().unwrap().path().join("usrapp")).unwrap();
    assert_eq!(stopped.watch("l_nOwn+nSecret"), "num 11");
    assert_eq!(stopped.execute("call hidden()\n? nSecret"), "9");
}

#[test]
fn an_application_without_tasks_has_its_data() {
    let listing =
        "num nCount\nprogram start()\nbegin\n  nCount=2\n  call show()\nend\nprogram show()\nbegin\n  ? 1\nend\n";
    let mut stopped = Stopped::at(listing);
    stopped.debugger.controller.kill_tasks();
    assert_eq!(stopped.watch("nCount"), "the stack frame no longer exists");
    let (id, _) = stopped.debugger.controller.vm.space.loaded().next().unwrap();
    let context = FragmentContext::Instance(id);
    let mut evaluate = |text| {
        let (controller, format) = (&mut stopped.debugger.controller, DisplayFormat::default());
        shown(stopped.evaluator.evaluate(controller, context, text, Purpose::Execute, format))
    };
    assert_eq!(evaluate("nCount+1"), "num 3");
    assert_eq!(evaluate("nCount=nCount*2\ncall show()"), "1");
    assert_eq!(evaluate("nCount"), "num 4");
}

#[test]
fn the_run_does_not_notice_evaluations() {
    let [mut watched, mut unwatched] = [(); 2].map(|()| Stopped::at(COUNTED_CALLS));
    let seen = run_to_end(&mut watched, |stopped, stops| {
        let before = format!("{:?}", stopped.debugger.controller.vm.tasks());
        assert_eq!(stopped.watch("l_n[1]+1"), format!("num {}", stops + 2));
        assert!(stopped.watch("1/0").starts_with("error 10"));
        assert!(stopped.execute("? l_n[7]").starts_with("error 20"));
        assert_eq!(before, format!("{:?}", stopped.debugger.controller.vm.tasks()));
    });
    assert_eq!(seen, run_to_end(&mut unwatched, |_, _| ()));
    let [watched, unwatched] =
        [watched, unwatched].map(|stopped| stopped.debugger.controller.vm.space.memory.stores.room);
    assert_eq!(watched, unwatched);
}

const COUNTED_CALLS: &str = "num nCount\nprogram start()\nbegin\n  while nCount<20\n    nCount=nCount+1\n    call show()\n  \
                             endWhile\nend\nprogram show()\nnum l_n[3]\nbegin\n  l_n[1]=nCount\n  delay(0.01)\n  ? l_n[1]\nend\n";

/// Runs to the end and calls `at_stop` at each stop, with the number of stops. Returns the events and this number.
fn run_to_end(stopped: &mut Stopped, at_stop: impl Fn(&mut Stopped, usize)) -> (Vec<Event>, usize) {
    let (mut events, mut stops) = (Vec::new(), 0);
    loop {
        match stopped.debugger.advance() {
            AdvanceResult::Stopped(_) => {
                stops += 1;
                at_stop(stopped, stops);
            }
            AdvanceResult::Ran(RunStatus::Waiting(wake)) => {
                Pace::default().wait(&mut stopped.debugger.controller, wake);
            }
            AdvanceResult::Ran(status) if status.is_final() => return (events, stops),
            AdvanceResult::Ran(_) => {}
        }
        events.append(&mut stopped.debugger.controller.devices.take_events());
    }
}

#[test]
fn a_task_that_waits_within_a_line_is_evaluated_and_waits_on() {
    let listing = "num nCount\nprogram start()\nnum l_nOwn\nbegin\n  l_nOwn=5\n  call show()\n  delay(1)\n  nCount=l_nOwn\nend\n\
                   program show()\nbegin\n  ? 1\nend\n";
    let mut stopped = Stopped::at(listing);
    for _ in 0..3 {
        stopped.debugger.advance();
    }
    let wait = |stopped: &Stopped| stopped.debugger.controller.vm.tasks()[0].thread.wait;
    let before = wait(&stopped);
    assert!(before.is_some_and(|wait| wait.wake.is_some()), "{before:?}");
    assert_eq!(stopped.execute("l_nOwn=l_nOwn+1\ndelay(3)"), "");
    assert_eq!(stopped.watch("l_nOwn"), "num 6");
    assert_eq!(wait(&stopped), before);
}

#[test]
fn statements_may_stop_tasks() {
    let mut stopped = Stopped::at(VARIABLES);
    assert_eq!(stopped.execute("taskSuspend(\"main~\")\n? taskStatus(\"main~\")"), "0");
    assert_eq!(stopped.execute("taskKill(\"main~\")\n? nCount"), "3");
    assert_eq!(stopped.watch("nCount"), "the stack frame no longer exists");
    let outcomes: Vec<_> = (0..5).map(|_| stopped.debugger.advance()).collect();
    assert!(outcomes.contains(&AdvanceResult::Ran(RunStatus::Finished)), "{outcomes:?}");
}

#[test]
fn a_task_in_error_keeps_its_error() {
    let mut stopped = Stopped::at(
        "num nCount\nprogram start()\nnum l_n\nbegin\n  l_n=4\n  call show()\n  nCount=l_n/0\nend\nprogram show()\nbegin\n  ? \
         1\nend\n",
    );
    stopped.debugger.set_errors(StopErrors::all());
    let stop = stopped.debugger.advance();
    assert!(matches!(stop, AdvanceResult::Stopped(Stop::Error { .. })), "{stop:?}");
    let task = |stopped: &Stopped| format!("{:?}", stopped.debugger.controller.vm.tasks());
    let before = task(&stopped);
    assert_eq!(stopped.watch("l_n"), "num 4");
    assert_eq!(stopped.watch("taskStatus(\"main~\")"), "num 10");
    assert_eq!(stopped.execute("taskSuspend(\"other\")"), "error 30: no such task");
    assert_eq!(stopped.execute("? l_n\ncall show()"), "4\n1");
    assert_eq!(task(&stopped), before);
}

#[test]
fn texts_are_shown_as_expressions() {
    let mut stopped = Stopped::at(VARIABLES);
    stopped.execute("sNames[0]=\"a\"+chr(34)+chr(10)+\"b\"");
    let shown = stopped.watch("sNames[0]");
    assert_eq!(shown, "string \"a\"+chr(34)+\"\"+chr(10)+\"b\"");
    let expression = shown.strip_prefix("string ").unwrap();
    assert_eq!(stopped.watch(&format!("sNames[0]=={expression}")), "bool true");
}

#[test]
fn completions_know_the_variables_of_the_frame() {
    let mut stopped = Stopped::at(VARIABLES);
    for (depth, text, label) in [
        (0, "1<2 and l_nM", "l_nMany 8..12"),
        (0, "x_nT", "x_nTotal 0..4"),
        (0, "pHome.trsf.", "x 11..11"),
        (0, "\"<&\"+x_sN", "x_sNames 5..9"),
        (1, "l_nOut", "l_nOuter 0..6"),
        (0, "call dou", "double 5..8"),
    ] {
        let context = FragmentContext::Frame(stopped.task, depth);
        let found = stopped.evaluator.completions(&stopped.debugger.controller, context, text, text.len()).unwrap();
        let mut labels = found.into_iter().take(4).map(|found| format!("{} {:?}", found.insert, found.range));
        assert!(labels.any(|found| found == label), "{text}");
    }
}

#[test]
fn expressions_show_the_variable_that_they_refer_to() {
    let mut stopped = Stopped::at(VARIABLES);
    let refers_to = |text| stopped.evaluate(0, text, Purpose::Watch).unwrap().value.unwrap().refers_to;
    let texts =
        ["x_nTotal", "nCount", "x_pAt.trsf.x", "l_nMany[nCount-1]", "x_sNames", "nCount+1", "tSlots[\"right\"].nCount"];
    let found: Vec<_> = texts.map(refers_to).into_iter().map(Option::unwrap_or_default).collect();
    assert_eq!(found, ["nCount", "", "pHome.trsf.x", "l_nMany[2]", "sNames", "", ""]);
}

#[test]
fn faults_are_marked_in_the_text() {
    let mut stopped = Stopped::at(VARIABLES);
    for (text, purpose, excerpt) in [
        ("\"<&\"+nMissing", Purpose::Watch, "  \"<&\"+nMissing\n       ^^^^^^^^"),
        ("nCount=1\nnCount=true", Purpose::Execute, "  nCount=true\n         ^^^^"),
    ] {
        match stopped.evaluate(0, text, purpose) {
            Err(EvaluationError::Code(fault)) => assert_eq!(fault.excerpt(text).unwrap(), excerpt),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn statements_without_end_are_ended() {
    let mut stopped = Stopped::at(VARIABLES);
    let mut last = |text| stopped.execute(text).lines().last().unwrap().to_owned();
    assert_eq!(last("while true\n? 1\nendWhile"), "it was interrupted, or it has printed too much");
    assert_eq!(last("while true\nendWhile"), LIMIT);
    assert_eq!(last("call again(1)"), "error 41: out of task memory");
    assert_eq!(stopped.watch("nCount"), "num 3");
}

const LIMIT: &str = "it was ended because it executes too many lines, probably in an endless loop";

/// A program of a CS8: CDATA, CRLF, comments, keywords in other letter cases.
#[test]
fn frames_of_the_old_dialect_are_evaluated() {
    let old = "=== main/show.pgx\n<?xml version=\"1.0\" encoding=\"iso-8859-1\" ?>\n<programList \
               xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"ProgramNameSpace\">\n<program name=\"show\" \
               public=\"false\">\n<description></description>\n<paramSection>\n<param name=\"x_nTotal\" type=\"num\" \
               byVal=\"false\"/>\n</paramSection>\n<localSection>\n<local name=\"l_nMany\" type=\"num\" size=\"3\"/>\n\
               </localSection>\n<source><code><![CDATA[BEGIN\n  // shows <nothing>\n  l_nMany[1]=x_nTotal\n  ? \"here\"\nEND]]>\
               </code></source></program></programList>";
    let listing =
        format!("version s6.4\nnum nCount\nprogram start()\nbegin\n  nCount=3\n  call show(nCount)\nend\n{old}");
    for listing in [listing.clone(), listing.replace('\n', "\r\n")] {
        let mut stopped = Stopped::at(&listing);
        assert_eq!(stopped.watch("l_nMany[1]+x_nTotal"), "num 6");
        assert_eq!(stopped.watch("\"]]>\"+\"&<\""), "string \"]]>&<\"");
        assert_eq!(stopped.execute("FOR l_nMany[0]=1 TO 3\nx_nTotal=x_nTotal+1\nENDFOR"), "");
        assert_eq!(stopped.assign("l_nMany[2]", "nCount"), "6");
    }
}

#[test]
fn a_single_local_may_be_used_as_an_array() {
    let mut stopped = Stopped::at(VARIABLES);
    assert_eq!(stopped.watch("x_nFactor"), "num 1.5");
    assert_eq!(stopped.watch("size(l_bDone)"), "num 1");
    assert_eq!(stopped.watch("l_bDone[0]"), "bool false");
    assert_eq!(stopped.assign("l_bDone[0]", "true"), "true");
    assert_eq!(stopped.watch("l_bDone"), "bool true");
}
