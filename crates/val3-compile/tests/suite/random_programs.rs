//! Laws of execution, over random programs.

use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::Ordering::Relaxed;

use proptest::prelude::*;
use val3_machine::controller::RunStatus;
use val3_machine::event::Event;

use crate::execution::{LINE_COST, events, rest, run_at, started};
use crate::show::{counted_image, image};

/// A statement of a random program.
#[derive(Debug, Clone)]
enum Statement {
    Assign(String, String),
    If(String, Vec<Self>, Vec<Self>),
    For(String, Vec<Self>),
    While(Vec<Self>),
    Call(&'static str, String, String),
    /// A statement with the whole numbers `l_nU` and `l_nV` and the truth value `l_bIs`.
    Count(&'static str),
    Print(String),
    Leave(String),
}

fn variable() -> impl Strategy<Value = String> {
    let indexed =
        (prop::sample::select(vec!["nA", "l_nB"]), 0..6).prop_map(|(array, index)| format!("{array}[{index}]"));
    let computed =
        prop::sample::select(vec!["nA[l_nI]", "l_nB[l_nJ/2]", "nG[l_nI,1]", "nG[1,l_nJ]"]).prop_map(str::to_owned);
    let plain = prop::sample::select(vec!["l_nI", "l_nJ", "l_nK", "nX", "nY"]).prop_map(str::to_owned);
    prop_oneof![6 => plain, 1 => indexed, 2 => computed]
}

/// Functions of numbers, with their number of arguments.
const FUNCTIONS: [(&str, usize); 17] = [
    ("abs", 1),
    ("bAnd", 2),
    ("bNot", 1),
    ("bOr", 2),
    ("bXor", 2),
    ("cos", 1),
    ("exp", 1),
    ("limit", 3),
    ("ln", 1),
    ("max", 2),
    ("min", 2),
    ("power", 2),
    ("round", 1),
    ("roundDown", 1),
    ("roundUp", 1),
    ("sin", 1),
    ("sqrt", 1),
];

/// Statements on whole numbers, including numbers that are too large to be exact, and on truth values.
const COUNTS: [&str; 19] = [
    "l_nU=0",
    "l_nU=l_nU+1",
    "l_nU=l_nV",
    "l_nU=l_nU-l_nV",
    "l_nU=l_nU*l_nV",
    "l_nV=3",
    "l_nV=l_nV+l_nU",
    "l_nV=-2",
    "l_nV=9007199254740990",
    "for l_nU=0 to 5\nnA[l_nU]=nA[l_nU]+l_nV\nendFor",
    "for l_nU=5 to 1 step -2\nnX=nA[l_nU]*l_nU\nendFor",
    "if l_nU>=0 and l_nU<6\nnY=nY+nA[l_nU]\nbSeen[l_nU]=!bSeen[l_nU]\nendIf",
    "if l_nV>=0 and l_nV<=5\nl_bIs=bSeen[l_nV]\nnG[1,l_nV/2]=l_nU\nendIf",
    "l_bIs=l_nU<l_nV",
    "if l_bIs\nnX=nX+1\nl_bIs=false\nendIf",
    "bSeen[2]=l_bIs",
    "nX=nA[l_nU]",
    "nFills=nFills+1\nif nFills<30\nfor l_nU=3 to 299\nnLong[l_nU]=l_nV\nendFor\nendIf",
    "nFills=nFills+1\nif nFills<30\nfor l_nU=0 to 260+l_nV\nbLong[l_nU]=l_bIs\nendFor\nnX=nX+nLong[l_nI]\nendIf",
];

fn call_of(((name, takes), a, b, c): ((&str, usize), String, String, String)) -> String {
    let arguments: Vec<String> = [a, b, c].into_iter().take(takes).collect();
    format!("{name}({})", arguments.join(","))
}

fn expression() -> impl Strategy<Value = String> {
    let number = prop::sample::select(vec!["0", "1", "2", "3", "-1", "0.5", "7", "1e9"]).prop_map(str::to_owned);
    let leaf = prop_oneof![3 => variable(), 2 => number];
    leaf.prop_recursive(3, 8, 2, |inner| {
        let operator = prop::sample::select(vec!["+", "-", "*", "+", "-", "/", "%"]);
        prop_oneof![
            4 => (inner.clone(), operator, inner.clone()).prop_map(|(a, operator, b)| format!("({a}{operator}{b})")),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => (prop::sample::select(FUNCTIONS.to_vec()), inner.clone(), inner.clone(), inner).prop_map(call_of),
        ]
    })
}

fn condition() -> impl Strategy<Value = String> {
    let operator = prop::sample::select(vec!["<", "<=", ">", ">=", "==", "!="]);
    let compared =
        (expression(), operator, expression()).prop_map(|(a, operator, b)| format!("{a}{operator}{b}")).boxed();
    let pair = (compared.clone(), prop::sample::select(vec!["and", "or", "xor"]), compared.clone());
    prop_oneof![3 => compared, 1 => pair.prop_map(|(a, operator, b)| format!("({a}) {operator} !({b})"))]
}

fn statements() -> impl Strategy<Value = Vec<Statement>> {
    let leaf = prop_oneof![
        6 => (variable(), expression()).prop_map(|(to, value)| Statement::Assign(to, value)),
        1 => (prop::sample::select(vec!["twice", "both", "down"]), expression(), variable())
            .prop_map(|(name, given, result)| Statement::Call(name, given, result)),
        2 => prop::sample::select(COUNTS.to_vec()).prop_map(Statement::Count),
        1 => expression().prop_map(Statement::Print),
        1 => condition().prop_map(Statement::Leave),
    ];
    let statement = leaf.prop_recursive(3, 16, 4, |inner| {
        let block = prop::collection::vec(inner, 1..4);
        prop_oneof![
            2 => (condition(), block.clone(), block.clone()).prop_map(|(on, yes, no)| Statement::If(on, yes, no)),
            2 => ("[1-9]", block.clone()).prop_map(|(to, body)| Statement::For(to, body)),
            1 => block.prop_map(Statement::While),
        ]
    });
    prop::collection::vec(statement, 2..7)
}

/// Writes statements as source. Each loop has a separate counter, so that it ends.
fn write(statements: &[Statement], loops: &mut u32, text: &mut String) {
    for statement in statements {
        match statement {
            Statement::Assign(to, value) => writeln!(text, "{to}={value}").unwrap(),
            Statement::If(on, yes, no) => {
                writeln!(text, "if {on}").unwrap();
                write(yes, loops, text);
                text.push_str("else\n");
                write(no, loops, text);
                text.push_str("endIf\n");
            }
            Statement::For(to, body) => {
                *loops += 1;
                let counter = format!("l_n{loops}");
                let step = if (*loops).is_multiple_of(2) { "" } else { " step 0.5" };
                writeln!(text, "for {counter}=0 to {to}{step}").unwrap();
                write(body, loops, text);
                text.push_str("endFor\n");
            }
            Statement::While(body) => {
                *loops += 1;
                let counter = format!("l_n{loops}");
                writeln!(text, "{counter}=0\nwhile {counter}<5\n{counter}={counter}+1").unwrap();
                write(body, loops, text);
                text.push_str("endWhile\n");
            }
            Statement::Call(name, given, result) => writeln!(text, "call {name}({given},{result})").unwrap(),
            Statement::Count(count) => writeln!(text, "{count}").unwrap(),
            Statement::Print(value) => writeln!(text, "? {value}").unwrap(),
            Statement::Leave(on) => writeln!(text, "if {on}\nnY=nY+1\nreturn\nendIf").unwrap(),
        }
    }
}

/// Creates an application whose program `work` consists of the statements.
fn application(statements: &[Statement]) -> String {
    let (mut body, mut loops) = (String::new(), 0);
    write(statements, &mut loops, &mut body);
    let counters: String = (1..=loops).fold(String::new(), |text, number| text + &format!("num l_n{number}\n"));
    format!(
        "num nX\nnum nY\nnum nA[6]\nnum nG[3,4]\nbool bSeen[6]\nnum nLong[300]\nbool bLong[300]\nnum nFills\n\
         program twice(num x_nGiven, num& x_nResult)\nbegin\nif x_nGiven>100\nreturn\nendIf\n\
         x_nResult=x_nGiven*2+x_nResult\nnX=x_nResult\nend\n\
         program both(num x_nGiven, num& x_nResult)\nnum l_nHalf\nbegin\ncall twice(x_nGiven/2,l_nHalf)\n\
         call twice(l_nHalf,x_nResult)\nx_nGiven=nX+l_nHalf\ncall twice(x_nGiven,nY)\nend\n\
         program down(num x_nGiven, num& x_nResult)\nnum l_nLess\nbegin\nif !(x_nGiven>0.5)\nx_nResult=x_nResult+1\nreturn\nendIf\n\
         if x_nGiven>10\nx_nGiven=10\nendIf\ncall down(x_nGiven-1,l_nLess)\ncall down(x_nGiven-4,x_nResult)\n\
         x_nResult=x_nResult+l_nLess\nend\n\
         program work(num x_nRound, num& x_nDone)\nnum l_nI\nnum l_nJ\nnum l_nK\nnum l_nU\nnum l_nV\nbool l_bIs\nnum l_nB[6]\n{counters}begin\n\
         l_nI=x_nRound%4\nl_nJ=3\nx_nDone=x_nDone+1\n{body}end\n\
         program rounds()\nnum l_nRound\nnum l_nDone\nbegin\nfor l_nRound=1 to 40\ncall work(l_nRound,l_nDone)\nendFor\n\
         ? nX\n? nY\n? l_nDone\n? nA[1]\n? nG[1,1]\nend\n\
         program start()\nbegin\ncall rounds()\nend\n"
    )
}

/// Creates a synchronous and two asynchronous tasks in an [`application`].
fn with_tasks(application: &str) -> String {
    application.replace(
        "begin\ncall rounds()\nend\n",
        "begin\ntaskCreate \"a\",3,rounds()\ntaskCreate \"b\",10,rounds()\ntaskCreateSync \"s\",0.004,bOverrun,tick()\nend\n\
         program tick()\nbegin\nwhile nTicks<9\nnTicks=nTicks+1\n? nX+power(nTicks,2)\ndelay(0)\nendWhile\nend\n",
    ) + "bool bOverrun\nnum nTicks\n"
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// A cycle that ends within a turn interrupts it between two lines, and the next cycle resumes it. A program that
    /// does not read the clock therefore has the same results for all line durations.
    #[test]
    fn results_do_not_depend_on_where_cycles_end(statements in statements(), line_cost in 20_000_u64..400_000) {
        let listing = application(&statements);
        prop_assert_eq!(run_at(&listing, LINE_COST), run_at(&listing, line_cost));
    }

    /// A suspended cycle resumes where it stopped: the events are the same as without a stop.
    #[test]
    fn suspended_cycles_resume(
        statements in statements(),
        line_cost in 2_000_u64..400_000,
        stops in prop::collection::vec((1_u64..2_000_000, any::<bool>()), 1..40),
    ) {
        let image = Arc::new(image(&with_tasks(&application(&statements))));
        let whole = events(&image, line_cost);
        let mut stops = stops.into_iter().cycle();
        let mut controller = started(&image, line_cost);
        let mut resumed = Vec::new();
        loop {
            let (time, is_interrupted) = stops.next().unwrap();
            controller.set_limit(Some(controller.now() + time));
            controller.devices.interrupt.store(is_interrupted, Relaxed);
            let status = controller.step();
            resumed.append(&mut controller.devices.take_events());
            match status {
                RunStatus::Waiting(Some(wake)) => controller.jump(wake),
                status if status.is_final() => break,
                _ => {}
            }
        }
        prop_assert_eq!(resumed, whole);
    }

    /// Counters change neither an application's events nor their times.
    #[test]
    fn counted_programs_have_the_same_events(statements in statements(), line_cost in 2_000_u64..400_000) {
        let listing = with_tasks(&application(&statements));
        let counted = record(&events(&Arc::new(counted_image(&listing)), line_cost));
        prop_assert_eq!(counted, record(&events(&Arc::new(image(&listing)), line_cost)));
    }

    /// A controller that is restored to a snapshot, taken anywhere in a cycle, repeats its events exactly.
    #[test]
    fn restored_controllers_repeat_their_events(
        statements in statements(),
        line_cost in 2_000_u64..400_000,
        time in 1_u64..60_000_000,
    ) {
        let mut controller = started(&Arc::new(image(&with_tasks(&application(&statements)))), line_cost);
        controller.set_limit(Some(time));
        while controller.now() < time && !controller.step().is_final() {}
        controller.devices.take_events();
        controller.set_limit(None);
        let snapshot = controller.snapshot();
        let first = record(&rest(&mut controller));
        controller.restore(&snapshot);
        prop_assert_eq!(record(&rest(&mut controller)), first);
    }
}

/// Formats events as in the record of a run.
fn record(events: &[Event]) -> String {
    events.iter().map(|event| serde_json::to_string(event).unwrap() + "\n").collect()
}
