//! Breakpoint conditions, and log points.

use val3_debug::{
    AdvanceResult, Breakpoint, BreakpointId, DataAccess, DataBreakpoint, Debugger, DisplayFormat, PastLimits,
    ProgramBreakpoint, StepKind, Stop, WatchedData,
};
use val3_machine::controller::RunStatus;
use val3_session::{FrameEvaluator, Pace, Purpose};
use val3_tests::running::{Running, application};
use val3_vm::{CounterId, FragmentContext};

use crate::stopped::on_disk;

/// Calls a program for the numbers 1 to 10. Line 2 of the program is `l_nTwice=x_nAt*2`.
const COUNTING: &str = "num nSum\nstring sNames[2]\nprogram start()\nnum l_n\nbegin\n  for l_n=1 to 10\n    call add(l_n)\n  \
                        endFor\nend\nprogram add(num x_nAt)\nnum l_nTwice\nbegin\n  nSum=nSum+x_nAt\n  l_nTwice=x_nAt*2\nend\n";

/// A run with one breakpoint at line 2 of `add`, with a condition, a hit condition and a message.
fn debugger([condition, hits, log]: [&str; 3]) -> Debugger {
    let mut debugger = Debugger::new(Running::start(COUNTING).controller);
    let mut evaluator = FrameEvaluator::new(application(COUNTING));
    let (file, row) = line(&debugger);
    let vm = &debugger.controller.vm;
    let is_given = |text: &&str| !text.is_empty();
    let breakpoint = Breakpoint {
        condition: Some(condition).filter(is_given).map(|text| evaluator.condition(vm, &file, text).unwrap()),
        hits: Some(hits).filter(is_given).map(|text| text.parse().unwrap()),
        log: Some(log).filter(is_given).map(|text| evaluator.log_message(vm, &file, text).unwrap()),
        ..Breakpoint::new(BreakpointId(1), row)
    };
    debugger.set_breakpoints(&file, vec![breakpoint]);
    debugger
}

fn line(debugger: &Debugger) -> (String, u32) {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let program = &application.image.programs[usize::from(application.image.program("add").unwrap())];
    (application.image.files[program.file as usize].clone(), program.lines[1].row)
}

/// Runs to the next stop, or to the end.
fn run(debugger: &mut Debugger) -> Option<Stop> {
    loop {
        match debugger.advance() {
            AdvanceResult::Stopped(stop) => return Some(stop),
            AdvanceResult::Ran(status) if status.is_final() => return None,
            AdvanceResult::Ran(RunStatus::Waiting(wake)) => {
                Pace::default().wait(&mut debugger.controller, wake)?;
            }
            AdvanceResult::Ran(_) => {}
        }
    }
}

/// Value of `nSum`.
fn sum(debugger: &Debugger) -> f64 {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let data = usize::from(application.image.data("nSum").unwrap());
    debugger.controller.vm.space.memory.store(application.data[data]).unwrap().nums[0]
}

/// Values of `nSum` at each stop.
fn sums(debugger: &mut Debugger) -> Vec<f64> {
    std::iter::from_fn(|| run(debugger).map(|_| sum(debugger))).collect()
}

fn messages(debugger: &mut Debugger) -> Vec<String> {
    debugger.take_logged().into_iter().map(|logged| logged.text).collect()
}

#[test]
fn a_task_stops_where_the_condition_holds() {
    assert_eq!(sums(&mut debugger(["x_nAt>=9", "", ""])), [45.0, 55.0]);
    assert_eq!(sums(&mut debugger(["x_nAt==3 and l_nTwice==0 and size(sNames)==2", "", ""])), [6.0]);
    assert_eq!(sums(&mut debugger(["false", "", ""])), [0.0; 0]);
}

/// Number of times that a task reaches a stop mark up to the end of the run.
fn interruptions(mut debugger: Debugger) -> usize {
    let steps = std::iter::repeat_with(|| debugger.controller.step()).take_while(|status| !status.is_final());
    steps.filter(|status| matches!(status, RunStatus::AtStop(_))).count()
}

/// Conditions without instructions other than mathematical functions are evaluated within the turn, so a line at which
/// they are false costs a few operations. All other conditions end the turn at each arrival.
#[test]
fn conditions_of_numbers_do_not_interrupt_the_run() {
    for condition in ["x_nAt==11", "nSum>55 or l_nTwice*2!=0", "abs(x_nAt%4)>3 and !(nSum<0)", "false"] {
        assert_eq!(interruptions(debugger([condition, "", ""])), 0, "{condition}");
    }
    assert_eq!(interruptions(debugger(["size(sNames)==3", "", ""])), 10);
}

/// The virtual machine counts hits that are no stops within the turn.
#[test]
fn counted_hits_do_not_interrupt_the_run() {
    for (condition, hits, passes, expected) in
        [("", ">=5", 4, 6), ("x_nAt>2", "%3", 2, 6), ("", "3", u64::MAX, 0), ("", ">=5", 0, 10)]
    {
        let mut debugger = debugger([condition, hits, ""]);
        debugger.controller.vm.count_hits([(CounterId(1), passes)]);
        assert_eq!(interruptions(debugger), expected, "{condition} {hits}");
    }
}

#[test]
fn both_forms_of_a_hit_condition_stop_at_the_same_hits() {
    for hits in ["1", "4", "10", "11", ">=1", ">=7", ">9", "<4", "<=10", "%1", "%3", "%10", "%11"] {
        for condition in ["", "x_nAt%2==0", "x_nAt>3"] {
            let general = format!("size(sNames)==2 and ({})", if condition.is_empty() { "true" } else { condition });
            let (mut counted, mut stopped) = (debugger([condition, hits, ""]), debugger([&general, hits, ""]));
            assert_eq!(sums(&mut counted), sums(&mut stopped), "{condition} {hits}");
            assert_eq!(counted.hits(BreakpointId(1)), stopped.hits(BreakpointId(1)), "{condition} {hits}");
        }
    }
}

/// Hits that the virtual machine has counted belong to the moment of each snapshot, too.
#[test]
fn counted_hits_go_back_with_the_run() {
    let mut debugger = debugger(["", "%4", ""]);
    debugger.record(PastLimits::snapshots(20));
    assert_eq!(sums(&mut debugger), [10.0, 36.0]);
    let mut hits = Vec::new();
    while debugger.run_back() != Stop::Beginning {
        hits.push(debugger.hits(BreakpointId(1)));
    }
    assert_eq!(hits, [10, 9, 8, 7, 6, 5, 4, 3, 2, 1]);
    assert_eq!(sums(&mut debugger), [10.0, 36.0], "the same hits come again");
}

#[test]
fn both_forms_of_a_condition_stop_at_the_same_lines() {
    for condition in
        ["nSum>=20", "x_nAt%3==1", "(x_nAt>2 and nSum<30) or x_nAt==9", "x_nAt*x_nAt-nSum/2>10", "10/(5-x_nAt)>3"]
    {
        let general = format!("size(sNames)==2 and ({condition})");
        assert_eq!(sums(&mut debugger([condition, "", ""])), sums(&mut debugger([&general, "", ""])), "{condition}");
        let back = |condition: &str| {
            let mut debugger = debugger([condition, "", ""]);
            debugger.record(PastLimits::snapshots(20));
            while run(&mut debugger).is_some() {}
            std::iter::from_fn(|| (debugger.run_back() != Stop::Beginning).then(|| sum(&debugger))).collect::<Vec<_>>()
        };
        assert_eq!(back(condition), back(&general), "{condition}");
    }
}

/// Reads of every kind of value. Line 2 of `add` is after the writes.
const VALUES: &str = r#"
type Slot "Disk://Slot/Slot.pjx"
num nSum
bool bOdd
string sNames[2]
Slot tOne
Slot tMany[3]
program start()
num l_n
begin
  for l_n=1 to 10
    sNames[1]=toString(".0",l_n)
    tOne.nOwn=l_n
    tMany[2].sName=sNames[1]
    bOdd=l_n%2==1
    call add(l_n)
  endFor
end
program add(num x_nAt)
num l_nList[3]
string l_sOwn
bool l_bBig
num l_nTwice
begin
  l_nList[1]=x_nAt
  nSum=nSum+x_nAt
  l_sOwn=sNames[1]
  l_bBig=x_nAt>7
  call look(l_nList,l_sOwn,l_bBig)
end
program look(num& x_nList[], string& x_sOwn, bool& x_bBig)
num l_nCopy[2]
begin
  l_nCopy[1]=x_nList[1]
  l_nCopy[0]=1
end
--- Slot
public num nOwn
public string sName
"#;

/// Conditions that read strings, flags, local arrays and fields are evaluated within the turn, and stop where the general
/// form stops.
#[test]
fn conditions_read_values_of_all_kinds_within_the_turn() {
    let at = |condition: &str| {
        let mut debugger = Debugger::new(Running::start(VALUES).controller);
        let mut evaluator = FrameEvaluator::new(application(VALUES));
        let (_, main) = debugger.controller.vm.space.loaded().next().unwrap();
        let program = &main.image.programs[usize::from(main.image.program("look").unwrap())];
        let (file, row) = (main.image.files[program.file as usize].clone(), program.lines[1].row);
        let condition = evaluator.condition(&debugger.controller.vm, &file, condition).unwrap();
        let breakpoint = Breakpoint { condition: Some(condition), ..Breakpoint::new(BreakpointId(1), row) };
        debugger.set_breakpoints(&file, vec![breakpoint]);
        debugger
    };
    for (condition, stops) in [
        ("sNames[1]==\"3\"", 1),
        ("sNames[1]!=\"3\"", 9),
        ("x_sOwn==\"4\" or \"5\"==x_sOwn", 2),
        ("bOdd", 5),
        ("!bOdd", 5),
        ("x_bBig", 3),
        ("x_nList[1]>8", 2),
        ("l_nCopy[1]==x_nList[1]", 10),
        ("tOne.nOwn==6", 1),
        ("tMany[2].sName==\"7\" and tMany[1].nOwn==0", 1),
    ] {
        let never = format!("nSum<0 and ({condition})");
        assert_eq!(interruptions(at(&never)), 0, "{condition}");
        let mut debugger = at(condition);
        assert_eq!(std::iter::from_fn(|| run(&mut debugger)).count(), stops, "{condition}");
        let mut general = at(&format!("size(sNames)==2 and ({condition})"));
        assert_eq!(std::iter::from_fn(|| run(&mut general)).count(), stops, "{condition}");
    }
    for condition in ["bOdd and !bOdd", "sNames[1]==\"\"", "x_nList[1]<0", "tOne.nOwn==0", "tMany[2].sName==\"x\""] {
        assert_eq!(interruptions(at(condition)), 0, "{condition}");
    }
}

/// An index out of range stops the task with the run-time error, as in the general form.
#[test]
fn a_condition_with_an_invalid_index_is_reported() {
    let mut debugger = debugger(["sNames[x_nAt]==\"x\"", "", ""]);
    let Some(Stop::Breakpoints { faults, .. }) = run(&mut debugger) else { panic!("no stop") };
    assert_eq!((sum(&debugger), faults[0].message.as_str()), (3.0, "error 20: index too large"));
}

#[test]
fn only_hits_with_the_condition_count() {
    // The third of the numbers 2, 4, 6, 8 and 10.
    assert_eq!(sums(&mut debugger(["x_nAt/2==round(x_nAt/2)", "3", ""])), [21.0]);
    assert_eq!(sums(&mut debugger(["x_nAt>5", "%2", ""])), [28.0, 45.0]);
}

#[test]
fn a_condition_with_a_run_time_error_stops_the_task_and_is_reported() {
    let mut debugger = debugger(["1/(x_nAt-4)>1", "", ""]);
    let Some(Stop::Breakpoints { task, ids, faults }) = run(&mut debugger) else { panic!("no stop") };
    assert_eq!((sum(&debugger), ids), (10.0, vec![BreakpointId(1)]));
    assert_eq!(faults[0].message, "error 10: division by zero");
    assert_eq!(debugger.controller.vm.tasks().iter().find(|known| known.id == task).unwrap().status(), 1);
    assert_eq!(sums(&mut debugger), [0.0; 0], "5 is not greater, and the task runs on");
}

#[test]
fn log_points_write_messages_and_do_not_stop() {
    let mut logging = debugger(["", "", "{{x}} is {x_nAt}, {sNames[0]+\"}\"} {1/(x_nAt-1)}{{}}"]);
    assert_eq!(sums(&mut logging), [0.0; 0]);
    let messages = messages(&mut logging);
    assert_eq!(messages.len(), 10);
    assert_eq!(messages[..2], ["{x} is 1, } error 10: division by zero{}", "{x} is 2, } 1{}"]);
}

#[test]
fn variables_without_an_index_are_their_first_values() {
    const FLAGS: &str = "bool bOn\nstring sName\nprogram start()\nbegin\n  sName=\"ab\"\n  bOn=true\n  call add(2)\nend\nprogram \
                         add(num x_nAt)\nbegin\n  ? 1\n  ? 2\nend\n";
    let mut debugger = Debugger::new(Running::start(FLAGS).controller);
    let mut evaluator = FrameEvaluator::new(application(FLAGS));
    let (file, row) = line(&debugger);
    let vm = &debugger.controller.vm;
    let breakpoint = Breakpoint {
        condition: Some(evaluator.condition(vm, &file, "bOn").unwrap()),
        log: Some(evaluator.log_message(vm, &file, "{sName} is {bOn}").unwrap()),
        ..Breakpoint::new(BreakpointId(1), row)
    };
    debugger.set_breakpoints(&file, vec![breakpoint]);
    assert_eq!(run(&mut debugger), None);
    assert_eq!(messages(&mut debugger), ["ab is true"]);
}

#[test]
fn log_points_follow_their_conditions() {
    let mut logging = debugger(["x_nAt>4", "%3", "{x_nAt}"]);
    assert_eq!(sums(&mut logging), [0.0; 0]);
    assert_eq!(messages(&mut logging), ["7", "10"]);
}

#[test]
fn a_run_back_stops_where_the_condition_holds() {
    let mut debugger = debugger(["x_nAt==3 or x_nAt==8", "", ""]);
    debugger.record(PastLimits::snapshots(20));
    assert_eq!(sums(&mut debugger), [6.0, 36.0]);
    for expected in [(36.0, true), (6.0, true), (0.0, false)] {
        let stop = debugger.run_back();
        assert_eq!((sum(&debugger), matches!(stop, Stop::Breakpoints { .. })), expected);
    }
}

#[test]
fn a_past_counts_the_same_hits_and_writes_no_message_twice() {
    let mut debugger = debugger(["x_nAt>4", ">=2", ""]);
    debugger.record(PastLimits::snapshots(20));
    let Some(Stop::Breakpoints { task, .. }) = run(&mut debugger) else { panic!("no stop") };
    assert_eq!(sum(&debugger), 21.0);
    debugger.step_back(task, StepKind::Over);
    assert_eq!(sums(&mut debugger), [21.0, 28.0, 36.0, 45.0, 55.0], "the second hit comes again");
    let mut logging = self::debugger(["", "", "{x_nAt}"]);
    logging.record(PastLimits::snapshots(20));
    while messages(&mut logging).first().is_none_or(|last| last != "10") {
        logging.advance();
    }
    let task = logging.controller.vm.tasks()[0].id;
    logging.step_back(task, StepKind::Over);
    assert_eq!(messages(&mut logging), [""; 0]);
}

#[test]
fn a_condition_in_a_library_that_is_loaded_later_is_compiled_before() {
    let listing = "library part \"Disk://part/part.pjx\" autoload=false\nnum nCount\nprogram start()\nbegin\n  \
                   part:libLoad(\"Disk://part\")\n  for nCount=1 to 5\n    call part:work(nCount)\n  endFor\nend\n--- part\npublic \
                   num nSum\nnum nOwn\npublic program other()\nbegin\nend\npublic program work(num x_nAt)\nbegin\n  nSum=nSum+x_nAt\n  \
                   nOwn=1\nend\n";
    let (folder, mut controller, application) = on_disk(listing);
    let file = folder.path().join("usrapp/part/work.pgx").to_str().unwrap().to_owned();
    let mut evaluator = FrameEvaluator::new(application);
    controller.start("start").unwrap();
    let mut debugger = Debugger::new(controller);
    let condition = evaluator.condition(&debugger.controller.vm, &file, "nSum==6 and x_nAt==3").unwrap();
    let row = 1 + std::fs::read_to_string(&file).unwrap().lines().position(|line| line.contains("nOwn=1")).unwrap();
    let breakpoint = Breakpoint::new(BreakpointId(0), u32::try_from(row).unwrap());
    let placed = debugger.set_breakpoints(&file, vec![Breakpoint { condition: Some(condition), ..breakpoint }]);
    assert_eq!(placed[0].row, None, "it is not in memory");
    let Some(Stop::Breakpoints { task, faults, .. }) = run(&mut debugger) else { panic!("no stop") };
    assert_eq!(faults, []);
    let context = FragmentContext::Frame(task, 0);
    let sum = evaluator
        .evaluate(&mut debugger.controller, context, "nSum", Purpose::Watch, DisplayFormat::default())
        .unwrap();
    assert_eq!(sum.value.unwrap().shown, "6");
    assert_eq!(run(&mut debugger), None);
}

/// The breakpoint names the library, the identifier, or only the program.
#[test]
fn a_program_of_a_library_that_is_loaded_later_has_a_breakpoint() {
    let listing = "library tools \"Disk://part/part.pjx\" autoload=false\nnum nCount\nprogram start()\nbegin\n  \
                   tools:libLoad(\"Disk://part\")\n  for nCount=1 to 3\n    call tools:work(nCount)\n  endFor\nend\n\
                   --- part\npublic num nSum\npublic program work(num x_nAt)\nbegin\n  nSum=nSum+x_nAt\nend\n";
    for (name, expected) in [("work", 3), ("tools:work", 3), ("part:work", 3), ("main:work", 0), ("tools:Work", 0)] {
        let (_folder, mut controller, _) = on_disk(listing);
        controller.start("start").unwrap();
        let mut debugger = Debugger::new(controller);
        debugger.record(PastLimits::snapshots(20));
        let breakpoint = ProgramBreakpoint::new(BreakpointId(0), name.parse().unwrap());
        let placed = debugger.set_program_breakpoints(vec![breakpoint]);
        assert_eq!(placed[0].places, [], "it is not in memory");
        let stops = std::iter::from_fn(|| run(&mut debugger)).count();
        assert_eq!(stops, expected, "{name}");
        let found = debugger.placed_programs();
        assert_eq!(found[0].places.len(), usize::from(expected > 0), "{name}");
        let back = (0..expected).filter(|_| debugger.run_back() != Stop::Beginning).count();
        assert_eq!(back, expected, "{name}");
    }
}

/// Data of a library are watched in the program that uses it, and while the library changes them.
#[test]
fn data_of_a_library_are_watched() {
    let listing = "library tools \"Disk://part/part.pjx\"\nnum nCount\nprogram start()\nbegin\n  for nCount=1 to 3\n    call \
                   tools:work(nCount)\n  endFor\n  tools:nSum=0\nend\n--- part\npublic num nSum\npublic program work(num \
                   x_nAt)\nbegin\n  nSum=nSum+x_nAt\nend\n";
    let (_folder, mut controller, _) = on_disk(listing);
    let task = controller.start("start").unwrap();
    let mut debugger = Debugger::new(controller);
    let data = WatchedData::new(&mut debugger.controller, FragmentContext::Frame(task, 0), "tools:nSum").unwrap();
    assert_eq!(data.id(), "part:nSum");
    let breakpoint =
        DataBreakpoint { id: BreakpointId(0), data, access: DataAccess::Write, condition: None, hits: None };
    debugger.set_data_breakpoints(vec![breakpoint]);
    let mut changes = Vec::new();
    while let Some(Stop::Data(stop)) = run(&mut debugger) {
        changes.push(format!("{}: {}", stop.line.unwrap().program, stop.changes[0].new));
    }
    assert_eq!(changes, ["work: 1", "work: 3", "work: 6", "start: 0"]);
}

#[test]
fn wrong_conditions_and_messages_are_refused() {
    let debugger = Debugger::new(Running::start(COUNTING).controller);
    let mut evaluator = FrameEvaluator::new(application(COUNTING));
    let (file, _) = line(&debugger);
    let vm = &debugger.controller.vm;
    let mut condition = |text| evaluator.condition(vm, &file, text).unwrap_err().to_string();
    assert_eq!(condition("x_nAt"), "a condition is a bool, such as `nCount>3`");
    assert!(condition("l_n>3").contains("`l_n` is not declared"), "it is a variable of another program");
    assert_eq!(condition("nSum=3"), "a statement has no value to show; execute it in the debug console");
    assert_eq!(condition("isKeyPressed(getKey())"), "`getKey` has side effects; execute it in the debug console");
    let mut message = |text| evaluator.log_message(vm, &file, text).unwrap_err().to_string();
    assert_eq!(message("a {x_nAt"), "write `}` after the expression, or `{{` for a brace");
    assert_eq!(message("a } b"), "write `}}` for a brace");
    assert!(message("{nMissing}").contains("`nMissing` is not declared"));
    let unknown = evaluator.condition(vm, "/nowhere/x.pgx", "true").unwrap_err().to_string();
    assert_eq!(unknown, "the file holds no program of the application or its libraries");
}
